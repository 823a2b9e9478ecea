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
/// A wall is laid in courses, as one of bricks is. In each, upright joints stand at random places clear of those below, and lean. The beds
/// between two courses are not level: they rise to where a joint of the upper course ends and fall to where one of the lower course does,
/// so that stones are hexagons and other polygons, convex because all joints that end on one stone from one side do so at one height. Beds
/// are level where walls meet, at openings, beams and the ends of storeys. Through the wall a stone is one of two or more side by side, or
/// goes through. All corners are whole nanometres: neighbours share edges exactly, and a seed gives the same wall everywhere.
namespace voussoir::cases {

/// A stone: its outline along the wall and upwards [m], counter-clockwise, and where it lies through the wall.
struct RubbleStone {
  geometry::Polygon outline;
  Interval depth;
  bool through = false;  // both leaves, House::leaves
};

/// Random heights for the courses between two levels, about the height of a brick; none lower than the lowest course.
std::vector<Interval> rubble_courses(const House& house, const HousePlan& plan, Interval between, std::int64_t number);

/// All walls of a house, storey upon storey.
class RubbleWalls {
 public:
  RubbleWalls(const House& house, const HousePlan& plan);
  /// The stones of a course, along the wall. \param wall  of the plan
  [[nodiscard]] const std::vector<RubbleStone>& stones(const WallPlan& wall, int course) const;

 private:
  std::map<std::tuple<const WallPlan*, int>, std::vector<RubbleStone>> stones_;
};

}  // namespace voussoir::cases
