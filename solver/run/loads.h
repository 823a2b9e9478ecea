// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/run/ledger.h"
#include "solver/world/world.h"

/// Loads on single elements: dead loads keep their direction, followers rotate with their element.
namespace voussoir::solver {

/// Adds the wrenches of all loads to the rows, and their work over the last step to the ledger.
/// \param before  force and moment of each load at the last step; kept up to date
/// \param t  time of the ramps [s] \param factor  of the loads that grow \param first  whether this is the first step
void apply_loads(World& w, Ledger& ledger, std::vector<Vec3>& before, double t, double factor, bool first);

/// Power of the growing loads at a factor of 1, with the velocities of the last half step [W].
double power_of_growing_loads(const World& w);

}  // namespace voussoir::solver
