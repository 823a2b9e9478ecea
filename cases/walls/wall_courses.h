// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/walls/wall_plan.h"

/// Openings and heights of courses. Internal to cases/.
namespace voussoir::cases {

/// Sets Leg::holes. \throw InputError or InputErrors with the key at fault: beyond the wall, over a corner or where walls meet
void add_wall_openings(const std::vector<WallSpec>& walls, WallsPlan& plan);

/// What is in the way of a beam's end in a leg, or nearer to it than a fifth of a brick: where walls meet, openings, free ends.
/// \return in words; nothing: it fits
std::optional<std::string> in_the_way_of(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, const Pocket& pocket);

/// Sets WallsPlan::courses: walls that meet have the same. Between two levels (foot, top, sill, head, top of a lintel, beams) lie equal
/// courses, as high as a brick or up to a third higher or lower; two levels nearer than two thirds of a brick have one low course between
/// them. \throw InputError or InputErrors: bricks of other height, two levels within a fifth of a brick
void plan_wall_courses(const std::vector<WallSpec>& walls, const std::vector<WallFloor>& floors, WallsPlan& plan);

}  // namespace voussoir::cases
