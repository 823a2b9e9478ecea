// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_tops.h"

#include <algorithm>
#include <cmath>

#include "cases/house/house_wall.h"
#include "cases/house/walls/cut_bricks.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr double kFarOff = 1e5;  // m, beyond any wall
constexpr double kLevel = 1e-9;  // m

double foot_of(const WallSpec& wall) { return metres(ticks(wall.base)); }
double eaves_of(const WallSpec& wall) { return metres(ticks(wall.base + wall.height)); }

/// The tops of a wall along its line: place, and height above the base.
Polygon tops_of(const WallSpec& wall, std::size_t index, double length) {
  const double foot = foot_of(wall), eaves = eaves_of(wall);
  Polygon top;
  if (wall.gable) {
    if (ticks(*wall.gable) <= ticks(wall.height))
      throw InputError(wall_key(index, "gable"), text(*wall.gable) + " m is not above the height of the wall, " + text(wall.height) + " m");
    return {{0.0, eaves}, {0.5 * length, foot + *wall.gable}, {length, eaves}};
  }
  for (std::size_t i = 0; i < wall.tops.size(); ++i) {
    const auto& [place, height] = wall.tops[i];
    const std::string key = indexed_key(wall_key(index, "tops"), i, "");
    if (ticks(height) < ticks(wall.height))
      throw InputError(key, text(height) + " m is below the height of the wall; allowed: " + text(wall.height) + " m or more");
    if (place > length + kPlanTolerance)
      throw InputError(key,
                       text(place) + " m lies beyond the line of the wall, which is " + text(std::round(length * 1e4) * 1e-4) + " m long");
    if (i > 0 && place < wall.tops[i - 1][0])
      throw InputError(key, text(place) + " m comes before " + text(wall.tops[i - 1][0]) + " m; places ascend");
    top.push_back({place, foot + height});
  }
  if (top.front().t > eaves) top.insert(top.begin(), {top.front().s, eaves});
  if (top.back().t > eaves) top.push_back({top.back().s, eaves});
  return top;
}

/// The height of a line at a place; at a step that of the side towards `towards`.
double height_at(const Polygon& line, double place, double outside, double towards) {
  if (place < line.front().s || place > line.back().s) return outside;
  double found = outside;
  bool any = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point2 a = line[i], b = line[i + 1];
    if (place < a.s || place > b.s || (b.s - a.s < kPlanTolerance)) continue;
    if (any && towards < 0.0) break;
    found = a.t + (b.t - a.t) * (place - a.s) / (b.s - a.s), any = true;
  }
  if (!any) found = outside;
  if (place == line.front().s && towards < 0.0) return outside;
  if (place == line.back().s && towards > 0.0) return outside;
  return found;
}

/// The part of the tops that lies on a leg, in its own s. At the ends of the leg it goes on level.
Polygon on_leg(const Polygon& tops, const Leg& leg, double eaves) {
  const Facet& first = leg.facets.front();
  const double from = first.place, to = from + leg.length();
  Polygon top{{-kFarOff, height_at(tops, from, eaves, 1.0)}, {0.0, height_at(tops, from, eaves, 1.0)}};
  for (const Point2 p : tops) {
    if (p.s > from + kPlanTolerance && p.s < to - kPlanTolerance) top.push_back({p.s - from, p.t});
  }
  top.push_back({to - from, height_at(tops, to, eaves, -1.0)});
  top.push_back({kFarOff, top.back().t});
  return top;
}

/// Whether the top turns upwards at b, so that what lies on its two sides is not convex together.
bool turns_up(Point2 a, Point2 b, Point2 c) {
  if (b.s - a.s < kPlanTolerance) return c.s - b.s >= kPlanTolerance ? b.t < a.t : true;
  if (c.s - b.s < kPlanTolerance) return c.t > b.t;
  return (c.t - b.t) * (b.s - a.s) > (b.t - a.t) * (c.s - b.s) + kLevel;
}

Hill hill_of(const Polygon& part, double eaves, const std::string& key) {
  Hill hill;
  hill.key = key;
  hill.from = part.front().s, hill.to = part.back().s;
  hill.under = {{hill.from, eaves}, {hill.to, eaves}};
  const std::size_t n = part.size();
  for (std::size_t i = n; i-- > 0;) {
    hill.crown = std::max(hill.crown, part[i].t);
    const bool at_end = i == 0 || i + 1 == n, at_foot = at_end && part[i].t < eaves + kLevel;
    const bool in_side = at_end && part[i].s == part[i == 0 ? 1 : n - 2].s;  // of a step: its side goes on down
    if (!at_foot && !in_side) hill.under.push_back(part[i]);
  }
  return hill;
}

double area_of(const Hill& hill, double low, double high) {
  return geometry::region(part_between(hill.under, low, high, -kFarOff, kFarOff)).area;
}

}  // namespace

double Leg::highest(double from, double to) const noexcept {
  double most = metres(eaves);
  for (const Hill& h : hills) {
    const Polygon part = part_between(h.under, -kFarOff, kFarOff, from, to);
    for (const Point2 p : part) most = std::max(most, p.t);
  }
  return most;
}

Interval height_there(const WallsPlan& plan, const Station& s) {
  const Meeting& m = plan.meetings[s.meeting];
  const Leg& other = plan.legs[s.host ? m.guest : m.host];
  if (other.hills.empty()) return other.height;
  const auto there = std::ranges::find(other.stations, s.meeting, &Station::meeting);
  const double from = std::min(there->low(other.half), there->low(-other.half)),
               to = std::max(there->high(other.half), there->high(-other.half));
  return {other.height.low, ticks(other.highest(from, to))};
}

double Leg::lowest_top(double from, double to) const noexcept {
  double least = highest(from, to);  // a hill is highest within, so its top is lowest at an end
  std::vector<double> places{from, to};
  for (const Hill& h : hills) {
    for (const double s : {h.from, h.to}) {
      if (s > from && s < to) places.push_back(s - kPlanTolerance), places.push_back(s + kPlanTolerance);
    }
  }
  for (const double s : places) least = std::min(least, highest(s - kPlanTolerance, s + kPlanTolerance));
  return least;
}

void raise(const WallSpec& wall, const Polygon& top, const std::string& key, Leg& leg) {
  const double eaves = eaves_of(wall);
  std::vector<Polygon> parts(1);
  for (std::size_t i = 0; i < top.size(); ++i) {
    parts.back().push_back(top[i]);
    if (i > 0 && i + 1 < top.size() && turns_up(top[i - 1], top[i], top[i + 1])) parts.push_back({top[i]});
  }
  for (const Polygon& part : parts) {
    if (part.back().s - part.front().s < kPlanTolerance) continue;
    Hill hill = hill_of(part, eaves, key);
    if (hill.crown < eaves + kLevel) continue;
    if (leg.facets.size() > 1) throw InputError(key, "rises in the " + leg.tag + ", which bends; the tops of sides that bend are level");
    for (const Hill& other : leg.hills) {
      if (hill.from < other.to - kPlanTolerance && hill.to > other.from + kPlanTolerance)
        throw InputError(key, "raises the " + leg.tag + " where " + other.key + " does");
    }
    leg.height.high = std::max(leg.height.high, ticks(hill.crown));
    leg.hills.push_back(std::move(hill));
  }
  std::ranges::sort(leg.hills, {}, &Hill::from);
}

void add_own_tops(const std::vector<WallSpec>& walls, WallsPlan& plan) {
  Faults faults;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (walls[i].tops.empty() && !walls[i].gable) continue;
    const std::string key = wall_key(i, walls[i].gable ? "gable" : "tops");
    faults.attempt([&] {
      double length = 0.0;
      std::size_t sides = 0;
      for (const Leg& leg : plan.legs) length += leg.wall == i ? leg.length() : 0.0, sides += leg.wall == i ? 1 : 0;
      if (walls[i].gable && (sides > 1 || walls[i].closed))
        throw InputError(key, "needs a wall of one side, and " + quoted(walls[i].name) + " has " + std::to_string(sides) +
                                  "; give `tops` along its line");
      const Polygon tops = tops_of(walls[i], i, length);
      for (Leg& leg : plan.legs) {
        if (leg.wall == i) raise(walls[i], on_leg(tops, leg, eaves_of(walls[i])), key, leg);
      }
    });
  }
  faults.raise();
}

void add_top_levels(const WallSpec& wall, const WallsPlan& plan, std::size_t index, std::vector<Level>& levels) {
  for (const Leg& leg : plan.legs) {
    if (leg.wall != index) continue;
    for (const Hill& hill : leg.hills) {
      for (std::size_t i = 0; i < hill.under.size(); ++i) {
        const Point2 p = hill.under[i], q = hill.under[(i + 1) % hill.under.size()];
        if (p.t > eaves_of(wall) + kLevel && std::abs(p.t - q.t) < kLevel)
          levels.push_back({ticks(p.t), hill.key, p.t - foot_of(wall), true});
      }
    }
  }
}

Tick crown_of(const WallsPlan& plan, std::size_t group) {
  Tick most = 0;
  for (const Leg& leg : plan.legs) {
    for (const Hill& hill : leg.hills) {
      if (plan.group[leg.wall] == group) most = std::max(most, ticks(hill.crown));
    }
  }
  return most;
}

void finish_hills(const std::vector<WallSpec>& walls, WallsPlan& plan) {
  Faults faults;
  for (Leg& leg : plan.legs) {
    const WallSpec& wall = walls[leg.wall];
    const Tick eaves = ticks(wall.base + wall.height);
    std::vector<Interval> courses;
    for (const Interval c : plan.courses[plan.group[leg.wall]]) {
      if (c.low >= eaves) courses.push_back(c);
    }
    for (Hill& hill : leg.hills) {
      std::size_t n = 0;
      while (n < courses.size() && metres(courses[n].low) < hill.crown - kLevel) ++n;
      const auto too_little = [&](std::size_t c) {
        const double area = area_of(hill, metres(courses[c].low), std::min(metres(courses[c].high), hill.crown));
        const std::vector<Wythe> layers = wythes_of(wall, plan.bricks[leg.wall], static_cast<int>(c));
        return std::ranges::any_of(layers, [&](const Wythe& w) { return area < 0.5 * metres(w.unit) * metres(courses[c].length()); });
      };
      while (n > 1 && too_little(n - 1)) --n;
      if (n == 0 || (n == 1 && too_little(0)))
        faults.add({hill.key, "rises by " + text(std::round((hill.crown - metres(eaves)) * 1e4) * 1e-4) + " m over " +
                                  text(std::round((std::min(hill.to, leg.length()) - std::max(hill.from, 0.0)) * 1e4) * 1e-4) +
                                  " m of the " + leg.tag + ", which is less than half a brick; let it rise more, or not at all"});
      else
        hill.last = courses[n - 1].low;
    }
  }
  faults.raise();
}

}  // namespace voussoir::cases
