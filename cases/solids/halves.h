// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "cases/model.h"

/// Units that can crack at mid-length, as in micro-models of shear walls: a unit is two elements, and the joint between them has the law of
/// its material's inside. Internal to cases/.
namespace voussoir::cases {

/// Cuts a block across the middle of its longer horizontal edge, the length. The halves are cut pieces and share `unit`.
/// \pre the block is a box along the axes, alone in its unit
std::array<Block, 2> in_halves(const Block& whole, std::int32_t unit);

/// Cuts all whole bricks of a house.
void halve_bricks(std::vector<Block>& blocks);

}  // namespace voussoir::cases
