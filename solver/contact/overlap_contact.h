// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernels/contact/overlap.h"
#include "solver/world/world.h"

/// Contact of whole bodies by their exact overlap (THEORY.md (21a)): pairs that may overlap, and forces of those that do.
namespace voussoir::solver {

/// A pair with more than the allowed overlap.
struct OverlapFound {
  std::size_t pair = 0;  // index into Overlaps::pairs
  kernels::Overlap at;
};

/// Overlap of two elements without a force [m].
[[nodiscard]] double allowed_overlap(const World& w, std::int32_t a, std::int32_t b);

/// Overlap of two elements in their current poses; b may be the base. \param enough  see kernels::overlap_of
[[nodiscard]] kernels::Overlap overlap_of(const World& w, std::int32_t a, std::int32_t b, double enough);

/// Lists pairs of a searched element in its current pose with its neighbours that are not searched or come after it, and with the base.
/// \pre SearchRoom::box has all elements in their current poses
/// \param near  elements whose boxes are within the search distance
/// \param gap_of  m, by neighbour: by how much the two may come nearer before one of them is listed again
using GapOf = std::function<double(std::int32_t other)>;
void list_overlaps_of(const World& w, std::int32_t element, std::span<const std::int32_t> near, const GapOf& gap_of,
                      std::vector<OverlapPair>& pairs);

/// Replaces the pairs of searched elements by those that the search has listed (SearchRoom). Other pairs are kept.
void replace_overlap_pairs(World& w);

/// To be called after a state has been read: activates the batches of its pairs and, with several rates, sorts the pairs by level.
void use_restored_overlap_pairs(World& w);

/// Sorts pairs by level for multi-rate stepping. To be called when pairs or levels have changed.
void list_overlap_levels(World& w);

/// Pairs due in this step. \param due  number of their levels, from level 0 on
[[nodiscard]] DueNumbers overlaps_due(const World& w, int due);
/// Tests those of them whose bodies have moved far enough to overlap. To be called by the threads of a team; threads may return before all
/// is done. \param tickets  of as many as are due
void find_overlaps(World& w, int due, Tickets& tickets, std::vector<OverlapFound>& found);

/// Adds the forces of all found pairs to the rows of elements, pair by pair, and sums the losses of springs. To be called by one thread.
void apply_overlaps(World& w, int due, std::vector<OverlapFound>& found);

}  // namespace voussoir::solver
