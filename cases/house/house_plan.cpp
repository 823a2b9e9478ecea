// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_plan.h"

#include <algorithm>
#include <cmath>

#include "cases/house/house_openings.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

constexpr double kTicksPerMetre = 1e9;
constexpr double kLongest = 1e4;       // m; far beyond any house, far below what overflows a Tick
constexpr double kMostElements = 2e7;  // a mistyped brick size must not fill the machine's memory

/// Two widths and the joint between them are a length.
[[noreturn]] void refuse_format(const House& house) {
  const double length = house.brick[0], width = house.brick[1], joint = length - 2.0 * width;
  const std::string with_mortar = house.mortar == 0.0 ? "" : " and mortar of " + text(house.mortar) + " m";
  const std::string fitting = joint > 0.0 && joint < 0.25 * house.brick[2] ? ", mortar = " + text(metres(ticks(joint))) : "";
  throw InputError("house.brick", "English bond needs bricks twice as long as wide, each with its mortar, not " + text(length) + " x " +
                                      text(width) + " m" + with_mortar + "; nearest: [" + text(2.0 * width + house.mortar) + ", " +
                                      text(width) + ", " + text(house.brick[2]) + "]" + fitting + ", or bond = \"running\"");
}

void plan_bricks(const House& house, HousePlan& plan) {
  plan.bond = house.bond;
  const Tick mortar = house.mortar == 0.0 ? 0 : positive_length(house.mortar, "house.mortar");
  plan.brick_length = positive_length(house.brick[0], "house.brick") + mortar;
  plan.brick_width = positive_length(house.brick[1], "house.brick") + mortar;
  plan.brick_height = positive_length(house.brick[2], "house.brick") + mortar;
  if (mortar >= plan.brick_height - mortar) {
    throw InputError("house.mortar", text(house.mortar) + " m is not less than the height of a brick (" + text(house.brick[2]) + " m)");
  }
  if (house.bond == Bond::english && plan.brick_length != 2 * plan.brick_width) refuse_format(house);
  if (plan.brick_length < plan.brick_width) {
    throw InputError("house.brick",
                     "a brick must not be wider (" + text(house.brick[1]) + " m) than long (" + text(house.brick[0]) + " m)");
  }
}

void plan_walls(const House& house, HousePlan& plan) {
  const Tick bearing = multiple_of(house.bearing_wall, plan.brick_width, "house.bearing_wall", "brick widths");
  const Tick nonbearing = multiple_of(house.nonbearing_wall, plan.brick_width, "house.nonbearing_wall", "brick widths");
  plan.height = positive_length(house.height, "house.height");
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Tick inner = positive_length(house.inner_size[axis], "house.inner_size");
    if (inner < plan.shortest_piece()) {
      throw InputError("house.inner_size", text(house.inner_size[axis]) + " m is less than half a brick; at least " +
                                               text(metres(plan.shortest_piece())) + " m");
    }
    plan.outer[axis] = inner + 2 * (axis == 0 ? nonbearing : bearing);
  }
  for (const Side side : {Side::front, Side::right, Side::rear, Side::left}) {
    const bool is_bearing = side == Side::front || side == Side::rear;
    WallPlan& wall = plan.walls[static_cast<std::size_t>(side)];
    wall.side = side;
    wall.bearing = is_bearing;
    wall.length = plan.outer[is_bearing ? 0 : 1];
    wall.thickness = is_bearing ? bearing : nonbearing;
    wall.corner = is_bearing ? nonbearing : bearing;
  }
}

/// Which walls are built, and where they meet.
void choose_walls(const House& house, HousePlan& plan) {
  for (WallPlan& wall : plan.walls) wall.built = false;
  for (std::size_t i = 0; i < house.walls.size(); ++i) {
    const auto named = [&](const WallPlan& wall) { return house.walls[i] == name(wall.side); };
    const auto wall = std::find_if(plan.walls.begin(), plan.walls.end(), named);
    const std::string key = indexed_key("house.walls", i, "");
    if (wall == plan.walls.end()) throw InputError(key, quoted(house.walls[i]) + " is no wall; allowed: front, right, rear, left");
    if (wall->built) throw InputError(key, quoted(house.walls[i]) + " is given twice");
    wall->built = true;
  }
  if (house.walls.empty()) throw InputError("house.walls", "names no wall; allowed: front, right, rear, left");
  for (WallPlan& wall : plan.walls) {
    wall.meets = wall.bearing ? std::array{plan.wall(Side::left).built, plan.wall(Side::right).built}
                              : std::array{plan.wall(Side::front).built, plan.wall(Side::rear).built};
  }
}

void plan_copies(const House& house, HousePlan& plan) {
  const double quarters = house.turn / 90.0;
  if (!std::isfinite(quarters) || quarters != std::floor(quarters) || std::abs(quarters) > 1e6) {
    throw InputError("house.turn", text(house.turn) + " degrees is not a multiple of 90; nearest: " +
                                       text(std::isfinite(quarters) ? 90.0 * std::fmod(std::round(quarters), 4.0) : 0.0));
  }
  plan.quarter_turns = ((static_cast<int>(quarters) % 4) + 4) % 4;
  double count = 1.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!std::isfinite(house.origin[axis]) || std::abs(house.origin[axis]) > 1e6) {
      throw InputError("house.origin", text(house.origin[axis]) + " m is out of range; allowed: -1e6 to 1e6");
    }
    if (house.copies[axis] < 1) throw InputError("house.copies", std::to_string(house.copies[axis]) + " copies; at least 1");
    count *= house.copies[axis];
    const double size = metres(plan.outer[plan.quarter_turns % 2 == 0 ? axis : 1 - axis]);
    if (house.copies[axis] > 1 && !(house.spacing[axis] >= size && house.spacing[axis] <= kLongest)) {
      throw InputError("house.spacing", text(house.spacing[axis]) + " m makes the copies overlap along " + (axis == 0 ? "x" : "y") +
                                            "; at least " + text(size) + " m, the outer size of the house, at most " + text(kLongest) +
                                            " m");
    }
  }
  const double area = 2.0 * metres(plan.outer[0]) * house.bearing_wall + 2.0 * house.inner_size[1] * house.nonbearing_wall;
  const std::array<double, 3> brick = brick_with_mortar(house);
  const double elements = count * area * house.height / (brick[0] * brick[1] * brick[2]);
  if (elements > kMostElements) {
    throw InputError("house", "would have about " + text(std::round(elements)) + " bricks; at most " + text(kMostElements));
  }
}

}  // namespace

Tick ticks(double metres) noexcept { return std::llround(metres * kTicksPerMetre); }

double metres(Tick t) noexcept { return static_cast<double>(t) / kTicksPerMetre; }

const char* name(Side side) noexcept {
  switch (side) {
    case Side::front:
      return "front";
    case Side::right:
      return "right";
    case Side::rear:
      return "rear";
    case Side::left:
      return "left";
  }
  return "";
}

Tick positive_length(double value, const std::string& key) {
  // Four ticks, so that a quarter of a brick is still one.
  if (!(value >= 4.0 / kTicksPerMetre && value <= kLongest)) {
    throw InputError(key, text(value) + " m is out of range; allowed: above 0, at most " + text(kLongest) + " m");
  }
  return ticks(value);
}

Tick multiple_of(double value, Tick unit, const std::string& key, const char* unit_name) {
  const Tick length = positive_length(value, key);
  if (length % unit != 0) {
    const Tick nearest = std::max<Tick>(1, (length + unit / 2) / unit) * unit;
    throw InputError(key, text(value) + " m is not a whole number of " + unit_name + " of " + text(metres(unit)) +
                              " m; nearest: " + text(metres(nearest)) + " m");
  }
  return length;
}

std::array<double, 3> brick_with_mortar(const House& house) noexcept {
  return {house.brick[0] + house.mortar, house.brick[1] + house.mortar, house.brick[2] + house.mortar};
}

Tick element_length(double value, Tick member, const std::string& key) {
  const Tick length = positive_length(value, key);
  const Tick least = std::max<Tick>(4, member / 1000);
  if (length < least)
    throw InputError(
        key, text(value) + " m would cut " + text(metres(member)) + " m into more than 1000 parts; at least " + text(metres(least)) + " m");
  return length;
}

std::vector<Interval> free_spans(const HousePlan& plan, const WallPlan& wall, int course) {
  std::vector<Interval> spans;
  if (!wall.built) return spans;
  const bool through = wall.bearing == (course % 2 == 0);
  const Interval height = plan.courses[static_cast<std::size_t>(course)];
  Tick from = through || !wall.meets[0] ? 0 : wall.corner;
  const Tick end = wall.length - (through || !wall.meets[1] ? 0 : wall.corner);
  for (const Hole& hole : wall.holes) {  // ascending along the wall
    if (!hole.height.overlaps(height)) continue;
    if (hole.along.low > from) spans.push_back({from, hole.along.low});
    from = hole.along.high;
  }
  if (end > from) spans.push_back({from, end});
  return spans;
}

std::vector<Interval> cut_member(Interval member, Tick element) {
  std::vector<Interval> parts;
  Tick at = member.low;
  for (; at + element <= member.high; at += element) parts.push_back({at, at + element});
  const Tick rest = member.high - at;
  if (rest > 0 && 2 * rest < element && !parts.empty()) {
    Interval& last = parts.back();
    last.high = last.low + (element + rest) / 2;
    at = last.high;
  }
  if (at < member.high) parts.push_back({at, member.high});
  return parts;
}

HousePlan plan_house(const House& house) {
  HousePlan plan;
  plan_bricks(house, plan);
  plan_walls(house, plan);
  choose_walls(house, plan);
  plan_copies(house, plan);
  plan_openings(house, plan);
  return plan;
}

}  // namespace voussoir::cases
