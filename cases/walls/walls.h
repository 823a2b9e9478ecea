// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/input_error.h"
#include "cases/model.h"
#include "cases/walls/wall_case.h"
#include "cases/walls/wall_plan.h"

namespace voussoir::cases {

/// Checks the names of all materials, and the loads of floors. \throw InputError, or InputErrors with all that is at fault
void check_wall_materials(const std::vector<WallSpec>& walls, const WallSpans& spans, std::span<const NamedMaterial> materials);

/// Turns [[wall]] into blocks: bricks in bond with toothed corners, lintels, arches; behind them the beams of [[floor]], the rafters of
/// [[roof]] and the rings of [[vault]]. The base is z = 0. Blocks come wall by wall, course by course, the lintels and arches of each side
/// behind its bricks. Block::wall counts the walls, Block::span floors and roofs, Block::vault vaults. \param plan  of plan_walls() \param
/// materials  Model::materials with those of loaded_wall_materials() \pre check_wall_materials() finds no fault \throw InputError
std::vector<Block> blocks_of_walls(const std::vector<WallSpec>& walls, const WallSpans& spans, const WallsPlan& plan,
                                   std::span<const NamedMaterial> materials);

/// Materials of the top courses of walls with a load: that of the wall, with the mass of the load added to its density; likewise of the
/// beams of floors with a load, and of rafters and vaults under a surcharge. \param plan  of plan_walls() \pre check_wall_materials() finds
/// no fault \throw InputError
std::vector<NamedMaterial> loaded_wall_materials(const std::vector<WallSpec>& walls, const WallSpans& spans, const WallsPlan& plan,
                                                 std::span<const NamedMaterial> materials);

/// A wall whose bricks are adapted to its dimensions. \pre blocks_of_walls() finds no fault
struct AdaptedBricks {
  std::string name;
  double shortest = 0.0, longest = 0.0;  // m, of whole bricks along it
  double width = 0.0;                    // m
  double lowest = 0.0, highest = 0.0;    // m, of its courses
  double lost = 0.0;                     // share of the volume of its line that straight blocks over bends leave out
};
/// One for each wall of which any of these differs from the brick of the case.
std::vector<AdaptedBricks> adapted_bricks(const std::vector<WallSpec>& walls, const WallSpans& spans = {});

/// Openings with masonry above them and nothing that carries it. \pre as above
std::vector<InputError> wall_heads_without_lintel(const std::vector<WallSpec>& walls);

/// Walls that stand upon others and reach beyond them with a face, by a tenth of a brick's width or more over half of their length.
/// \pre as above
std::vector<InputError> wall_overhangs(const std::vector<WallSpec>& walls, const WallSpans& spans);

}  // namespace voussoir::cases
