// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/side_lanes.h"

namespace voussoir::kernels {

/// The chosen lanes of a group of kWidth sides, segment by segment. Puts their sums of tractions into `sums` (other lanes keep theirs) and
/// adds their dashpots' share to the rows. `k` has its mean normal of length 1 but for lanes that are far turned: it is made so.
/// \param parts, result  of the group
void advance_damaged(const SideBlock& block, int at, unsigned chosen, const SideParts* parts, Kinematics& k, const Rows& rows,
                     StepClock clock, FailureOptions o, SumLanes& sums, DamagedSide* result, EventSink& sink) noexcept;

}  // namespace voussoir::kernels
