// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/side_lanes.h"

namespace voussoir::kernels {

/// The chosen lanes of a group of kWidth sides, segment by segment. Puts their sums of tractions into `sums` (other lanes keep theirs) and
/// hands out their dashpots' share. `k` has its mean normal of length 1 but for lanes that are far turned: it is made so.
/// \param result  of the group
/// \return bit mask of the lanes with dashpots that act
unsigned advance_damaged(const SideBlock& block, int at, unsigned chosen, const BlockState& state, Kinematics& k, const Rows& rows,
                         StepClock clock, FailureOptions o, SumLanes& sums, DamagedSide* result, EventSink& sink) noexcept;

}  // namespace voussoir::kernels
