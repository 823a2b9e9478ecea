// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/house/house_plan.h"

/// Bond: the bricks of a course of a wall. Internal to cases/.
namespace voussoir::cases {

/// A brick of a course in the wall's own coordinates.
struct LaidBrick {
  Interval along, depth;
  bool whole = true;     // false: cut, or a remainder joined to its neighbour
  bool through = false;  // a stone through both leaves
};

/// A layer of a course through the wall's thickness. Joints lie at offset + unit * i along the wall, from the outer corner of the house; in
/// Flemish bond a header lies before each unit, so that there are two joints in header + unit.
struct Wythe {
  Interval depth;
  Tick unit = 0, offset = 0;
  Tick header = 0;    // length of the header before each unit; 0: none
  bool core = false;  // between the faces of a wall in Flemish bond: its pieces are halves of headers
  /// Whether a remainder at an edge is divided with the half brick at the edge. Needed where the course above is shifted by half a brick:
  /// its joint lies half a brick plus the remainder from the edge.
  bool half_at_edge = false;
};

/// The layers of a course from the outer face inwards.
///
/// English bond, n = widths_through(). Even courses: rows of headers; odd courses: a stretcher at the outer face, headers as core, a
/// stretcher at the inner face, all shifted by a quarter brick. With n odd the even course ends in a stretcher at the inner face and the
/// odd course has none at the inner face. Running bond, and any wall one brick width thick: n stretchers, every second course shifted by
/// half a brick. Rubble counts as one layer; walls/rubble.h divides it.
/// Flemish bond, n even: n layers of a brick's width, headers and stretchers in turn in the faces, the odd course's headers over the middle
/// of the even course's stretchers, headers between the faces; lay_course() makes headers of the layers' pieces.
std::vector<Wythe> wythes(const HousePlan& plan, Tick thickness, int course);

/// The layers of a course of a wall; of both leaves if it has two.
std::vector<Wythe> wythes(const HousePlan& plan, const WallPlan& wall, int course);

/// Sets WallPlan::leaf of the outer walls selected by House::leaves. \throw InputError with the key at fault
void plan_leaves(const House& house, HousePlan& plan);

/// Block::leaf of bricks in a layer of a wall.
std::int32_t leaf_of(const HousePlan& plan, const WallPlan& wall, Interval depth);

/// Divides a span at the joints offset + unit * i. A remainder at an end shorter than half a brick is joined to its neighbour; if the two
/// are longer than a brick, their inner part is half a brick and the rest is at the end, or the other way round (Wythe::half_at_edge).
/// \pre span.length() >= brick_length / 2
std::vector<Interval> divide(Interval span, const Wythe& wythe, Tick brick_length);

/// All bricks of a course, sorted by their position along the wall, then by depth.
std::vector<LaidBrick> lay_course(const House& house, const HousePlan& plan, const WallPlan& wall, int course);

}  // namespace voussoir::cases
