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

/// Possible contacts: for each active patch a few candidates, each with a slot for its wrench; every element gathers
/// its slots in a fixed order, so no two threads ever add to one row.
struct Contacts {
  static constexpr int kUpToDate = 127;  // no level is as high
  geometry::UniformGrid grid;            // of elements where they were searched last
  SearchRoom room;
  int stale_level = kUpToDate;           // the lowest level (multirate.h) of slots that were added since the gather lists were made
  std::vector<std::int32_t> active;      // patches with candidates
  std::vector<std::int64_t> first_slot;  // by active patch, count + 1 entries
  std::vector<std::int32_t> master;      // by active patch: its element (derived)
  Array<std::int32_t> element;           // by slot: who may be touched (state)
  Array<kernels::Candidate> candidate;   // by slot: the same, and what is known of the pair (derived)
  Array<kernels::PairWrench> wrench;
  std::vector<std::uint8_t> on;
  std::vector<std::int64_t> first_gather;  // by element, count + 1 entries: its room in `gather`
  std::vector<std::int64_t> last_gather;   // by element: where its entries end; the rest of its room is for slots that come later
  std::vector<std::int32_t> gather;        // slot × 2 + (0: master, 1: slave), ascending
  std::vector<std::int32_t> place;  // the way back: by slot × 2 + (0, 1), where it stands among these; −1: the base, which gathers none
  std::vector<std::uint8_t> gather_on;  // `on` of their slots, and 8 zeros: few push, and these are found 8 at a time
  // Of multi-rate stepping; else empty. A patch has the lowest level of its pairs.
  std::vector<std::uint8_t> level;         // by active patch
  std::vector<std::uint8_t> gather_level;  // by entry of `gather`, and 8 zeros
  ByLevel patches, gatherers;              // active patches; elements with entries in `gather`, by the lowest of these
  std::int64_t searched = 0;               // active patches whose candidates a search found; the others are new (state)
  std::int64_t searches = 0;
};

}  // namespace voussoir::solver
