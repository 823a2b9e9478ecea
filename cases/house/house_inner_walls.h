// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"

/// Walls between outer walls, and piers at them. Internal to cases/.
namespace voussoir::cases {

/// Adds the inner walls of a storey to the plan. \pre the outer walls of the storey are planned
/// \throw InputError with the key at fault: a duplicate name, a storey that does not exist, a wall outside the room or too near to another.
void plan_inner_walls(const House& house, int storey, HousePlan& plan);

/// Adds the piers to the plan: in each storey that a pier reaches, a short wall toothed into the wall at which the pier stands; the pier
/// runs through that wall as a crossing wall would. \pre the walls are planned
/// \throw InputError with the key at fault: a wall that is not built, a pier at a corner, at an inner wall or at another pier.
void plan_piers(const House& house, HousePlan& plan);

}  // namespace voussoir::cases
