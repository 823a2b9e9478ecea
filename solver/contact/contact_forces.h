// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// Stages 2 and 3b of the step: which free patches may touch which elements, and the forces of those that do.
namespace voussoir::solver {

/// Broad phase on the uniform grid, then patch against element by separating planes: finds again the candidates of elements that have moved
/// by more than a quarter of the skin since they were searched last, as patches and as partners, and of patches that came since. Others
/// keep theirs. In a collapse few elements fly, but these ask for a search every ten steps.
void search_contacts(World& w);

/// The same for all elements.
void search_all(World& w);

/// What patches of one level (multirate.h) have in common in a step.
struct PatchStep {
  kernels::Bodies bodies;
  kernels::ContactOptions options;
};

/// One thread's room for the points of a patch and the faces of what it may touch, and how the threads part the patches.
struct ContactRoom {
  std::vector<double> depth;
  std::vector<std::int32_t> candidate, face;
  std::vector<kernels::PlaneField> planes;
  std::vector<PatchStep> steps;    // by level
  std::vector<std::uint8_t> on;    // of the slots of a patch before this step
  std::vector<std::int64_t> runs;  // a thread takes those of [runs[i], runs[i + 1]) at a time
  [[nodiscard]] kernels::PatchScratch view() { return {depth.data(), candidate.data(), face.data(), planes.data()}; }
  void fit(std::int32_t points, std::int32_t faces);
  /// Long runs first, since the first patches of each wait for their memory, and short ones last, so that no thread waits for another's.
  void part(std::int64_t patches, int threads);
};

/// Forces of active patches into their slots. To be called by every thread of a team; they may leave it before all is done.
/// \param due  levels of patches whose turn it is, from 0 on (solver/world/multirate.h)
void advance_contacts(World& w, int due, ContactRoom& room);

/// Elements that may take something from slots of these levels.
[[nodiscard]] std::int64_t gatherers(const World& w, int due);
/// Adds to the rows of one of these elements what its slots hold, in slot order. Best called for one after the other.
void gather_contacts(World& w, int due, std::int64_t number);

/// Turns a side that has come apart into a free patch of its master, and one of its slave if it stood for both faces. Points that touch
/// keep their partner and slip, and a closure with which their force goes on.
void retire_side(World& w, std::int32_t side);

/// Appends the free patch that a retired side leaves to its master, or (mirrored) the one that it leaves to its slave if it stood for both
/// faces, without partners.
void append_retired_patch(World& w, std::int32_t side, bool mirrored);

/// Blocks that still hold a side, by task. Call after sides have retired.
void list_live_blocks(World& w);

}  // namespace voussoir::solver
