// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "cases/model.h"

/// Units that can crack at mid-length, as in micro-models of shear walls: a unit is two elements, and the joint between the two has the law
/// `inside` of its material. Internal to cases/.
namespace voussoir::cases {

/// Cuts a block across the middle of its longer horizontal edge. The halves are cut pieces and share `unit`.
/// \pre the block is an axis-aligned box and not in another unit
std::array<Block, 2> in_halves(const Block& whole, std::int32_t unit);

/// Cuts all whole bricks of a house.
void halve_bricks(std::vector<Block>& blocks);

}  // namespace voussoir::cases
