// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/walls/wall_plan.h"

/// From polylines to legs. Internal to cases/.
namespace voussoir::cases {

/// A corner of one wall: the leg that ends there and the leg that begins there.
struct Corner {
  std::size_t before = 0, behind = 0;  // legs
  std::size_t number = 0;              // of the point, from 0
};

/// Adds the legs of a wall, and its corners. A closed wall without corners is one leg, a ring.
/// \throw InputError or InputErrors: points too near, angles that are no corners, sizes out of range
void add_legs(const WallSpec& wall, std::size_t index, WallsPlan& plan, std::vector<Corner>& corners);

}  // namespace voussoir::cases
