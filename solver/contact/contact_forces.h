// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/nth.h"
#include "solver/world/world.h"

/// Stages 2 and 3b of the step: search for free patches that may touch elements, and forces of those that do.
namespace voussoir::solver {

/// Finds the candidates anew of elements that have moved by more than a quarter of the skin since their last search, as patches and as
/// partners, and of new patches: broad phase on the uniform grid, then patch against element by separating planes. Other candidates are
/// kept. In a collapse only few elements fly, but these need a search every ten steps.
void search_contacts(World& w);

/// Finds the candidates of all elements anew.
void search_all(World& w);

/// Data common to the patches of one level in a step.
struct PatchStep {
  kernels::Bodies bodies;
  kernels::ContactOptions options;
};

/// Memory of one thread for the points of a patch and the faces of its candidates.
struct ContactRoom {
  std::vector<double> depth;
  std::vector<std::int32_t> candidate, face;
  std::vector<kernels::PlaneField> planes;
  std::vector<PatchStep> steps;  // by level
  std::vector<std::uint8_t> on;  // of the slots of a patch before this step
  [[nodiscard]] kernels::PatchScratch view() { return {depth.data(), candidate.data(), face.data(), planes.data()}; }
  void fit(std::int32_t points, std::int32_t faces);
};

/// Division of the patches of a step among threads.
class ContactRuns {
 public:
  /// Divides the patches: long runs first, since the first patches of each run wait for their memory, and short ones last, so that no
  /// thread waits for another's. To be called before the team begins.
  /// \param due  number of levels of patches due in this step, from level 0 on
  void begin(const World& w, int due);
  /// Calls `work(first, last)` for ranges of the list of these patches, until all are taken.
  template <class Work>
  void take(Work work) {
    tickets_.take([&](std::int64_t run, std::int64_t) { work(nth(ends_, run), ends_[static_cast<std::size_t>(run) + 1]); });
  }

 private:
  std::vector<std::int64_t> ends_;  // of runs; the first begins at 0
  Tickets tickets_;
};

/// Computes the forces of active patches into their slots. To be called by the threads of a team; threads may return before all patches are
/// done.
/// \param due  as for ContactRuns::begin
void advance_contacts(World& w, int due, ContactRuns& runs, ContactRoom& room);

/// Number of elements that may get forces from slots of the due levels.
[[nodiscard]] DueNumbers gatherers(const World& w, int due);
/// Adds the forces in the slots of gatherer `number` to the rows of its element, in slot order. Fastest if called in order of numbers.
void gather_contacts(World& w, int due, std::int64_t number);

/// Turns a side that has come apart into a free patch of its master, and one of its slave if the side represented both faces. Points in
/// contact keep their partner and slip, with a closure that continues their force.
void retire_side(World& w, std::int32_t side);

/// Appends the free patch that a retired side leaves to its master, or (mirrored) to its slave if the side represented both faces, without
/// partners.
void append_retired_patch(World& w, std::int32_t side, bool mirrored);

/// Lists the blocks that still have a side, by task. To be called after sides have retired.
void list_live_blocks(World& w);

}  // namespace voussoir::solver
