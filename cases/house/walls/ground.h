// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/house/house_plan.h"

/// Walls that begin upon higher ground. Internal to cases/.
namespace voussoir::cases {

/// Adds to the walls of the first storey, and to piers, the holes in which ground stands (House::ground), all through their thickness.
/// \throw InputError with the key at fault: a part as high as the storey, one that ends within the thickness of a wall, one that no wall
/// stands on.
void add_ground_holes(const House& house, HousePlan& plan);

/// The key that makes a hole: "house.opening[1].lintel", "base.part[0]".
std::string hole_key(const Hole& hole);

}  // namespace voussoir::cases
