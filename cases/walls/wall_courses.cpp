// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_courses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include "cases/house/house_courses.h"
#include "cases/house/house_thickness.h"
#include "cases/house/walls/arches.h"
#include "cases/names.h"
#include "cases/walls/wall_meetings.h"
#include "cases/walls/wall_tops.h"

namespace voussoir::cases {
namespace {

constexpr std::size_t kNoOther = static_cast<std::size_t>(-1);
constexpr double kBesideStep = 1e-4, kStep = 1e-3;  // m: from where a top is looked at beside a step; least height of one

std::string opening_key(std::size_t wall, std::size_t opening, const char* field) {
  return indexed_key(wall_key(wall, "opening"), opening, field);
}

/// The legs of a wall.
std::vector<Leg*> legs_of(WallsPlan& plan, std::size_t wall) {
  std::vector<Leg*> all;
  for (Leg& l : plan.legs) {
    if (l.wall == wall) all.push_back(&l);
  }
  return all;
}

/// A stretch of a wall's line, found in a leg.
struct Found {
  Leg* leg = nullptr;
  double low = 0.0;  // m, of s
};

/// The leg that holds a stretch of the wall's line from end to end. The places along a closed wall go on at its first point.
Found find_stretch(const std::vector<Leg*>& legs, double from, double width) {
  for (Leg* leg : legs) {
    for (const Facet& f : leg->facets) {
      if (from < f.place - kPlanTolerance || from > f.place + f.length) continue;
      const double low = f.start + (from - f.place);
      if (low + width <= leg->length() + kPlanTolerance || leg->ring) return {leg, low};
    }
  }
  return {};
}

double line_length(const std::vector<Leg*>& legs) {
  double sum = 0.0;
  for (const Leg* l : legs) sum += l->length();
  return sum;
}

/// A length in messages, to a tenth of a millimetre.
std::string length_text(double v) { return text(std::round(v * 1e4) * 1e-4 + 0.0); }

/// A stretch of a leg in messages, along the wall's line as in the case.
std::string stretch_text(const Leg& leg, double low, double high) {
  return length_text(leg.place(low)) + " to " + length_text(leg.place(high)) + " m";
}

/// A stretch of a leg in which a hole may not lie, with what is there.
struct Obstacle {
  double low = 0.0, high = 0.0;  // m, of s; infinite beyond the ends
  std::string words;
};

const Leg& other_leg(const WallsPlan& plan, const Station& s) {
  const Meeting& m = plan.meetings[s.meeting];
  return plan.legs[s.host ? m.guest : m.host];
}

Obstacle meeting_of(const WallsPlan& plan, const Leg& leg, const Station& s) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const double before = std::min(s.low(leg.half), s.low(-leg.half)), behind = std::max(s.high(leg.half), s.high(-leg.half));
  return {s.end == LegEnd::low ? -kFar : before, s.end == LegEnd::high ? kFar : behind,
          "the " + other_leg(plan, s).tag + " meets it from " + stretch_text(leg, before, behind)};
}

/// Obstacles for a hole in a leg: other openings, the free ends.
std::vector<Obstacle> obstacles_in(const Leg& leg, const LegHole& hole) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  constexpr std::array kKeys{"from", "lintel", "arch"};
  std::vector<Obstacle> all;
  for (const LegHole& other : leg.holes) {
    if (other.opening == hole.opening || !other.height.overlaps(hole.height)) continue;
    all.push_back({other.low, other.high,
                   opening_key(leg.wall, other.opening, kKeys[static_cast<std::size_t>(other.kind)]) + " is from " +
                       stretch_text(leg, other.low, other.high)});
  }
  for (const Hill& h : leg.hills) {  // the upright side of a parapet or a step
    for (const double s : {h.from, h.to}) {
      const double inside = s == h.from ? kBesideStep : -kBesideStep;
      const double here = leg.lowest_top(s + inside, s + inside), outside = leg.lowest_top(s - inside, s - inside);
      if (here > outside + kStep && metres(hole.height.high) > outside + kPlanTolerance)
        all.push_back(
            {s, s, "its top has a step at " + length_text(leg.place(s)) + " m, up from " + length_text(outside) + " m above the base"});
    }
  }
  if (leg.ring) return all;
  if (leg.end(LegEnd::low) == nullptr) all.push_back({-kFar, 0.0, "it begins at " + length_text(leg.place(0.0)) + " m"});
  if (leg.end(LegEnd::high) == nullptr) all.push_back({leg.length(), kFar, "it ends at " + length_text(leg.place(leg.length())) + " m"});
  return all;
}

/// The same, and where other legs meet this one, before them.
std::vector<Obstacle> obstacles_for(const WallsPlan& plan, const Leg& leg, const LegHole& hole) {
  std::vector<Obstacle> all;
  for (const Station& s : leg.stations) {
    if (hole.height.overlaps(height_there(plan, s))) all.push_back(meeting_of(plan, leg, s));
  }
  std::ranges::move(obstacles_in(leg, hole), std::back_inserter(all));
  return all;
}

/// What is in the way of a hole; null: nothing.
const Obstacle* in_the_way(const std::vector<Obstacle>& all, double low, double high, double least) {
  const auto hit = std::ranges::find_if(
      all, [&](const Obstacle& o) { return high > o.low - least + kPlanTolerance && low < o.high + least - kPlanTolerance; });
  return hit == all.end() ? nullptr : &*hit;
}

/// Checks that a hole lies a fifth of a brick or more from others and from where walls meet. \param value  of the key, of which `slope` m
/// move the lower end of the hole by one, and its upper end by `slope_high` \throw InputError at `key`, with the nearest value that fits
void check_place(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, const LegHole& hole, const std::string& key, double value,
                 double slope, double slope_high) {
  const double least = least_piece(wall);
  const std::vector<Obstacle> all = obstacles_for(plan, leg, hole);
  const Obstacle* hit = in_the_way(all, hole.low, hole.high, least);
  if (hit == nullptr) return;
  double nearest = std::numeric_limits<double>::infinity();
  const auto attempt = [&](double change) {
    if (std::isfinite(change) && std::abs(change) < std::abs(nearest) && value + change >= (slope < 0.0 ? least : 0.0) &&
        in_the_way(all, hole.low + slope * change, hole.high + slope_high * change, least) == nullptr)
      nearest = change;
  };
  for (const Obstacle& o : all) attempt((o.high + least - hole.low) / slope), attempt((o.low - least - hole.high) / slope_high);
  throw InputError(key, text(value) + " m: the " + leg.tag + " would be open from " + stretch_text(leg, hole.low, hole.high) +
                            " along the line of the wall, and " + hit->words + "; at least " + text(least) +
                            " m of wall, a fifth of a brick, must lie between them" +
                            (std::isfinite(nearest) ? "; nearest: " + text(std::round((value + nearest) * 1e6) * 1e-6) + " m"
                                                    : "; there is no room for it in this side"));
}

/// Up to which height a hole may reach: the top of the wall, or in a gable or a parapet as high as leaves half a brick above it.
Tick highest_head(const WallSpec& wall, const Leg& leg, double low, double high) {
  const Tick top = ticks(wall.base + wall.height), least = leg.hills.empty() ? 0 : ticks(leg.lowest_top(low, high) - 0.5 * wall.brick[2]);
  return std::max(top, least);
}

/// Adds a hole upon an opening, wider by `beyond` at either side, and as high as a key says.
void add_upon(const WallSpec& wall, const WallsPlan& plan, Leg& leg, const LegHole& under, double beyond, const std::string& key,
              LegHole hole, const std::string& height_key, double height) {
  const Tick foot = ticks(wall.base), top = highest_head(wall, leg, under.low - beyond, under.high + beyond);
  if (hole.height.high > top)
    throw InputError(height_key, text(height) + " m ends at " + metres_text(hole.height.high - foot) + " m, above the wall (" +
                                     metres_text(top - foot) + " m)");
  hole.low = under.low - beyond, hole.high = under.high + beyond, hole.opening = under.opening;
  check_place(wall, plan, leg, hole, key, beyond, -1.0, 1.0);
  leg.holes.push_back(hole);
}

void add_lintel_seat(const WallSpec& wall, const WallsPlan& plan, Leg& leg, const LegHole& under) {
  const auto key = [&](const char* field) { return opening_key(leg.wall, under.opening, field); };
  const WallLintel& lintel = *wall.openings[under.opening].lintel;
  if (!(lintel.bearing >= least_piece(wall)))
    throw InputError(key("lintel.bearing"),
                     text(lintel.bearing) + " m is less than a fifth of a brick; at least " + text(least_piece(wall)) + " m");
  const Tick head = under.height.high, height = positive_length(lintel.height, key("lintel.height"));
  add_upon(wall, plan, leg, under, lintel.bearing, key("lintel.bearing"), {0.0, 0.0, {head, head + height}, 0, HoleKind::lintel},
           key("lintel.height"), lintel.height);
}

void add_arch_frame(const WallSpec& wall, const WallsPlan& plan, Leg& leg, const LegHole& under) {
  const auto key = [&](const char* field) { return opening_key(leg.wall, under.opening, field); };
  const WallOpening& o = wall.openings[under.opening];
  if (leg.facets.size() > 1) throw InputError(key("arch"), "stands in a side that bends; arches stand in straight ones");
  const Interval span{ticks(under.low), ticks(under.high)};
  check_arch(*o.arch, plan.bricks[leg.wall], span, key("arch"));
  const Interval frame = arch_frame(*o.arch, under.height.high + (o.lintel ? ticks(o.lintel->height) : 0));
  arch_sections(*o.arch, plan.bricks[leg.wall], span, frame, key("arch"));
  add_upon(wall, plan, leg, under, o.arch->springer, key("arch.springer"), {0.0, 0.0, frame, 0, HoleKind::arch}, key("arch.thickness"),
           o.arch->thickness);
}

void add_opening(const WallSpec& wall, std::size_t index, std::size_t opening, WallsPlan& plan) {
  const WallOpening& o = wall.openings[opening];
  const auto key = [&](const char* field) { return opening_key(index, opening, field); };
  positive_length(o.width, key("width")), positive_length(o.height, key("height"));
  const std::vector<Leg*> legs = legs_of(plan, index);
  const Found found = find_stretch(legs, o.from, o.width);
  if (found.leg == nullptr)
    throw InputError(key("from"), text(o.from) + " m to " + text(o.from + o.width) + " m lie in no one side of the wall, whose line is " +
                                      length_text(line_length(legs)) + " m long; an opening does not go round a corner");
  const Tick foot = ticks(wall.base), sill = foot + ticks(o.sill), head = sill + ticks(o.height),
             top = highest_head(wall, *found.leg, found.low, found.low + o.width);
  if (!(o.sill >= 0.0 && sill < top))
    throw InputError(key("sill"), text(o.sill) + " m; allowed: 0 to below the height of the wall, " + metres_text(top - foot) + " m");
  if (head > top)
    throw InputError(key("height"), text(o.height) + " m ends at " + text(o.sill + o.height) + " m, above the wall (" +
                                        metres_text(top - foot) + " m); at most " + metres_text(top - sill) + " m");
  const LegHole hole{found.low, found.low + o.width, {sill, head}, opening};
  check_place(wall, plan, *found.leg, hole, key("from"), o.from, 1.0, 1.0);
  found.leg->holes.push_back(hole);
  if (o.lintel) add_lintel_seat(wall, plan, *found.leg, hole);
  if (o.arch) add_arch_frame(wall, plan, *found.leg, hole);
}

/// Levels of a wall in the order: foot, top, openings.
void add_levels(const WallSpec& wall, std::size_t index, std::vector<Level>& levels) {
  const Tick foot = ticks(wall.base);
  levels.push_back({foot, wall_key(index, "base"), wall.base});
  levels.push_back({ticks(wall.base + wall.height), wall_key(index, "height"), wall.height, true});
  for (std::size_t i = 0; i < wall.openings.size(); ++i) {
    const WallOpening& o = wall.openings[i];
    const Tick sill = foot + ticks(o.sill), head = sill + ticks(o.height);
    levels.push_back({sill, opening_key(index, i, "sill"), o.sill});
    levels.push_back({head, opening_key(index, i, "height"), o.height, true});
    const Tick springing = head + (o.lintel ? ticks(o.lintel->height) : 0);
    if (o.lintel) levels.push_back({springing, opening_key(index, i, "lintel.height"), o.lintel->height, true});
    if (o.arch) levels.push_back({arch_frame(*o.arch, springing).high, opening_key(index, i, "arch.thickness"), o.arch->thickness, true});
  }
}

/// Levels of the beams that end in a group of walls: their undersides, and their upper faces.
void add_beam_levels(const std::vector<WallFloor>& floors, const WallsPlan& plan, std::size_t group, std::vector<Level>& levels) {
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const bool here = std::ranges::any_of(plan.legs, [&](const Leg& leg) {
      return plan.group[leg.wall] == group && std::ranges::any_of(leg.pockets, [&](const Pocket& p) { return p.floor == i; });
    });
    if (!here) continue;
    const BayFloor& laid = plan.floors[i];
    const Interval height = laid.height;
    const int on = floors[i].level ? static_cast<int>(levels.size()) : -1;
    if (floors[i].level)
      levels.push_back({height.high, indexed_key("floor", i, "level"), *floors[i].level, true, 1, -1, height.length(), laid.levels});
    levels.push_back({height.low, indexed_key("floor", i, "beam"), floors[i].beams.beam[1], true, -1, on, 0, laid.undersides});
  }
}

/// Courses between two levels: equal, and as near to a brick's height as whole numbers allow.
void add_courses(Interval between, Tick brick, Courses& courses) {
  const Tick n = whole_number(between.length(), brick);
  for (Tick i = 0; i < n; ++i) courses.push_back({between.low + between.length() * i / n, between.low + between.length() * (i + 1) / n});
}

}  // namespace

std::optional<std::string> in_the_way_of(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, const Pocket& pocket) {
  const double least = least_piece(wall) - kPlanTolerance;
  for (const Station& s : leg.stations) {  // cut as obliquely as the walls that meet there
    if (!height_there(plan, s).overlaps(pocket.height)) continue;
    const bool before = s.end != LegEnd::low && shorter_side(pocket.high, s.low, leg.half) >= least;
    const bool behind = s.end != LegEnd::high && shorter_side(s.high, pocket.low, leg.half) >= least;
    if (!before && !behind) return meeting_of(plan, leg, s).words;
  }
  const double low = std::min(pocket.low(pocket.from), pocket.low(pocket.to));
  const double high = std::max(pocket.high(pocket.from), pocket.high(pocket.to));
  const std::vector<Obstacle> all = obstacles_in(leg, {low, high, pocket.height, kNoOther});
  const Obstacle* hit = in_the_way(all, low, high, least_piece(wall));
  return hit == nullptr ? std::nullopt : std::optional(hit->words);
}

void add_wall_openings(const std::vector<WallSpec>& walls, WallsPlan& plan) {
  Faults faults;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (std::size_t i = 0; i < walls[w].openings.size(); ++i) faults.attempt([&] { add_opening(walls[w], w, i, plan); });
  }
  faults.raise();
  for (Leg& l : plan.legs) std::ranges::sort(l.holes, {}, &LegHole::low);
}

void plan_wall_courses(const std::vector<WallSpec>& walls, const std::vector<WallFloor>& floors, WallsPlan& plan) {
  Faults faults;
  plan.courses.resize(walls.size());
  for (std::size_t first = 0; first < walls.size(); ++first) {
    if (plan.group[first] != first) continue;
    std::vector<Level> levels;
    const Tick brick = plan.bricks[first].brick_height;
    for (std::size_t w = first; w < walls.size(); ++w) {
      if (plan.group[w] != first) continue;
      if (plan.bricks[w].brick_height != brick)
        faults.add({wall_key(w, "brick"), "is " + text(walls[w].brick[2]) +
                                              " m high, but walls that meet have the same courses; allowed: " +
                                              text(walls[first].brick[2]) + " m, as of the wall " + quoted(walls[first].name)});
      add_levels(walls[w], w, levels);
    }
    for (std::size_t w = first; w < walls.size(); ++w) {
      if (plan.group[w] == first) add_top_levels(walls[w], plan, w, levels);
    }
    add_beam_levels(floors, plan, first, levels);
    std::vector<Tick> beds;
    for (const Level& l : kept_levels(levels, std::max<Tick>(1, brick / 5), faults)) beds.push_back(l.at);
    std::ranges::sort(beds);
    beds.erase(std::unique(beds.begin(), beds.end()), beds.end());
    for (const Tick crown = crown_of(plan, first); beds.back() < crown;)
      beds.push_back(beds.back() + brick);  // of a gable: cut along its top
    for (std::size_t i = 0; i + 1 < beds.size(); ++i) add_courses({beds[i], beds[i + 1]}, brick, plan.courses[first]);
  }
  faults.raise();
}

}  // namespace voussoir::cases
