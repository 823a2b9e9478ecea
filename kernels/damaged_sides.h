// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/side_lanes.h"

namespace voussoir::kernels {

/// Advances the chosen lanes of a group of kWidth sides, segment by segment. Writes their sums of tractions into `sums` (other lanes are
/// unchanged) and adds the dashpot forces to the elements' rows. `k`: the mean normal has length 1 except in lanes turned far, where it is
/// normalised here.
/// \param result  of the group
void advance_damaged(const SideBlock& block, int at, unsigned chosen, const BlockState& state, Kinematics& k, const Rows& rows,
                     StepClock clock, FailureOptions o, SumLanes& sums, DamagedSide* result, EventSink& sink) noexcept;

}  // namespace voussoir::kernels
