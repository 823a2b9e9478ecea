// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/nth.h"
#include "geometry/polyhedron.h"
#include "kernels/contact/contact_patch.h"
#include "solver/world/array.h"

namespace voussoir::solver {

/// Scope of a search: all pairs of the marked elements and of the marked patches. Other pairs are kept.
struct ReSearch {
  std::vector<std::uint8_t> element, patch;  // by element (and the base), by patch; patches of a marked element are marked too
};

/// Patches of every element, in ascending order.
struct PatchesOfElements {
  std::vector<std::int32_t> first, list;
  [[nodiscard]] auto begin_of(std::int32_t e) const { return list.begin() + nth(first, e); }
  [[nodiscard]] auto end_of(std::int32_t e) const { return list.begin() + first[static_cast<std::size_t>(e) + 1]; }
};

/// Two elements that may overlap by more than contact points can detect.
struct OverlapPair {
  std::int32_t a = 0, b = 0;        // a < b; b may be the base
  double safe = kernels::kLookNow;  // m, sum of both travel bounds up to which the overlap stays within the allowed one
};

/// Pairs of a patch and an element found by one thread, run by run.
struct FoundPairs {
  std::vector<std::int32_t> patch;
  std::vector<std::int32_t> rank;  // rank among the future candidates of the patch
  std::vector<kernels::Candidate> candidate;
  [[nodiscard]] std::size_t size() const noexcept { return patch.size(); }
  void clear() { patch.clear(), rank.clear(), candidate.clear(); }
  void add(std::int32_t p, std::int32_t r, const kernels::Candidate& c) { patch.push_back(p), rank.push_back(r), candidate.push_back(c); }
};

/// Results of one thread in a search.
struct SearchOfThread {
  FoundPairs own, around;  // pairs of searched patches; pairs of other patches with a searched element
  std::vector<OverlapPair> overlaps;
  double moved = 0.0;  // m
};

/// The pairs `around` one element that a thread found.
struct FoundRun {
  std::int32_t thread = 0;
  std::size_t first = 0, last = 0;
};

/// Data shared by searches: memory that would otherwise be allocated anew each time, and data that change little between searches (all
/// derived).
struct SearchRoom {
  bool stale = true;                    // the grid must be filled with all elements
  std::vector<geometry::Box3> box;      // by element, its current bounding box
  std::vector<double> moved;            // m, by element: bound on its displacement since its search; 0: searched now
  std::vector<std::uint8_t> looked_at;  // by element: the element, or some of its patches, are searched
  std::vector<std::int32_t> elements;   // the searched elements, ascending
  std::vector<FoundRun> found;          // by entry of `elements`
  std::vector<SearchOfThread> by_thread;
  ReSearch re_search;
  PatchesOfElements patches;             // valid for the number of patches that it lists, until patches are sorted anew
  std::vector<std::uint8_t> changed;     // by patch: its candidates have changed
  std::vector<std::int32_t> candidates;  // by patch: number of its new candidates
  std::vector<std::int64_t> first_of;    // by patch: its first slot; one more entry at the end
  // The lists before the search.
  std::vector<std::int32_t> active;
  std::vector<std::int64_t> first_slot;
  Array<kernels::Candidate> candidate;
  // For gather lists and lists of overlaps.
  std::vector<std::vector<std::int32_t>> gather_counts;  // by part of the slots, and element
  std::vector<std::int32_t> first_overlap;               // by element
  std::vector<OverlapPair> overlaps_before, overlaps_found;
};

}  // namespace voussoir::solver
