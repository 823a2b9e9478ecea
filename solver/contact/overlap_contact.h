// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernels/contact/overlap.h"
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

/// Lists pairs of an element that is searched again, as it stands, with those of its neighbours that are not, or come after it, and the
/// base.
/// \pre SearchRoom::box holds all elements as they stand
/// \param near    elements whose boxes are that near, or nearer
/// \param travel  m, of both together before one of them is listed again
void list_overlaps_of(const World& w, std::int32_t element, std::span<const std::int32_t> near, double travel,
                      std::vector<OverlapPair>& pairs);

/// Puts those that a search has listed (SearchRoom) in the place of those of the elements that it searched again. Others keep theirs.
void replace_overlap_pairs(World& w);

/// After a state has been read: activates the batches of its pairs and, at several rates, sorts the pairs by level.
void use_restored_overlap_pairs(World& w);

/// Of multi-rate stepping: sorts pairs by level. Call when they, or levels, are others.
void list_overlap_levels(World& w);

/// Looks at pairs whose bodies have gone far enough to overlap. To be called by every thread of a team; they may leave before all is done.
/// \param due  levels of pairs whose turn it is, from 0 on (solver/world/multirate.h)
void find_overlaps(World& w, int due, std::vector<OverlapFound>& found);

/// Adds the forces of all that was found to the rows of elements, pair by pair, and adds up what springs lose. To be called by one thread.
void apply_overlaps(World& w, int due, std::vector<OverlapFound>& found);

}  // namespace voussoir::solver
