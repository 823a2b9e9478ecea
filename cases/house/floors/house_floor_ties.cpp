// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "cases/house/floors/house_floors.h"
#include "cases/house/house_parts.h"
#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

/// A point in axes of the house from its position along the beams, across the beams, and its height.
Vec3 on_floor(const Floor& floor, double along, double across, double z) {
  return floor.along == PlanAxis::x ? Vec3{along, across, z} : Vec3{across, along, z};
}

/// The tie at the low or the high end of a beam, in axes of the house.
Tie anchor_at(const House& house, const HousePlan& plan, std::size_t index, Interval beam, bool high_end) {
  const Floor& floor = house.floors[index];
  const FloorPlan& laid = plan.floors[index];
  const BeamEnds ends = ends_of(floor);
  const double bearing = metres(ticks(floor.bearing)), across = 0.5 * metres(beam.low + beam.high);
  const double end = metres(high_end ? laid.length.high : laid.length.low);
  const double wall = metres(plan.wall(high_end ? ends.high : ends.low, floor.storey - 1).thickness);
  const double middle = 0.5 * metres(laid.height.low + laid.height.high);
  const Vec3 inwards = on_floor(floor, high_end ? -1.0 : 1.0, 0.0, 0.0);
  return beam_anchor(floor, {on_floor(floor, end, across, middle), inwards, bearing, wall - bearing, metres(laid.height.low),
                             metres(plan.brick_height)});
}

void check_anchor(const House& house, const HousePlan& plan, std::size_t index) {
  const Floor& floor = house.floors[index];
  const BeamEnds ends = ends_of(floor);
  for (const Side side : {ends.low, ends.high}) {
    const Tick wall = plan.wall(side, floor.storey - 1).thickness;
    if (floor.anchorage == Anchorage::anchor && ticks(floor.bearing) == wall)
      throw InputError(floor_key(index, "bearing"), text(floor.bearing) + " m leaves nothing of the " + name(side) +
                                                        " wall behind the beams for anchors to hold; at most " +
                                                        metres_text(wall - plan.brick_width) + " m");
  }
  const double half = 0.5 * metres(plan.floors[index].length.length()) - floor.bearing;
  if (!(floor.anchor->reach < half))
    throw InputError(floor_key(index, "anchor.reach"),
                     text(floor.anchor->reach) + " m is not less than half the span of the beams, " + text(half) + " m");
}

}  // namespace

Tie beam_anchor(const Floor& floor, const BeamEnd& end) {
  Tie tie = floor.anchor->bar;
  tie.from = end.at + (end.bearing + floor.anchor->reach) * end.inwards;
  if (floor.anchorage == Anchorage::anchor) {
    tie.to = end.at - end.behind * end.inwards;
  } else {  // in the middle of the bed under the beam's end, half a course down
    tie.to = end.at + (0.5 * end.bearing) * end.inwards;
    tie.to.z = end.underside - 0.25 * end.course;
  }
  return tie;
}

std::vector<PlannedTie> beam_anchors(const House& house, double foot) {
  std::vector<PlannedTie> all;
  if (std::ranges::none_of(house.floors, [](const Floor& f) { return f.anchorage != Anchorage::friction; })) return all;
  const HousePlan plan = plan_house(house);
  for (std::size_t k = 0; k < house.floors.size(); ++k) {
    const Floor& floor = house.floors[k];
    if (floor.anchorage == Anchorage::friction) continue;
    check_anchor(house, plan, k);
    const std::string begins = "floor " + std::to_string(floor.storey) + " anchor ";
    int number = 0;
    for (int j = 0; j < house.copies[1]; ++j) {
      for (int i = 0; i < house.copies[0]; ++i) {
        for (const std::vector<Interval>& room : plan.floors[k].rooms) {
          for (std::size_t beam = 0; beam < room.size(); beam += static_cast<std::size_t>(floor.anchor->every)) {
            for (const bool high_end : {false, true}) {
              Tie tie = anchor_at(house, plan, k, room[beam], high_end);
              tie.name = begins + std::to_string(++number);
              tie.from = in_case(house, plan, i, j, tie.from) + Vec3{0, 0, foot};
              tie.to = in_case(house, plan, i, j, tie.to) + Vec3{0, 0, foot};
              all.push_back({tie, k});
            }
          }
        }
      }
    }
  }
  return all;
}

}  // namespace voussoir::cases
