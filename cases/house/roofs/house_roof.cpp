// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "cases/house/house_parts.h"
#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {

Tick roof_seat(const House& house, const HousePlan& plan) {
  const bool upon_walls = house.reinforcement && house.reinforcement->ring_beam_place == RingPlace::middle;
  return plan.height + (upon_walls ? positive_length(house.reinforcement->ring_beam[1], "house.reinforcement.ring_beam") : 0);
}

namespace {

/// Length of beams on a bearing wall, from its inner face.
Tick seat_of(const House& house, Tick wall, Tick brick) {
  if (!house.roof.bearing) return std::min(wall, brick);
  const Tick seat = positive_length(*house.roof.bearing, "house.roof.bearing");
  if (seat > wall)
    throw InputError(
        "house.roof.bearing",
        text(*house.roof.bearing) + " m is more than the thickness of the bearing walls; allowed: up to " + text(metres(wall)) + " m");
  return seat;
}

}  // namespace

void build_flat_roof(const House& house, const HousePlan& plan, HouseParts& parts) {
  if (!plan.wall(Side::front).built || !plan.wall(Side::rear).built)
    throw InputError("house.roof.kind", "a flat roof rests on the front and the rear wall; house.walls leaves one of them out");
  const Tick width = element_length(house.roof.beam[0], plan.outer[0], "house.roof.beam");
  const Tick height = positive_length(house.roof.beam[1], "house.roof.beam");
  const Tick bearing = plan.wall(Side::front).thickness;
  const Tick seat = seat_of(house, bearing, plan.brick_length);
  const Tick low = roof_seat(house, plan);
  const Interval across{bearing - seat, plan.outer[1] - (bearing - seat)};
  const Tick element = element_length(house.roof.element, across.length(), "house.roof.element");
  Block prototype;
  prototype.kind = PartKind::beam;
  prototype.material = parts.roof;
  // Segment size of a whole unit, used also for the last beam or element, which may be cut.
  prototype.segment_size = segment_size_of(std::min(width, plan.outer[0]), height, std::min(element, across.length()));
  int number = 0;
  for (const Interval x : cut_member({0, plan.outer[0]}, width)) {
    prototype.tag = "roof beam " + std::to_string(number++);
    prototype.member = parts.members++;
    for (const Interval y : cut_member(across, element)) {
      prototype.whole = x.length() == width && y.length() == element;
      parts.blocks.push_back(box_block({x, y, {low, low + height}}, prototype));
    }
  }
}

}  // namespace voussoir::cases
