// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "solver/world/world.h"

/// The lists that a search leaves: which patches have candidates, a slot for each pair, and who gathers from which slots.
namespace voussoir::solver {

/// What is searched again: all pairs of the elements and all of the patches that are marked. Those of others stay as they are.
struct ReSearch {
  std::vector<std::uint8_t> element, patch;  // by element (and the base), by patch; a marked element's patches are marked too
};

/// Pairs that a search found, patch by patch.
struct Found {
  std::vector<std::int32_t> patch;
  std::vector<std::int32_t> element;
  std::vector<double> gap;  // m, that one face of the element keeps from the whole patch
};

/// Puts what was found in the place of what was there before. Patches lie in the order of their numbers; the candidates of one are
/// those that stayed, then those found, in the order of `found`. Points whose partner is no candidate any more are free.
void replace_candidates(World& w, const ReSearch& re_search, std::span<const Found> found);

/// An element that a patch may touch, as new.
[[nodiscard]] kernels::Candidate candidate_of(const World& w, std::int32_t element);

/// Candidates of all slots as new: nothing is known of any pair. Also for whoever moves a body otherwise than by its velocity.
void list_candidates(World& w);

/// Lists for every element the slots that push it. Due in a step that evaluates Contacts::stale_level.
void build_gather(World& w);

}  // namespace voussoir::solver
