// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"

/// Walls between outer walls, and piers at them. Internal to cases/.
namespace voussoir::cases {

/// Adds the inner walls of a storey, whose outer walls are there, to the plan.
/// \throw InputError with the key at fault: a name twice, a storey that there is not, a wall outside the room or too near to another.
void plan_inner_walls(const House& house, int storey, HousePlan& plan);

/// Adds the piers to the plan whose walls are there: a short wall in each storey that a pier reaches, toothed into the wall at which it
/// stands: it runs through that wall where another wall there would.
/// \throw InputError with the key at fault: a wall that is not built, a pier at a corner, at an inner wall or at another pier.
void plan_piers(const House& house, HousePlan& plan);

}  // namespace voussoir::cases
