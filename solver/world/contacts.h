// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/grid.h"
#include "kernels/contact/contact_patch.h"
#include "solver/world/array.h"
#include "solver/world/multirate.h"
#include "solver/world/search_room.h"

namespace voussoir::solver {

/// Possible contacts: for each active patch a few candidates, each with a slot for its wrench; every element gathers its slots in a fixed
/// order, so no two threads ever add to one row.
struct Contacts {
  static constexpr int kUpToDate = 127;  // above all levels
  geometry::UniformGrid grid;            // of elements at their last search
  SearchRoom room;
  int stale_level = kUpToDate;           // lowest level (multirate.h) of slots added since the gather lists were built
  std::vector<std::int32_t> active;      // patches with candidates
  std::vector<std::int64_t> first_slot;  // by active patch, count + 1 entries
  std::vector<std::int32_t> master;      // by active patch: its element (derived)
  std::vector<std::uint8_t> pushes;      // by patch, if it is active: it can push something with more than its rim (derived)
  Array<std::int32_t> element;           // by slot: element that may be touched (state)
  Array<kernels::Candidate> candidate;   // by slot: the element, and cached knowledge of the pair (derived)
  Array<kernels::PairWrench> wrench;
  std::vector<std::uint8_t> on;
  std::vector<std::int64_t> first_gather;  // by element, count + 1 entries: start of its range in `gather`
  std::vector<std::int64_t> last_gather;   // by element: end of its entries; the rest of its range is for later slots
  std::vector<std::int32_t> gather;        // slot × 2 + (0: master, 1: slave), ascending
  std::vector<std::int32_t> place;         // by slot × 2 + (0, 1): its position in `gather`; −1: the base, which gathers nothing
  std::vector<std::uint8_t> gather_on;     // `on` of the slots in `gather`, and 8 zeros: few slots have a force, and are found 8 at a time
  // For multi-rate stepping; else empty. A patch has the lowest level of its pairs.
  std::vector<std::uint8_t> level;         // by active patch
  std::vector<std::uint8_t> gather_level;  // by entry of `gather`, and 8 zeros
  ByLevel patches, gatherers;              // active patches; elements with entries in `gather`, by their lowest level
  std::int64_t searched = 0;               // number of active patches with candidates from a search; the others are new (state)
  std::int64_t searches = 0;
};

}  // namespace voussoir::solver
