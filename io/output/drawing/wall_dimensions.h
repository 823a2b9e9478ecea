// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/walls/wall_outlines.h"
#include "io/output/drawing/dimensions.h"

/// Dimensions of walls of any plan ([[wall]]). Heights are above the base of the case.
namespace voussoir::io {

/// Heights of the plans of a drawing [m], ascending: each through as many openings as possible that no other one meets, until all are
/// shown or there are `most`; without openings the middle of the lowest walls.
std::vector<double> plan_heights(const std::vector<cases::WallOutline>& walls, std::size_t most);

/// Draws for each wall at this height its name and thickness, and beside its outer face the lengths along its line from corner to opening
/// to opening to corner, as the case gives them; of a wall round bends its name alone. \param base  m, base.z
void draw_wall_plan(Svg& svg, const std::vector<cases::WallOutline>& walls, double base, double height, const Projection& at);

/// A direction of view: unit vectors of the model that point right and into the picture.
struct Sight {
  Vec3 right, into;
};

/// Draws width, height and sill of each opening that no other wall hides, of the walls that are square to the view.
void draw_wall_openings(Svg& svg, const std::vector<cases::WallOutline>& walls, double base, const Sight& sight, const Projection& at);

}  // namespace voussoir::io
