// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cases/model.h"

/// Units that fail: a unit (a brick of a wall, a block) is divided into cells. Each cell is an element, and joints between cells of one
/// unit have the law `inside` of its material. Internal to cases/.
namespace voussoir::cases {

/// Checks the keys `halves` and `cells` of a unit. \param key  of its table \throw InputError
void check_cells(bool halves, const std::optional<CellCounts>& cells, const std::string& key);

/// Sets the cells of `halves = true`: two, cut across the middle of the longer horizontal edge, of equal ones that along x.
/// \pre the block is an axis-aligned box
void set_halves(Block& block);

/// Replaces every block that has several cells (Block::cells) by these: along the first edge fastest, along the third slowest. An
/// axis-aligned box counts its edges along x, y, z. They have the names unit/1, unit/2, … of a named unit. Blocks with several cells are
/// hexahedra in VTK's order. \param units  number of units so far; counted on
void divide_units(std::vector<Block>& blocks, std::int32_t& units);

}  // namespace voussoir::cases
