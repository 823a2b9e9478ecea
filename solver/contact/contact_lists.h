// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// The lists that a search leaves: which patches have candidates, a slot for each pair, and who gathers from which slots.
namespace voussoir::solver {

/// Puts what was found (SearchRoom) in the place of what was there before. Patches lie in the order of their numbers; the candidates of one
/// are those that stayed, then those found: its own in the order in which they were, others in the order of the elements searched again.
/// Points whose partner is no candidate any more are free.
void replace_candidates(World& w);

/// An element that a patch may touch, as new.
[[nodiscard]] kernels::Candidate candidate_of(const World& w, std::int32_t element);

/// Candidates of all slots as new: nothing is known of any pair. Also for whoever moves a body otherwise than by its velocity.
void list_candidates(World& w);

/// Lists for every element the slots that push it. Due where Contacts::gather_stale says so.
void build_gather(World& w);

/// The same for the slot of an active patch that was appended, and has no other, if there is room; else the lists are stale.
void add_to_gather(World& w);

}  // namespace voussoir::solver
