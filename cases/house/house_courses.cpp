// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_courses.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "cases/house/walls/arches.h"
#include "cases/house/walls/rubble.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

/// Levels in the order: foot, tops of storeys, openings in the order of the case, beams of floors, tops of piers.
std::vector<Level> levels_of(const House& house, const HousePlan& plan) {
  std::vector<Level> levels{{}, {plan.storeys[0].high, "house.height", house.height, true}};
  for (std::size_t i = 0; i < house.storeys.size(); ++i)
    levels.push_back({plan.storeys[i + 1].high, indexed_key("house.storey", i, "height"), house.storeys[i].height, true});
  for (std::size_t i = 0; i < house.openings.size(); ++i) {
    if (!plan.opening_stands[i]) continue;
    const Opening& opening = house.openings[i];
    const auto key = [i](const char* field) { return indexed_key("house.opening", i, field); };
    const Tick foot = plan.storeys[static_cast<std::size_t>(opening.storey) - 1].low;
    const Tick sill = foot + ticks(opening.sill), head = sill + ticks(opening.height);
    levels.push_back({sill, key("sill"), opening.sill});
    levels.push_back({head, key("height"), opening.height, true});
    const int on = static_cast<int>(levels.size()) - 1;
    if (opening.lintel) levels.push_back({head + ticks(opening.lintel->height), key("lintel.height"), opening.lintel->height, true, 1, on});
    if (opening.arch) levels.push_back({arch_height(opening, head).high, key("arch.thickness"), opening.arch->thickness, true, 1, on});
  }
  for (std::size_t i = 0; i < house.floors.size(); ++i)
    levels.push_back({plan.floors[i].height.low, indexed_key("house.floor", i, "beam"), house.floors[i].beam[1], true, -1});
  for (std::size_t i = 0; i < house.piers.size(); ++i) {
    if (const std::optional<double> height = house.piers[i].height)
      levels.push_back({ticks(*height), indexed_key("house.pier", i, "height"), *height, true});
  }
  for (std::size_t i = 0; i < house.ground.size(); ++i) {
    const double level = house.ground[i].level;
    const auto stands = [&](const Hole& hole) { return hole.ground == static_cast<std::int32_t>(i); };
    if (std::ranges::any_of(plan.walls, [&](const WallPlan& wall) { return std::ranges::any_of(wall.holes, stands); }))
      levels.push_back({ticks(level), indexed_key("base.part", i, "level"), level, true});
  }
  return levels;
}

/// Whether a course may end at this height beside all of these.
bool fits(Tick at, const std::vector<Tick>& beside, Tick lowest) {
  return std::ranges::all_of(beside, [&](Tick other) { return other == at || std::abs(other - at) >= lowest; });
}

/// The value nearest to that of a level that goes with all others, so that faults told together are mended together: first that which ends
/// the course where `first` does, or makes it as low as it may be; else the nearest. \param beside  heights that stay, or are advised
std::optional<Tick> advised(const Level& first, const Level& later, const std::vector<Tick>& beside, Tick lowest) {
  const auto good = [&](Tick at) {
    const auto holds = [&](Interval i) { return i.low <= at && at <= i.high; };
    return fits(at, beside, lowest) && fits(at - later.below, beside, lowest) &&
           (later.allowed.empty() || std::ranges::any_of(later.allowed, holds));
  };
  const auto height = [&](Tick value) { return later.at + later.sign * (value - ticks(later.value)); };
  const Tick onto = ticks(later.value) + later.sign * (first.at - later.at);
  const Tick simple = later.is_size && onto <= 0 ? lowest : onto;
  if (good(height(simple))) return simple;
  std::vector<Tick> heights;
  for (const Tick other : beside) {
    for (const Tick by : {Tick{0}, -lowest, lowest}) heights.push_back(other + by), heights.push_back(other + by + later.below);
  }
  for (const Interval i : later.allowed) heights.push_back(i.low), heights.push_back(i.high);
  std::optional<Tick> best = later.allowed.empty() ? std::optional(simple) : std::nullopt;
  Tick way = -1;
  for (const Tick at : heights) {
    const Tick value = ticks(later.value) + later.sign * (at - later.at), on = std::abs(at - later.at);
    if ((later.is_size && value <= 0) || !good(at) || (way >= 0 && on >= way)) continue;
    best = value, way = on;
  }
  return best;
}

/// Refuses two levels with less than the least course height between them; the later one in the case is at fault.
InputError too_near(const Level& first, const Level& later, std::optional<Tick> nearest, Tick lowest) {
  return {later.key, text(later.value) + " m needs a bed joint at " + metres_text(later.at) + " m, " +
                         metres_text(std::abs(later.at - first.at)) + " m from " +
                         (first.key.empty() ? "the foot of the walls" : "that of " + first.key) + "; a course of cut bricks is at least " +
                         metres_text(lowest) + " m high" +
                         (nearest ? "; nearest: " + metres_text(*nearest) + " m" : "; no value near it goes with all other levels")};
}

}  // namespace

std::vector<Level> kept_levels(const std::vector<Level>& levels, Tick lowest, Faults& faults) {
  std::vector<Level> good;
  const auto too_near_to = [&](const Level& level) {
    return std::ranges::find_if(good, [&](const Level& earlier) {
      const Tick apart = std::abs(level.at - earlier.at);
      return apart > 0 && apart < lowest;
    });
  };
  std::vector<std::size_t> bad;                           // too near to a good one, or on a level that is
  std::vector<std::optional<Tick>> moves(levels.size());  // how far the advice moves a bad level
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const bool on_bad = levels[i].on >= 0 && std::ranges::find(bad, static_cast<std::size_t>(levels[i].on)) != bad.end();
    if (on_bad || too_near_to(levels[i]) != good.end())
      bad.push_back(i);
    else
      good.push_back(levels[i]);
  }
  std::vector<Tick> beside;
  for (const Level& level : good) beside.push_back(level.at);
  for (const std::size_t i : bad) {
    Level level = levels[i];
    if (level.on >= 0) level.at += nth(moves, level.on).value_or(0);
    const auto near = too_near_to(level);
    const std::optional<Tick> value = near == good.end() ? ticks(level.value) : advised(*near, level, beside, lowest);
    moves[i] = level.at + level.sign * (value.value_or(ticks(level.value)) - ticks(level.value)) - levels[i].at;
    beside.push_back(levels[i].at + *moves[i]);
    if (near != good.end()) faults.add(too_near(*near, level, value, lowest));
  }
  return good;
}

void plan_courses(const House& house, HousePlan& plan) {
  const std::vector<Level> levels = kept_levels(levels_of(house, plan), plan.lowest_course(), plan.faults);
  std::vector<Tick> beds;
  for (const Level& level : levels) beds.push_back(level.at);
  std::ranges::sort(beds);
  beds.erase(std::unique(beds.begin(), beds.end()), beds.end());
  plan.courses.clear();
  for (std::size_t i = 0; i + 1 < beds.size(); ++i) {
    const Interval between{beds[i], beds[i + 1]};
    for (const Interval course : plan.bond == Bond::rubble ? rubble_courses(house, plan, between, static_cast<std::int64_t>(i))
                                                           : cut_member(between, plan.brick_height))
      plan.courses.push_back(course);
  }
}

}  // namespace voussoir::cases
