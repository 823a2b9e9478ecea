// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_rods.h"

#include <cmath>
#include <string>

#include "cases/names.h"
#include "cases/walls/spans/wall_bays.h"

namespace voussoir::cases {
namespace {

/// The rods of one [[wall_tie]].
class WallRods {
 public:
  WallRods(const std::vector<WallSpec>& walls, const WallsPlan& plan, const HouseTie& tie, std::size_t index, double foot)
      : walls_(walls), plan_(plan), tie_(tie), what_{"wall_tie", index}, foot_(foot) {}

  std::vector<PlannedTie> all() {
    for (std::size_t i = 0; i < tie_.heights.size(); ++i) {
      if (tie_.kind == HouseTieKind::along) along(i);
      if (tie_.kind == HouseTieKind::across) across(i);
    }
    if (rods_.size() == 1) rods_[0].tie.name = tie_.bar.name;
    return rods_;
  }

 private:
  [[nodiscard]] std::string key(const char* list, std::size_t i) const { return indexed_key(what_.key(list), i, ""); }

  void add(Vec3 from, Vec3 to, double height, const std::string& place) {
    Tie tie = tie_.bar;
    from.z = to.z = height + foot_;
    tie.from = from, tie.to = to;
    tie.name += " " + std::to_string(rods_.size() + 1) + ", " + place + " at " + text(height) + " m";
    rods_.push_back({tie, what_.index});
  }
  /// Refuses a height at which a side does not stand. \param s  where the rod is or ends
  void check_height(const Leg& leg, double s, std::size_t height) const {
    const Tick at = ticks(tie_.heights[height]), top = ticks(leg.highest(s, s));
    if (at > leg.height.low && at < top) return;
    throw InputError(key("heights", height), text(tie_.heights[height]) + " m: the " + leg.tag + " stands from " +
                                                 metres_text(leg.height.low) + " to " + metres_text(top) + " m above the base there");
  }

  void along(std::size_t height) {
    if (tie_.walls.empty()) throw InputError(what_.key("walls"), "names no side; wanted one or more");
    for (std::size_t k = 0; k < tie_.walls.size(); ++k) {
      const Leg& leg = plan_.legs[find_side(walls_, plan_, tie_.walls[k], key("walls", k))];
      if (leg.facets.size() > 1) throw InputError(key("walls", k), quoted(tie_.walls[k]) + " bends; rods are straight");
      if (tie_.depth && *tie_.depth > 2.0 * leg.half)
        throw InputError(what_.key("depth"),
                         text(*tie_.depth) + " m is more than the thickness of the " + leg.tag + ", " + text(2.0 * leg.half) + " m");
      const double d = leg.half - tie_.depth.value_or(leg.half);
      const Station *first = leg.end(LegEnd::low), *last = leg.end(LegEnd::high);
      const double from = first == nullptr ? 0.0 : first->low(d), to = last == nullptr ? leg.length() : last->high(d);
      for (const double s : {0.0, 0.5 * leg.length(), leg.length()}) check_height(leg, s, height);
      add(leg.at(from, d), leg.at(to, d), tie_.heights[height], leg.tag);
    }
  }

  void across(std::size_t height) {
    const Bay bay = find_bay(walls_, plan_, what_, tie_.walls, std::nullopt, {});
    const Leg &a = plan_.legs[bay.faces[0].leg], &b = plan_.legs[bay.faces[1].leg];
    for (std::size_t i = 0; i < tie_.at.size(); ++i) {
      const double start = a.place(0.0), s = tie_.at[i] - start;
      if (s < -kPlanTolerance || s > a.length() + kPlanTolerance)
        throw InputError(key("at", i), text(tie_.at[i]) + " m is not in the " + a.tag + "; allowed: " + text(start) + " to " +
                                           text(std::round((start + a.length()) * 1e4) * 1e-4) + " m along the line of the wall");
      const Vec3 from = a.at(s, -bay.faces[0].d);
      const double u = dot(from - bay.from, bay.across);
      if (u < bay.low - kPlanTolerance || u > bay.high + kPlanTolerance)
        throw InputError(key("at", i), text(tie_.at[i]) + " m: a rod from there, square to the " + a.tag + ", does not meet the " + b.tag);
      const Vec3 to = bay.at(u, v_of(plan_, bay, {bay.faces[1].leg, -bay.faces[1].d}, u));
      check_height(a, s, height), check_height(b, dot(to - b.at(0.0, 0.0), b.facets[0].along), height);
      add(from, to, tie_.heights[height], a.tag + " to " + b.tag + ", " + text(tie_.at[i]) + " m along,");
    }
  }

  const std::vector<WallSpec>& walls_;
  const WallsPlan& plan_;
  const HouseTie& tie_;
  Spanning what_;
  double foot_;
  std::vector<PlannedTie> rods_;
};

}  // namespace

std::vector<PlannedTie> wall_rods(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<HouseTie>& ties,
                                  double foot) {
  std::vector<PlannedTie> all;
  Faults faults;
  for (std::size_t i = 0; i < ties.size(); ++i) {
    faults.attempt([&] {
      for (PlannedTie& rod : WallRods(walls, plan, ties[i], i, foot).all()) all.push_back(std::move(rod));
    });
  }
  faults.raise();
  return all;
}

}  // namespace voussoir::cases
