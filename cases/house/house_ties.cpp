// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_ties.h"

#include <algorithm>
#include <utility>

#include "cases/house/house_parts.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr std::array kSides{Side::front, Side::right, Side::rear, Side::left};

Side opposite(Side side) { return kSides[(static_cast<std::size_t>(side) + 2) % 4]; }

/// Ends of a rod in axes of the house.
struct Rod {
  Vec3 from, to;
  std::string place;  // "front wall at 2.9 m"
};

/// A point of a wall in axes of the house [m].
Vec3 in_wall(const HousePlan& plan, const WallPlan& wall, double along, double depth, double height) noexcept {
  const auto at = [](double v) { return Interval{ticks(v), ticks(v)}; };
  const HouseBox box = in_house(plan, wall, at(along), at(depth), at(height));
  return {metres(box.x.low), metres(box.y.low), metres(box.z.low)};
}

bool is_inner_wall(const House& house, const std::string& name) {
  return std::ranges::any_of(house.inner_walls, [&](const InnerWall& w) { return w.name == name; });
}

/// The side of the house that has this name, and is built. \param names  of walls that are allowed here \throw InputError
Side built_side(const HousePlan& plan, const std::string& wall, const std::vector<std::string>& names, const std::string& key) {
  const auto side = std::ranges::find_if(kSides, [&](Side s) { return wall == name(s); });
  if (side == kSides.end()) {
    std::string allowed;
    for (const std::string& one : names) allowed += (allowed.empty() ? "" : ", ") + quoted(one);
    throw InputError(key, quoted(wall) + " is no wall; " + did_you_mean(wall, names) + "allowed: " + allowed);
  }
  if (!plan.wall(*side).built) throw InputError(key, quoted(wall) + " is not built (house.walls)");
  return *side;
}

const std::vector<std::string>& side_names() {
  static const std::vector<std::string> names{"front", "right", "rear", "left"};
  return names;
}

/// Sides of the house that a tie names beside inner walls; all that are built if it names no wall. \throw InputError for what is no wall
std::vector<Side> outer_walls(const House& house, const HousePlan& plan, const HouseTie& tie, const std::string& key) {
  std::vector<std::string> names = side_names(), outer;
  if (tie.kind == HouseTieKind::along) {
    for (const InnerWall& inner : house.inner_walls) names.push_back(inner.name);
  }
  for (std::size_t i = 0; i < tie.walls.size(); ++i) {
    const std::string& wall = tie.walls[i];
    const std::string at = key + ".walls[" + std::to_string(i) + "]";
    if (!is_inner_wall(house, wall)) {
      built_side(plan, wall, names, at);
      outer.push_back(wall);
    } else if (tie.kind != HouseTieKind::along) {
      throw InputError(at, quoted(wall) + " is an inner wall; kind = \"along\" ties one, other kinds join outer walls");
    }
  }
  if (outer.empty() && !tie.walls.empty()) return {};
  return chosen_walls(plan, outer, key);
}

/// The walls, outer ones first, that have a rod of a tie of kind "along" at this height [m] above the foot of the house.
std::vector<const WallPlan*> walls_along(const House& house, const HousePlan& plan, const HouseTie& tie, const std::vector<Side>& outer,
                                         double height) {
  std::vector<const WallPlan*> all;
  const Tick at = ticks(height);
  for (const Side side : outer) all.push_back(&plan.wall_at(side, at));
  for (const WallPlan& wall : plan.walls) {
    if (wall.inner < 0 || at < wall.height.low || at >= wall.height.high) continue;
    if (std::ranges::find(tie.walls, nth(house.inner_walls, wall.inner).name) != tie.walls.end()) all.push_back(&wall);
  }
  return all;
}

/// Selects the walls, and makes the rods, of one [[house.tie]].
class Rods {
 public:
  Rods(const House& house, const HousePlan& plan, const HouseTie& tie, std::string key)
      : house_(house), plan_(plan), tie_(tie), key_(std::move(key)), walls_(outer_walls(house, plan, tie, key_)) {
    refuse_heights();
  }

  std::vector<Rod> all() {
    for (const double height : tie_.heights) {
      if (tie_.kind == HouseTieKind::along) along(height);
      if (tie_.kind == HouseTieKind::across) across(height);
      if (tie_.kind == HouseTieKind::corner) corners(height);
    }
    if (rods_.empty())
      throw InputError(key_, tie_.kind == HouseTieKind::along ? "makes no tie: none of its walls stands at these heights"
                                                              : "makes no tie: no two of its walls meet in a corner");
    return rods_;
  }

 private:
  static std::string at_height(double height) { return " at " + text(height) + " m"; }
  /// Without its storey, which the height tells.
  [[nodiscard]] std::string rod_wall(const WallPlan& wall) const {
    const std::string whole = wall_name(house_, wall);
    return whole.substr(0, whole.find(','));
  }
  [[nodiscard]] Vec3 point(Side side, double along, double depth, double height) const {
    return on_wall(plan_, side, along, depth, height);
  }
  [[nodiscard]] double length(Side side) const { return metres(plan_.wall(side).length); }
  /// Refuses heights above the walls and a flat roof on them; other roofs have gables, which rise higher.
  void refuse_heights() const {
    const bool flat = house_.roof.kind == RoofKind::flat;
    if (house_.roof.kind != RoofKind::none && !flat) return;
    const Tick top = plan_.storeys.back().high + (flat ? ticks(house_.roof.beam[1]) : Tick{0});
    for (std::size_t i = 0; i < tie_.heights.size(); ++i) {
      if (ticks(tie_.heights[i]) > top)
        throw InputError(key_ + ".heights[" + std::to_string(i) + "]",
                         text(tie_.heights[i]) + " m is above the house; at most " + metres_text(top) + " m");
    }
  }
  void along(double height) {
    for (const WallPlan* wall : walls_along(house_, plan_, tie_, walls_, height)) {
      const double depth = tie_.depth.value_or(0.5 * metres(wall->thickness));
      const auto end = [&](Tick along) { return in_wall(plan_, *wall, metres(along), depth, height); };
      rods_.push_back({end(wall->from), end(wall->from + wall->length), rod_wall(*wall) + at_height(height)});
    }
  }
  void across(double height) {
    for (const Side side : walls_) {
      const Side other = opposite(side);
      const auto first = std::ranges::find(walls_, side), second = std::ranges::find(walls_, other);
      if (second < first) continue;  // the rods were added from the opposite wall
      if (!plan_.wall(other).built)
        throw InputError(key_, "runs across from the " + std::string(name(side)) + " wall, but the " + name(other) + " wall is not built");
      for (std::size_t i = 0; i < tie_.at.size(); ++i) {
        if (tie_.at[i] > length(side))
          throw InputError(key_ + ".at[" + std::to_string(i) + "]",
                           text(tie_.at[i]) + " m is beyond the end of the " + name(side) + " wall (" + text(length(side)) + " m)");
        rods_.push_back({point(side, tie_.at[i], 0.0, height), point(other, tie_.at[i], 0.0, height),
                         std::string(name(side)) + " to " + name(other) + " wall, " + text(tie_.at[i]) + " m along," + at_height(height)});
      }
    }
  }
  void corners(double height) {
    const auto has = [&](Side side) { return std::ranges::find(walls_, side) != walls_.end(); };
    for (const Side a : {Side::front, Side::rear}) {
      for (const Side b : {Side::left, Side::right}) {
        if (!has(a) || !has(b)) continue;
        for (const Side side : {a, b}) {
          if (tie_.reach > length(side))
            throw InputError(key_ + ".reach",
                             text(tie_.reach) + " m is beyond the end of the " + name(side) + " wall (" + text(length(side)) + " m)");
        }
        const double on_a = b == Side::left ? tie_.reach : length(a) - tie_.reach,
                     on_b = a == Side::front ? tie_.reach : length(b) - tie_.reach;
        rods_.push_back({point(a, on_a, 0.0, height), point(b, on_b, 0.0, height),
                         std::string(name(a)) + " " + name(b) + " corner" + at_height(height)});
      }
    }
  }

  const House& house_;
  const HousePlan& plan_;
  const HouseTie& tie_;
  std::string key_;
  std::vector<Side> walls_;
  std::vector<Rod> rods_;
};

}  // namespace

std::vector<Side> chosen_walls(const HousePlan& plan, const std::vector<std::string>& walls, const std::string& key) {
  for (std::size_t i = 0; i < walls.size(); ++i) built_side(plan, walls[i], side_names(), key + ".walls[" + std::to_string(i) + "]");
  std::vector<Side> chosen;
  for (const Side side : kSides) {
    const bool named = walls.empty() || std::ranges::find(walls, name(side)) != walls.end();
    if (named && plan.wall(side).built) chosen.push_back(side);
  }
  return chosen;
}

Vec3 on_wall(const HousePlan& plan, Side side, double along, double depth, double height) noexcept {
  return in_wall(plan, plan.wall(side), along, depth, height);
}

void check_house_ties(const House& house) {
  if (house.ties.empty()) return;
  Faults of_house, faults;
  HousePlan plan;
  if (!of_house.attempt([&] { plan = plan_as_far_as_possible(house); })) return;  // told where the house is built
  for (std::size_t k = 0; k < house.ties.size(); ++k)
    faults.attempt([&] { Rods(house, plan, house.ties[k], indexed_key("house.tie", k, "")); });
  faults.raise();
}

std::vector<PlannedTie> house_ties(const House& house, double foot) {
  std::vector<PlannedTie> all;
  if (house.ties.empty()) return all;
  const HousePlan plan = plan_house(house);
  for (std::size_t k = 0; k < house.ties.size(); ++k) {
    const HouseTie& tie = house.ties[k];
    const std::string key = indexed_key("house.tie", k, "");
    const std::vector<Rod> rods = Rods(house, plan, tie, key).all();
    const std::size_t first = all.size();
    for (int j = 0; j < house.copies[1]; ++j) {
      for (int i = 0; i < house.copies[0]; ++i) {
        for (const Rod& rod : rods) {
          Tie placed = tie.bar;
          placed.from = in_case(house, plan, i, j, rod.from) + Vec3{0, 0, foot};
          placed.to = in_case(house, plan, i, j, rod.to) + Vec3{0, 0, foot};
          placed.name += " " + std::to_string(all.size() - first + 1) + ", " + rod.place;
          all.push_back({placed, k});
        }
      }
    }
    if (all.size() - first == 1) all.back().tie.name = tie.bar.name;
  }
  return all;
}

std::vector<InputError> rods_in_openings(const House& house) {
  std::vector<InputError> found;
  if (house.ties.empty()) return found;
  const HousePlan plan = plan_house(house);
  const auto look = [&](const HouseTie& tie, const std::string& key, const WallPlan& wall, double height) {
    const Tick at = ticks(height);
    if (tie.depth.value_or(0.0) >= metres(wall.thickness)) return;  // inside the room
    for (const Hole& h : wall.holes) {
      if (h.lintel || h.floor >= 0 || h.ground >= 0) continue;
      const Tick top = h.arch ? h.height.low + ticks(house.openings[h.opening].arch->rise) : h.height.high;  // upper edge of the open area
      if (h.height.low < at && at < top)
        found.emplace_back(key + ".heights", "the rod along the " + wall_name(house, wall) + " at " + text(height) + " m runs through " +
                                                 indexed_key("house.opening", h.opening, ""));
    }
  };
  for (std::size_t k = 0; k < house.ties.size(); ++k) {
    const HouseTie& tie = house.ties[k];
    if (tie.kind != HouseTieKind::along) continue;
    const std::string key = indexed_key("house.tie", k, "");
    const std::vector<Side> outer = outer_walls(house, plan, tie, key);
    for (const double height : tie.heights) {
      for (const WallPlan* wall : walls_along(house, plan, tie, outer, height)) look(tie, key, *wall, height);
    }
  }
  return found;
}

}  // namespace voussoir::cases
