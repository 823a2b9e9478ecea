// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/walls/wall_legs.h"

/// Where walls meet: corners, T-junctions, crossings. Internal to cases/.
namespace voussoir::cases {

/// Sets meetings, stations and groups. A free end that lies in another wall ends there; walls that reach through each other cross.
/// \throw InputError or InputErrors at the points of the later wall: an angle below 30 degrees, walls that overlap in part
void find_meetings(const std::vector<WallSpec>& walls, const std::vector<Corner>& corners, WallsPlan& plan);

/// Least and greatest distance between two cuts in a leg, from `a` to `b` along it [m].
double shorter_side(const LegCut& a, const LegCut& b, double half) noexcept;
double longer_side(const LegCut& a, const LegCut& b, double half) noexcept;

}  // namespace voussoir::cases
