// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_plan.h"

#include <algorithm>
#include <cmath>

#include "cases/house/house_inner_walls.h"
#include "cases/house/house_openings.h"
#include "cases/house/house_thickness.h"
#include "cases/house/house_wall.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr double kTicksPerMetre = 1e9;
constexpr double kLongest = 1e4;       // m; far above any house, far below the overflow of a Tick
constexpr double kFarOff = 1e7;        // m, from the origin of the axes: as kFarthest of cases/solids/origin.h
constexpr double kMostElements = 2e7;  // limit, so that a mistyped brick size does not exhaust the memory

/// Refuses a brick format in which two widths and the joint between them are not one length.
void refuse_format(const House& house) {
  const double length = house.brick[0], width = house.brick[1], joint = length - 2.0 * width;
  const std::string with_mortar = house.mortar == 0.0 ? "" : " and mortar of " + text(house.mortar) + " m";
  const std::string fitting = joint > 0.0 && joint < 0.25 * house.brick[2] ? ", mortar = " + text(metres(ticks(joint))) : "";
  const char* bond = house.bond == Bond::header ? "header" : house.bond == Bond::flemish ? "Flemish" : "English";
  throw InputError("house.brick", std::string(bond) + " bond needs bricks twice as long as wide, each with its mortar, not " +
                                      text(length) + " x " + text(width) + " m" + with_mortar + "; nearest: [" +
                                      text(2.0 * width + house.mortar) + ", " + text(width) + ", " + text(house.brick[2]) + "]" + fitting +
                                      ", or bond = \"running\"");
}

void check_rubble(const House& house) {
  if (house.halves) throw InputError("house.halves", "true does not go with bond = \"rubble\"; allowed: false");
  if (house.cells) throw InputError("house.cells", "does not go with bond = \"rubble\", whose stones stay whole; leave the key out");
  if (!house.rubble) return;
  for (const auto& [key, share] : {std::pair{"irregularity", house.rubble->irregularity}, std::pair{"through", house.rubble->through}}) {
    if (!(share >= 0.0 && share <= 1.0)) throw InputError(std::string("house.rubble.") + key, text(share) + "; allowed: 0 to 1");
  }
}

void plan_bricks(const House& house, HousePlan& plan) {
  plan.bond = house.bond;
  const Tick mortar = house.mortar == 0.0 ? 0 : positive_length(house.mortar, "house.mortar");
  plan.brick_length = positive_length(house.brick[0], "house.brick") + mortar;
  plan.brick_width = positive_length(house.brick[1], "house.brick") + mortar;
  plan.brick_height = positive_length(house.brick[2], "house.brick") + mortar;
  if (mortar >= plan.brick_height - mortar) {
    plan.faults.add({"house.mortar", text(house.mortar) + " m is not less than the height of a brick (" + text(house.brick[2]) + " m)"});
  }
  if (house.bond == Bond::rubble) plan.faults.attempt([&] { check_rubble(house); });
  if (house.bond != Bond::running && house.bond != Bond::rubble && plan.brick_length != 2 * plan.brick_width) {
    plan.faults.attempt([&] { refuse_format(house); });
    plan.brick_length = 2 * plan.brick_width;  // as the remedy says; what follows is judged by it
  }
  if (plan.brick_length < plan.brick_width) {
    throw InputError("house.brick",
                     "a brick must not be wider (" + text(house.brick[1]) + " m) than long (" + text(house.brick[0]) + " m)");
  }
}

/// Sets the heights of the storeys, from the bottom up.
void plan_storeys(const House& house, HousePlan& plan) {
  plan.height = positive_length(house.height, "house.height");
  plan.storeys = {{0, plan.height}};
  for (std::size_t i = 0; i < house.storeys.size(); ++i) {
    const Tick height = positive_length(house.storeys[i].height, indexed_key("house.storey", i, "height"));
    plan.storeys.push_back({plan.height, plan.height + height});
    plan.height += height;
  }
}

/// Thicknesses of the bearing and the other walls, by storey.
std::vector<std::array<Tick, 2>> plan_thicknesses(const House& house, HousePlan& plan) {
  std::vector<std::array<Tick, 2>> all{{wall_thickness(house.bearing_wall, plan, "house.bearing_wall", plan.faults),
                                        wall_thickness(house.nonbearing_wall, plan, "house.nonbearing_wall", plan.faults)}};
  for (std::size_t i = 0; i < house.storeys.size(); ++i) {
    const std::array given{house.storeys[i].bearing_wall, house.storeys[i].nonbearing_wall};
    std::array<Tick, 2> here = all.back();
    for (std::size_t k = 0; k < 2; ++k) {
      if (!given[k]) continue;
      const std::string key = indexed_key("house.storey", i, k == 0 ? "bearing_wall" : "nonbearing_wall");
      here[k] = wall_thickness(*given[k], plan, key, plan.faults);
      if (here[k] <= all.back()[k]) continue;
      plan.faults.add({key, text(*given[k]) + " m is thicker than the wall below; at most " + text(metres(all.back()[k])) + " m"});
      here[k] = all.back()[k];
    }
    all.push_back(here);
  }
  return all;
}

void plan_walls(const House& house, HousePlan& plan) {
  const std::vector<std::array<Tick, 2>> thicknesses = plan_thicknesses(house, plan);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Tick inner = positive_length(house.inner_size[axis], "house.inner_size");
    if (inner < plan.shortest_piece()) {
      throw InputError("house.inner_size", text(house.inner_size[axis]) + " m is less than half a brick; at least " +
                                               text(metres(plan.shortest_piece())) + " m");
    }
    plan.outer[axis] = inner + 2 * thicknesses[0][axis == 0 ? 1 : 0];
  }
  for (std::size_t storey = 0; storey < plan.storeys.size(); ++storey) {
    const auto [bearing, nonbearing] = thicknesses[storey];
    for (const Side side : {Side::front, Side::right, Side::rear, Side::left}) {
      WallPlan& wall = plan.walls.emplace_back();
      wall.side = side;
      wall.storey = static_cast<int>(storey);
      wall.along_x = side == Side::front || side == Side::rear;
      wall.length = plan.outer[wall.along_x ? 0 : 1];
      wall.thickness = wall.along_x ? bearing : nonbearing;
      wall.corner = wall.along_x ? nonbearing : bearing;
      wall.height = plan.storeys[storey];
    }
    plan_inner_walls(house, static_cast<int>(storey), plan);
  }
}

/// Marks the outer walls that are built.
void choose_walls(const House& house, HousePlan& plan) {
  std::array<bool, 4> built{};
  for (std::size_t i = 0; i < house.walls.size(); ++i) {
    std::size_t side = 0;
    while (side < 4 && house.walls[i] != name(static_cast<Side>(side))) ++side;
    const std::string key = indexed_key("house.walls", i, "");
    if (side == 4)
      throw InputError(key, quoted(house.walls[i]) + " is no wall; " + did_you_mean(house.walls[i], {"front", "right", "rear", "left"}) +
                                "allowed: front, right, rear, left");
    if (built[side]) throw InputError(key, quoted(house.walls[i]) + " is given twice");
    built[side] = true;
  }
  if (house.walls.empty()) throw InputError("house.walls", "names no wall; allowed: front, right, rear, left");
  const auto has = [&](Side side) { return nth(built, side); };
  for (WallPlan& wall : plan.walls) {
    wall.built = !wall.outer() || has(wall.side);
    wall.meets = wall.along_x ? std::array{has(Side::left), has(Side::right)} : std::array{has(Side::front), has(Side::rear)};
  }
}

/// Finds where walls of a storey meet and cross.
void plan_crossings(HousePlan& plan) {
  for (WallPlan& wall : plan.walls) {
    if (wall.pier >= 0) continue;
    if (wall.meets[0]) wall.crossings.push_back({{0, wall.corner}, wall.height});
    for (const WallPlan& other : plan.walls) {
      if (other.inner >= 0 && other.storey == wall.storey && other.along_x != wall.along_x)
        wall.crossings.push_back({{other.at, other.at + other.thickness}, wall.height});
    }
    if (wall.meets[1]) wall.crossings.push_back({{wall.length - wall.corner, wall.length}, wall.height});
  }
}

/// Distance by which piers extend the house beyond the walls along an axis.
Tick beyond(const HousePlan& plan, std::size_t axis) {
  Tick before = 0, behind = 0;
  for (const WallPlan& wall : plan.walls) {
    if (wall.pier < 0 || wall.along_x != (axis == 0)) continue;
    before = std::max(before, -wall.from), behind = std::max(behind, wall.from + wall.length - plan.outer[axis]);
  }
  return before + behind;
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
    if (!std::isfinite(house.origin[axis]) || std::abs(house.origin[axis]) > kFarOff) {
      throw InputError("house.origin", text(house.origin[axis]) + " m is out of range; allowed: -1e7 to 1e7");
    }
    if (house.copies[axis] < 1) throw InputError("house.copies", std::to_string(house.copies[axis]) + " copies; at least 1");
    count *= house.copies[axis];
    const std::size_t own = plan.quarter_turns % 2 == 0 ? axis : 1 - axis;
    const double size = metres(plan.outer[own] + beyond(plan, own));
    if (house.copies[axis] > 1 && !(house.spacing[axis] >= size && house.spacing[axis] <= kLongest)) {
      throw InputError("house.spacing", text(house.spacing[axis]) + " m makes the copies overlap along " + (axis == 0 ? "x" : "y") +
                                            "; at least " + text(size) + " m, the outer size of the house, at most " + text(kLongest) +
                                            " m");
    }
  }
  double volume = 0.0;
  for (const WallPlan& wall : plan.walls) volume += metres(wall.length) * metres(wall.thickness) * metres(wall.height.length());
  const std::array<double, 3> brick = brick_with_mortar(house);
  const double elements = count * volume / (brick[0] * brick[1] * brick[2]);
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
  // At least four ticks, so that a quarter of a brick is not zero.
  if (!(value >= 4.0 / kTicksPerMetre && value <= kLongest)) {
    throw InputError(key, text(value) + " m is out of range; allowed: above 0, at most " + text(kLongest) + " m");
  }
  return ticks(value);
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

std::string metres_text(Tick t) { return text(metres(t)); }
std::string from_to(Interval i) { return "from " + metres_text(i.low) + " to " + metres_text(i.high) + " m"; }

const WallPlan& HousePlan::wall(Side side, int storey) const noexcept {
  const auto is_it = [&](const WallPlan& w) { return w.outer() && w.storey == storey && w.side == side; };
  return *std::ranges::find_if(walls, is_it);
}

const WallPlan& HousePlan::wall_at(Side side, Tick at) const noexcept {
  int storey = 0;
  while (storey + 1 < static_cast<int>(storeys.size()) && at >= nth(storeys, storey).high) ++storey;
  return wall(side, storey);
}

std::string wall_name(const House& house, const WallPlan& wall) {
  if (wall.pier >= 0) return name(wall.side) + std::string(" pier");
  return (wall.inner < 0 ? name(wall.side) : nth(house.inner_walls, wall.inner).name) + std::string(" wall");
}

std::string wall_tag(const House& house, const WallPlan& wall, const char* what) {
  std::string tag = wall_name(house, wall);
  if (wall.pier >= 0) return tag + " " + std::to_string(wall.pier);
  tag.replace(tag.size() - 4, 4, what);
  return house.storeys.empty() ? tag : tag + ", storey " + std::to_string(wall.storey + 1);
}

std::vector<Interval> free_spans(const HousePlan& plan, const WallPlan& wall, int course, Interval depth) {
  std::vector<Interval> gaps;
  const Interval height = nth(plan.courses, course);
  if (!wall.built || !height.overlaps(wall.height)) return gaps;
  if (wall.along_x != (course % 2 == 0)) {
    for (const Crossing& other : wall.crossings)
      if (other.height.overlaps(height)) gaps.push_back(other.along);
  }
  for (const Hole& hole : wall.holes) {
    if (hole.height.overlaps(height) && hole.depth.overlaps(depth)) gaps.push_back(hole.along);
  }
  std::ranges::sort(gaps, {}, &Interval::low);
  std::vector<Interval> spans;
  Tick from = wall.from;
  for (const Interval gap : gaps) {
    if (gap.low > from) spans.push_back({from, gap.low});
    from = std::max(from, gap.high);
  }
  const Tick end = wall.from + wall.length;
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

HousePlan plan_as_far_as_possible(const House& house) {
  HousePlan plan;
  const bool walls = plan.faults.attempt([&] {
    plan_bricks(house, plan);
    plan_storeys(house, plan);
    plan_walls(house, plan);
    choose_walls(house, plan);
  });
  if (!walls) plan.faults.raise();
  plan.faults.attempt([&] { plan_leaves(house, plan); });
  plan_crossings(plan);
  plan_piers(house, plan);
  if (!plan.faults.attempt([&] { plan_copies(house, plan); })) plan.faults.raise();  // it may be too large to go on with
  plan_openings(house, plan);
  return plan;
}

HousePlan plan_house(const House& house) {
  HousePlan plan = plan_as_far_as_possible(house);
  plan.faults.raise();
  return plan;
}

}  // namespace voussoir::cases
