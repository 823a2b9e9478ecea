// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"

namespace voussoir::cases {

/// Puts the holes of openings and lintels into the walls of a plan whose walls stand, ascending along each wall, and lays out the courses.
/// \throw InputError with the key at fault: an opening outside its wall, over another, one too near to another's level, or one that leaves
/// a piece of wall shorter than half a brick; then the message gives the nearest place where it fits.
void plan_openings(const House& house, HousePlan& plan);

}  // namespace voussoir::cases
