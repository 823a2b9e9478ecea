// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"

namespace voussoir::cases {

/// Puts the holes of openings and lintels into the walls of a plan whose walls stand, ascending along each wall, and lays out the courses.
/// \throw InputError with the key at fault: an opening outside its wall, over another, one too near to another's level, or one that leaves
/// a piece of wall shorter than half a brick; then the message gives the nearest place where it fits.
void plan_openings(const House& house, HousePlan& plan);

/// Openings with courses, a gable or a wall of the next storey above them that neither a lintel nor an arch carries: built so, these bricks
/// fall, or hang by the mortar. (Over half a brick's length the courses carry themselves.) Keyed at house.opening[i].
std::vector<InputError> unsupported_heads(const House& house);

}  // namespace voussoir::cases
