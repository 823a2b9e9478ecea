// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/house/house_plan.h"

/// Walls that begin on higher ground. Internal to cases/.
namespace voussoir::cases {

/// Adds the holes filled by ground (House::ground) to the walls of the first storey and to piers, through their whole thickness.
/// \throw InputError with the key at fault: a part as high as the storey, a part that ends within the thickness of a wall, a part under no
/// wall.
void add_ground_holes(const House& house, HousePlan& plan);

/// The key that causes a hole: "house.opening[1].lintel", "base.part[0]".
std::string hole_key(const Hole& hole);

}  // namespace voussoir::cases
