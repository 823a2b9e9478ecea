// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cases/house/house_plan.h"

/// Heights at which beams may lie between two walls. Internal to cases/.
namespace voussoir::cases {

/// Levels of the upper faces of beams that lie at the foot of a wall, in it, flush with its top, or upon it, for both of two walls, as
/// ascending ranges. \param stands  the heights of the two \param height  of the beams \param lowest  course
std::vector<Interval> beam_levels(const std::array<Interval, 2>& stands, Tick height, Tick lowest);

/// Where beams whose upper faces are at a level may end below, likewise.
std::vector<Interval> beam_undersides(const std::array<Interval, 2>& stands, Tick level, Tick lowest);

/// "0.2 m; 0.26 to 2.4 m".
std::string ranges_text(const std::vector<Interval>& ranges);

}  // namespace voussoir::cases
