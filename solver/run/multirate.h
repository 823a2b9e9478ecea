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

/// Finds the levels of elements for their contacts anew: that of its joints as long as one holds it, else its own, and graded among
/// elements that are joined or that the search has listed. For use in first steps of cycles, when contacts have been searched.
void renew_contact_levels(World& w);

/// Then: finds for each batch of elements the level at which it is moved on, the lowest of its pairs. \pre gather lists are up to date
void renew_moves(World& w);

/// Adds to the forces on each element those of pairs of higher levels that were evaluated in this step, so that in the time by which the
/// element is moved on they have the impulse of all their steps. Clears their rows.
void add_impulses(World& w, std::int64_t step);

/// Adds the velocities of a batch, rows [first, last), to the sums of each level, or takes the means of one that is evaluated before the
/// batch is moved on again.
/// \param step  that has just been done
void sum_velocities(World& w, std::int64_t step, std::int64_t first, std::int64_t last);

}  // namespace voussoir::solver
