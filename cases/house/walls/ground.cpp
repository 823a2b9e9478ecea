// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/walls/ground.h"

#include <algorithm>

#include "cases/house/house_parts.h"
#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

std::string part_key(std::size_t part, const char* field = "") { return indexed_key("base.part", part, field); }

Interval shared(Interval a, Interval b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }

/// The range of a wall whose foot the ground replaces; nothing if the ground is beside the wall.
std::optional<Interval> taken(const House& house, std::size_t index, const HousePlan& plan, const WallPlan& wall) {
  const GroundStep& step = house.ground[index];
  const HouseBox box = in_house(plan, wall, {wall.from, wall.from + wall.length}, {0, wall.thickness}, wall.height);
  const Interval x = shared(box.x, {ticks(step.x[0]), ticks(step.x[1])}), y = shared(box.y, {ticks(step.y[0]), ticks(step.y[1])});
  if (x.length() <= 0 || y.length() <= 0) return std::nullopt;
  const Interval across = wall.along_x ? y : x, all = wall.along_x ? box.y : box.x;
  if (across != all)
    throw InputError(part_key(index), "ends within the thickness of the " + wall_name(house, wall) + ", which stands " + from_to(all) +
                                          " along " + (wall.along_x ? "y" : "x") + " of the house: it has " + from_to(across) +
                                          "; take all of it, or nothing");
  return wall.along_x ? x : y;
}

}  // namespace

void add_ground_holes(const House& house, HousePlan& plan) {
  for (std::size_t i = 0; i < house.ground.size(); ++i) {
    const Tick level = ticks(house.ground[i].level), most = plan.storeys[0].high - plan.lowest_course();
    if (level > most)
      throw InputError(part_key(i, "level"), text(house.ground[i].level) + " m leaves no course of the first storey (" +
                                                 text(metres(plan.storeys[0].high)) + " m); at most " + text(metres(most)) + " m");
    bool any = false;
    for (WallPlan& wall : plan.walls) {
      if (!wall.built || wall.storey != 0) continue;
      const std::optional<Interval> along = taken(house, i, plan, wall);
      if (!along) continue;
      Hole hole{*along, {0, std::min(level, wall.height.high)}, 0, false, {0, wall.thickness}};
      hole.ground = static_cast<std::int32_t>(i);
      wall.holes.push_back(hole);
      any = true;
    }
    if (!any && house.ground[i].only_walls) throw InputError(part_key(i), "no wall stands on it; move it, or leave it out");
  }
}

std::string hole_key(const Hole& hole) {
  if (hole.ground >= 0) return part_key(static_cast<std::size_t>(hole.ground));
  return indexed_key("house.opening", hole.opening, hole.lintel ? "lintel" : hole.arch ? "arch" : "");
}

}  // namespace voussoir::cases
