// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/polyhedron.h"
#include "kernels/contact/contact_patch.h"
#include "solver/world/array.h"

namespace voussoir::solver {

/// What is searched again: all pairs of the elements and all of the patches that are marked. Those of others stay as they are.
struct ReSearch {
  std::vector<std::uint8_t> element, patch;  // by element (and the base), by patch; a marked element's patches are marked too
};

/// Patches of every element, ascending.
struct PatchesOfElements {
  std::vector<std::int32_t> first, list;
  [[nodiscard]] auto begin_of(std::int32_t e) const { return list.begin() + first[static_cast<std::size_t>(e)]; }
  [[nodiscard]] auto end_of(std::int32_t e) const { return list.begin() + first[static_cast<std::size_t>(e) + 1]; }
};

/// Two elements that may come to overlap by more than contact points can see.
struct OverlapPair {
  std::int32_t a = 0, b = 0;        // a < b; b may be the base
  double safe = kernels::kLookNow;  // m, sum of both travel bounds up to which they overlap by no more than is allowed
};

/// Pairs of a patch and an element that one thread has found, run by run.
struct FoundPairs {
  std::vector<std::int32_t> patch;
  std::vector<std::int32_t> rank;  // among the candidates that the patch will have
  std::vector<kernels::Candidate> candidate;
  [[nodiscard]] std::size_t size() const noexcept { return patch.size(); }
  void clear() { patch.clear(), rank.clear(), candidate.clear(); }
  void add(std::int32_t p, std::int32_t r, const kernels::Candidate& c) { patch.push_back(p), rank.push_back(r), candidate.push_back(c); }
};

/// What one thread finds in a search.
struct SearchOfThread {
  FoundPairs own, around;  // pairs of patches that are searched again; of patches that are not, with an element that is
  std::vector<OverlapPair> overlaps;
  double moved = 0.0;  // m
};

/// Which pairs `around` an element of the list a thread found.
struct FoundRun {
  std::int32_t thread = 0;
  std::size_t first = 0, last = 0;
};

/// What searches share: room that they would allocate anew each time, and what changes little from one to the next (all of it derived).
struct SearchRoom {
  bool stale = true;                    // the grid is to be filled with all elements
  std::vector<geometry::Box3> box;      // by element, round it as it stands
  std::vector<std::uint8_t> looked_at;  // by element: it is searched again, or some of its patches are
  std::vector<std::int32_t> elements;   // these, ascending
  std::vector<FoundRun> found;          // by entry of `elements`
  std::vector<SearchOfThread> by_thread;
  ReSearch re_search;
  PatchesOfElements patches;             // up to date for so many patches as it lists, until they are sorted anew
  std::vector<std::uint8_t> changed;     // by patch: its candidates are others than before
  std::vector<std::int32_t> candidates;  // by patch, how many it will have
  std::vector<std::int64_t> first_of;    // by patch, its first slot; one more entry
  // The lists before the search.
  std::vector<std::int32_t> active;
  std::vector<std::int64_t> first_slot;
  Array<kernels::Candidate> candidate;
  // Of gather lists and lists of overlaps.
  std::vector<std::vector<std::int32_t>> gather_counts;  // by thread and element
  std::vector<std::int32_t> first_overlap;               // by element
  std::vector<OverlapPair> overlaps_before, overlaps_found;
};

}  // namespace voussoir::solver
