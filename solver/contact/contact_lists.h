// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// Lists made from a search: patches with candidates, a slot for each pair, and the slots that each element gathers.
namespace voussoir::solver {

/// Replaces the candidates by those found (SearchRoom). Patches are in the order of their numbers; the candidates of a patch are the kept
/// ones, then those found: in its own search in order of discovery, others in the order of the searched elements. Points whose partner is
/// no longer a candidate become free.
void replace_candidates(World& w);

/// A new candidate, for an element that a patch may touch.
[[nodiscard]] kernels::Candidate candidate_of(const World& w, std::int32_t element);

/// Resets the candidates of all slots: nothing is known of any pair. Also for use after a body was moved other than by its velocity.
void list_candidates(World& w);

/// Builds for every element the list of slots with its forces. Due in a step that evaluates Contacts::stale_level.
void build_gather(World& w);

/// Adds the slot of an active patch that was appended, and has no other slot, to the gather lists if there is space; else marks the lists
/// as stale.
void add_to_gather(World& w);

}  // namespace voussoir::solver
