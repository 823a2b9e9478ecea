// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "cases/house/house_inner_walls.h"
#include "cases/house/house_thickness.h"
#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

std::string pier_key(std::size_t pier, const char* field) { return indexed_key("house.pier", pier, field); }

Side side_of(const House& house, std::size_t index, const HousePlan& plan) {
  const std::string& wanted = house.piers[index].wall;
  for (const Side side : {Side::front, Side::right, Side::rear, Side::left}) {
    if (wanted != name(side)) continue;
    if (!plan.wall(side).built) throw InputError(pier_key(index, "wall"), quoted(wanted) + " is not built; see house.walls");
    return side;
  }
  throw InputError(pier_key(index, "wall"), quoted(wanted) + " is no outer wall; allowed: front, rear, left, right");
}

/// Lengths of a pier, each checked.
struct Sizes {
  Interval along;  // of the wall
  Tick depth = 0, height = 0;
};

Sizes sizes_of(const House& house, std::size_t index, const HousePlan& plan) {
  const Pier& pier = house.piers[index];
  Sizes s;
  const Tick from = positive_length(pier.from, pier_key(index, "from"));
  s.along = {from, from + wall_thickness(pier.width, plan, pier_key(index, "width"))};
  s.depth = positive_length(pier.depth, pier_key(index, "depth"));
  if (s.depth < plan.shortest_piece())
    throw InputError(pier_key(index, "depth"),
                     text(pier.depth) + " m is less than half a brick; at least " + metres_text(plan.shortest_piece()) + " m");
  s.height = pier.height ? positive_length(*pier.height, pier_key(index, "height")) : plan.storeys[0].high;
  if (s.height > plan.height)
    throw InputError(pier_key(index, "height"),
                     text(*pier.height) + " m is above the top of the walls; at most " + metres_text(plan.height) + " m");
  return s;
}

/// Checks that at least half a brick lies between a pier and holes or crossing walls of its wall.
void check_place(const House& house, std::size_t index, const WallPlan& wall, Interval along, const HousePlan& plan) {
  const Tick gap = plan.shortest_piece();
  const Interval room{wall.corner + gap, wall.length - wall.corner - gap};
  const std::string from = text(house.piers[index].from) + " m ";
  if (along.low < room.low || along.high > room.high)
    throw InputError(pier_key(index, "from"), from + "puts the pier at a corner of the " + wall_name(house, wall) + "; allowed: " +
                                                  metres_text(room.low) + " to " + metres_text(room.high - along.length()) + " m");
  for (const Crossing& other : wall.crossings) {
    if (!along.overlaps({other.along.low - gap, other.along.high + gap})) continue;
    throw InputError(pier_key(index, "from"), from + "puts the pier less than half a brick from where another wall or pier meets the " +
                                                  wall_name(house, wall) + ", from " + metres_text(other.along.low) + " to " +
                                                  metres_text(other.along.high) + " m");
  }
}

void plan_pier(const House& house, std::size_t i, HousePlan& plan) {
  const Side side = side_of(house, i, plan);
  const Sizes s = sizes_of(house, i, plan);
  std::vector<WallPlan> parts;
  for (WallPlan& wall : plan.walls) {
    if (!wall.outer() || wall.side != side || wall.height.low >= s.height) continue;
    check_place(house, i, wall, s.along, plan);
    const bool far = side == Side::rear || side == Side::right;
    WallPlan part;
    part.side = side, part.pier = static_cast<std::int32_t>(i), part.storey = wall.storey;
    part.along_x = !wall.along_x;
    part.at = s.along.low, part.thickness = s.along.length();
    const Tick outer = plan.outer[part.along_x ? 0 : 1];
    part.from = far ? outer - wall.thickness : -s.depth, part.length = wall.thickness + s.depth;
    part.height = {wall.height.low, std::min(wall.height.high, s.height)};
    const Interval in_wall = far ? Interval{outer - wall.thickness, outer} : Interval{0, wall.thickness};
    part.crossings = {{in_wall, part.height}};
    wall.crossings.push_back({s.along, part.height});
    parts.push_back(std::move(part));
  }
  plan.walls.insert(plan.walls.end(), parts.begin(), parts.end());
}

}  // namespace

void plan_piers(const House& house, HousePlan& plan) {
  for (std::size_t i = 0; i < house.piers.size(); ++i) plan.faults.attempt([&] { plan_pier(house, i, plan); });
}

}  // namespace voussoir::cases
