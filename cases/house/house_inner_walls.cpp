// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_inner_walls.h"

#include <algorithm>

#include "cases/house/house_thickness.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

bool goes_through(const InnerWall& wall, int storey) {
  return wall.storeys.empty() || std::ranges::find(wall.storeys, storey + 1) != wall.storeys.end();
}

void check_name(const House& house, std::size_t index) {
  const std::string& given = house.inner_walls[index].name;
  const std::string key = indexed_key("house.inner_wall", index, "name");
  for (const Side side : {Side::front, Side::right, Side::rear, Side::left}) {
    if (given == name(side)) throw InputError(key, quoted(given) + " is the name of an outer wall; give another");
  }
  for (std::size_t other = 0; other < index; ++other) {
    if (house.inner_walls[other].name == given)
      throw InputError(key, quoted(given) + " is already the name of " + indexed_key("house.inner_wall", other, "") + "; give another");
  }
}

void check_storeys(const House& house, std::size_t index) {
  const std::vector<int>& storeys = house.inner_walls[index].storeys;
  const int most = static_cast<int>(house.storeys.size()) + 1;
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    if (storeys[i] < 1 || storeys[i] > most)
      throw InputError(indexed_key("house.inner_wall", index, "storeys") + "[" + std::to_string(i) + "]",
                       "there is no storey " + std::to_string(storeys[i]) + "; allowed: 1 to " + std::to_string(most));
  }
}

/// Checks that the distance between a wall and the next parallel wall suffices for bricks of the walls that it meets.
void check_place(const House& house, std::size_t index, const WallPlan& wall, const HousePlan& plan) {
  const std::string key = indexed_key("house.inner_wall", index, "at");
  const std::string at = text(house.inner_walls[index].at) + " m ";
  const Tick gap = plan.shortest_piece(), aside = plan.wall(wall.along_x ? Side::front : Side::left, wall.storey).thickness;
  const Tick least = aside + gap, most = plan.outer[wall.along_x ? 1 : 0] - aside - gap - wall.thickness;
  if (wall.at < least || wall.at > most) {
    throw InputError(key, at + "leaves no room beside it; allowed: " + metres_text(least) + " to " + metres_text(most) + " m");
  }
  for (const WallPlan& other : plan.walls) {
    if (other.inner < 0 || other.storey != wall.storey || other.along_x != wall.along_x) continue;
    const Interval near{other.at - gap - wall.thickness, other.at + other.thickness + gap};
    if (wall.at <= near.low || wall.at >= near.high) continue;
    throw InputError(key, at + "is too near to " + indexed_key("house.inner_wall", static_cast<std::size_t>(other.inner), "") +
                              "; allowed: at most " + metres_text(near.low) + " m, or " + metres_text(near.high) + " m and more");
  }
}

void plan_inner_wall(const House& house, std::size_t i, int storey, HousePlan& plan) {
  const InnerWall& inner = house.inner_walls[i];
  check_name(house, i);
  check_storeys(house, i);
  if (!goes_through(inner, storey)) return;
  WallPlan wall;
  wall.inner = static_cast<std::int32_t>(i);
  wall.storey = storey;
  wall.along_x = inner.along == PlanAxis::x;
  wall.at = positive_length(inner.at, indexed_key("house.inner_wall", i, "at"));
  wall.length = plan.outer[wall.along_x ? 0 : 1];
  wall.thickness = wall_thickness(inner.thickness, plan, indexed_key("house.inner_wall", i, "thickness"), plan.faults);
  wall.corner = plan.wall(wall.along_x ? Side::left : Side::front, storey).thickness;
  wall.height = nth(plan.storeys, storey);
  check_place(house, i, wall, plan);
  plan.walls.push_back(wall);
}

}  // namespace

void plan_inner_walls(const House& house, int storey, HousePlan& plan) {
  for (std::size_t i = 0; i < house.inner_walls.size(); ++i) plan.faults.attempt([&] { plan_inner_wall(house, i, storey, plan); });
}

}  // namespace voussoir::cases
