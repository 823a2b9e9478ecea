// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "solver/run/ledger.h"
#include "solver/run/recorder.h"
#include "solver/world/world.h"

/// Loads on single elements: dead loads keep their direction, followers rotate with their element.
namespace voussoir::solver {

/// Adds the wrenches of all loads to the rows of the elements that are moved on in this step, and their work over the last step to the
/// ledger. At several rates a load acts with the impulse of all steps by which its element moves, as gravity does: an element at rest
/// under a load on joints of that level then has no velocity.
/// \param before  force and moment of each load at the last step; kept up to date
/// \param t  time of the ramps [s] \param factor  of the loads that grow
void apply_loads(World& w, Ledger& ledger, std::vector<Vec3>& before, std::int64_t step, double t, double factor);

/// m, of the place where each load acts, since the start of the run.
std::vector<Vec3> places_of_loads(const World& w);

/// What each [[load]] does at time t [s], by its number. \param start  places_of_loads() at time zero \param factor  of the loads that grow
std::vector<LoadSample> load_samples(const World& w, const std::vector<Vec3>& start, double t, double factor);

/// Power of the growing loads at a factor of 1, with the velocities of the last half step [W].
double power_of_growing_loads(const World& w);

}  // namespace voussoir::solver
