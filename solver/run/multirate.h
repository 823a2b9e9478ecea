// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "solver/world/world.h"

/// What multi-rate stepping (solver/world/multirate.h, THEORY.md (24a)) adds to the step.
namespace voussoir::solver {

/// From now on cycles are as long as the case wants them; slow pairs see the velocities of now until the first cycle is over.
/// \pre  the next step is number 0
void start_cycles(World& w);

/// Adds to the forces on each element those of slow pairs, with the impulse of so many steps, and clears their rows.
void add_slow_impulses(World& w, double steps);

/// Adds the velocities of rows [first, last) to the sums over this cycle, or takes their means, if the step was its last.
/// \param step  that has just been done
void sum_velocities(World& w, std::int64_t step, std::int64_t first, std::int64_t last);

}  // namespace voussoir::solver
