// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "cases/walls/wall_plan.h"
#include "geometry/polyhedron.h"

/// The bricks of a course in plan. Internal to cases/.
///
/// Between two places where a leg meets others lies a field with a grid of head joints of its own, fitted to the field: the planes of the
/// other leg's faces, at which the leg ends in every second course, lie in the middle of a brick in the courses between. So no upright
/// joint goes on from course to course, at corners neither.
namespace voussoir::cases {

/// A brick in plan: a convex quadrangle, counter-clockwise seen from above.
struct PlanBrick {
  std::array<Vec3, 4> corners;                // m, z = 0
  bool whole = false;                         // not cut
  Interval height;                            // above the base
  std::optional<geometry::Polyhedron> shape;  // of one that is cut along its top; none: an upright prism
  double share = 1.0;                         // of a whole one's section, if it is cut along its top
  double length = 0.0;                        // m, of a whole one there, along the wall
};

/// A prism across a straight leg. \param section  along the leg and height [m], counter-clockwise \param from, to  range of d
geometry::Polyhedron across(const Leg& leg, const geometry::Polygon& section, double from, double to);

/// An upright prism over a convex quadrangle, counter-clockwise seen from above.
geometry::Polyhedron upright(const std::array<Vec3, 4>& plan, Interval height);

/// The bricks of a leg in a course. \param course  index into the courses of its group
std::vector<PlanBrick> lay_wall_course(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, int course);

/// The greatest and the least length of a whole brick along the wall, over that of the wall's brick.
std::array<double, 2> brick_stretch(const WallSpec& wall, const WallsPlan& plan, const Leg& leg);

/// Share of the volume along a leg's line that its straight blocks over bends leave out, mean of an even and an odd course; 0: no bends.
double lost_in_bends(const WallSpec& wall, const WallsPlan& plan, const Leg& leg);

/// \throw InputError or InputErrors: pieces of wall shorter than a fifth of a brick, bends too sharp for the thickness
void check_layout(const std::vector<WallSpec>& walls, const WallsPlan& plan);

}  // namespace voussoir::cases
