// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/house/house_ties.h"
#include "cases/walls/wall_plan.h"

/// Rods by wall and height, as those of houses, in walls of any plan. Internal to cases/.
namespace voussoir::cases {

/// The rods of `ties`; PlannedTie::index is the tie. Their walls are sides, named as those of floors.
///
/// along: through each side from end to end, so that plates press on the outer faces of the walls in which it ends; across: from the outer
/// face of the first side to that of the second, square to the first. \param foot  m, height of the base \throw InputError or InputErrors
/// with the key at fault
std::vector<PlannedTie> wall_rods(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<HouseTie>& ties,
                                  double foot);

}  // namespace voussoir::cases
