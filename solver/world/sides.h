// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/nth.h"
#include "kernels/law.h"
#include "kernels/laws/laws_of_side.h"
#include "kernels/side.h"
#include "kernels/whole_sides.h"
#include "solver/world/array.h"

namespace voussoir::solver {

/// Contact points of congruent patches, stored once: the segment geometry of 4,000 equal bricks stays in the first-level cache.
struct PointSets {
  std::vector<std::int32_t> first, count;  // by set; first is a multiple of kLanes
  Array<double> s, t, area;                // padded to kLanes with area 0
  std::int32_t largest = 0;                // greatest number of points of a set
  [[nodiscard]] kernels::PointsView view(std::int32_t set) const noexcept;
};

/// What an optional law keeps of segments.
struct LawState {
  const char *name, *unit, *shape;  // as in state/field_table.h
  ZeroArray<double> values;         // zero at first
};

/// Sides of joints, structure of arrays. A joint has two *sides*: in each, one of its two faces is the master. Where both faces have the
/// same grid of segments, one merged side represents both. kLanes sides that are processed together form a *block*; blocks are grouped in
/// tasks, tasks in colours (schedule/colouring.h). No two tasks of a colour share an element, so forces are added without atomics. A side's
/// number is block × kLanes + lane.
struct Sides {
  // Blocks.
  Array<kernels::SideConstants> constants;  // shared by congruent blocks
  Array<kernels::WholeConstants> whole;     // of the same blocks
  Array<kernels::SideBlock> blocks;
  std::vector<std::int32_t> task_first;    // blocks of task t: [task_first[t], task_first[t + 1])
  std::vector<std::int32_t> task_level;    // by task and level (multirate.h): first block of its sides of that level; one more at the end
  std::vector<std::int32_t> colour_first;  // tasks of colour c: [colour_first[c], colour_first[c + 1])
  std::int32_t overflow_colour = -1;       // colour of the single task of sides that span more than two cells; −1: none
  // Sides that are not retired. A side is *retired* when its joint has come apart: its segments are then free patches (patches.h).
  std::vector<std::int32_t> live;        // blocks with a side that is not retired, ascending
  std::vector<std::int32_t> live_first;  // by task: index into `live`; tasks + 1 entries
  std::vector<std::int32_t> live_level;  // by task and level: index into `live`, as task_level
  std::vector<std::uint8_t> live_lanes;  // by block, bit mask of the sides that are not retired

  // Constants by side.
  std::vector<std::int32_t> joint, set;               // joint −1: unused lane; set: index into World::points
  std::vector<std::int32_t> master_face, slave_face;  // index into World::faces
  std::vector<std::uint8_t> faces;                    // 2: a merged side, which represents both faces
  std::vector<kernels::SideParts> parts;              // with views of the point sets and of the segments' state below
  std::vector<double> size;                           // m, segment size of the master

  // State by side.
  Array<kernels::SideState> side_state;
  Array<std::uint8_t> retired;                   // replaced by free patches
  Array<std::int32_t> held;                      // bonded segments
  ZeroArray<double> friction, impact, fracture;  // J, losses so far

  // State by segment; `steady` by block.
  ZeroArray<kernels::Bond> bond;               // at first bonded, or contact of a dry joint
  ZeroArray<kernels::Mode> first_mode;         // limit reached first ...
  ZeroArray<double> first_time;                // ... and its time, s
  ZeroArray<kernels::SegmentSprings> springs;  // of kWidth segments each
  ZeroArray<kernels::SteadySides> steady;      // of the steady sides of a block

  // Optional laws (setup/laws/optional_laws.h); empty in a model without.
  std::vector<kernels::SideLaws> laws;  // by side
  std::vector<LawState> law_state;      // State: what they keep, in the order in which they were set up

  // Pair forces (kernels::PairForces) in steps with World::keep_pairs; empty if not needed.
  Array<double> pair_wrench;
  std::vector<std::uint8_t> pair_on;

  [[nodiscard]] std::int64_t count() const noexcept { return static_cast<std::int64_t>(joint.size()); }
  [[nodiscard]] kernels::Side side(std::int64_t id) const noexcept;
  /// The optional laws of a side.
  [[nodiscard]] const kernels::SideLaws& laws_of(std::size_t id) const noexcept { return laws.empty() ? kernels::kNoLaws : laws[id]; }
  /// What a law keeps; nullptr: no joint has it.
  [[nodiscard]] const ZeroArray<double>* state_of_law(std::string_view name) const noexcept;
  [[nodiscard]] kernels::SegmentsView segments(std::int64_t id) const noexcept { return nth(parts, id).segments; }
};

}  // namespace voussoir::solver
