// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "kernels/overlap.h"
#include "solver/world/world.h"

/// Contact of whole bodies by their exact overlap (THEORY.md (21a)): which pairs may need it, and the forces of those that do.
namespace voussoir::solver {

/// A pair that overlaps by more than is allowed.
struct OverlapFound {
  std::size_t pair = 0;  // into Overlaps::pairs
  kernels::Overlap at;
};

/// m, by which the two may overlap without a force.
[[nodiscard]] double allowed_overlap(const World& w, std::int32_t a, std::int32_t b);

/// Of two elements as they stand; b may be the base. \param enough  see kernels::overlap_of
[[nodiscard]] kernels::Overlap overlap_of(const World& w, std::int32_t a, std::int32_t b, double enough);

/// Lists the pairs of elements that are marked, as they stand; others keep theirs. Call with every search.
/// \pre Contacts::grid holds all elements where they were searched last
/// \param re_search   by element: its pairs are listed again
/// \param moved  m, that elements which are not marked have moved at most since they were searched
void list_overlap_pairs(World& w, const std::vector<std::uint8_t>& re_search, double moved);

/// Lists all pairs, whenever elements were searched: for a state that was read.
void list_all_overlap_pairs(World& w);

/// Of multi-rate stepping: sorts pairs by level. Call when they, or levels, are others.
void list_overlap_levels(World& w);

/// Looks at pairs whose bodies have gone far enough to overlap. To be called by every thread of a team; they may leave before all is done.
/// \param due  levels of pairs whose turn it is, from 0 on (solver/world/multirate.h)
void find_overlaps(World& w, int due, std::vector<OverlapFound>& found);

/// Adds the forces of all that was found to the rows of elements, pair by pair, and adds up what springs lose. To be called by one thread.
void apply_overlaps(World& w, int due, std::vector<OverlapFound>& found);

}  // namespace voussoir::solver
