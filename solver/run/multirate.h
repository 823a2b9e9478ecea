// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "solver/world/world.h"

/// Parts of the step for multi-rate stepping (solver/world/multirate.h, THEORY.md (24a)).
namespace voussoir::solver {

/// Sets the length of cycles to that of the case; slow pairs use the current velocities until the first cycle has ended.
/// \pre the next step is number 0
void start_cycles(World& w);

/// Determines the levels of elements for contacts: that of an element's joints while any of them holds, else its own level, graded among
/// elements that are joined or that the search has listed. For use in first steps of cycles, after contacts have been searched.
void renew_contact_levels(World& w);

/// Determines for each batch of elements the level of its moves, the lowest of its pairs. To be called after renew_contact_levels(). \pre
/// gather lists are up to date
void renew_moves(World& w);

/// Adds to the forces on each element those of pairs of higher levels that were evaluated in this step, scaled so that they act with the
/// impulse of all their steps over the time of the element's move. Clears their rows.
void add_impulses(World& w, std::int64_t step);

/// Adds the velocities of a batch, rows [first, last), to the sums of each level, or computes the means of a level that is evaluated before
/// the batch moves again.
/// \param step  the step just done
void sum_velocities(World& w, std::int64_t step, std::int64_t first, std::int64_t last);

}  // namespace voussoir::solver
