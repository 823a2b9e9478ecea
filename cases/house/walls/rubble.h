// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "cases/house/house_plan.h"
#include "geometry/polygon.h"

/// Walls of random convex stones that fill them without gaps. Internal to cases/.
///
/// A wall is laid in courses, like one of bricks. In each course head joints are at random places clear of those below, and inclined. The
/// beds between two courses are not level: they rise to the end of each joint of the upper course and fall to the end of each joint of the
/// lower course. Stones are therefore hexagons and other polygons, convex because all joints that end on one side of a stone end at one
/// height. Beds are level where walls meet, at openings, beams and the ends of storeys. Through the wall lie two or more stones side by
/// side, or one through stone. All corners are whole nanometres: neighbours share edges exactly, and a seed gives the same wall on every
/// machine.
namespace voussoir::cases {

/// A stone: its outline along the wall and upwards [m], counter-clockwise, and its range through the wall.
struct RubbleStone {
  geometry::Polygon outline;
  Interval depth;
  bool through = false;  // through both leaves, House::leaves
};

/// Random heights of the courses between two levels, about the height of a brick; none below the least course height. \param number  of the
/// range, part of the seed
std::vector<Interval> rubble_courses(const House& house, const HousePlan& plan, Interval between, std::int64_t number);

/// All walls of a house, from the lowest storey up.
class RubbleWalls {
 public:
  RubbleWalls(const House& house, const HousePlan& plan);
  /// The stones of a course, in order along the wall. \param wall  of the plan
  [[nodiscard]] const std::vector<RubbleStone>& stones(const WallPlan& wall, int course) const;

 private:
  std::map<std::tuple<const WallPlan*, int>, std::vector<RubbleStone>> stones_;
};

}  // namespace voussoir::cases
