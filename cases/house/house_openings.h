// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"
#include "cases/input_error.h"

namespace voussoir::cases {

/// Adds the holes of openings and lintels to the walls of a plan, ascending along each wall, and lays out the courses. \pre the walls are
/// planned
/// \throw InputError with the key at fault: an opening outside its wall, overlapping another, too near to another's level, or leaving a
/// piece of wall shorter than half a brick; in the last case the message gives the nearest place where the opening fits.
void plan_openings(const House& house, HousePlan& plan);

/// Findings for openings with courses, a gable or a wall of the next storey above that neither a lintel nor an arch carries: these bricks
/// fall, or hang by the mortar. (Over half a brick's length the courses carry themselves.) Keyed at house.opening[i].
std::vector<InputError> unsupported_heads(const House& house);

}  // namespace voussoir::cases
