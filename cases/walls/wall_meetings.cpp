// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_meetings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "cases/names.h"
#include "geometry/disjoint_sets.h"
#include "geometry/polygon.h"

namespace voussoir::cases {
namespace {

constexpr double kLeastSine = 0.5 - 1e-9;  // of 30 degrees
constexpr double kNoArea = 1e-8;           // m2, as of geometry's joints

/// One side of a pair: a facet of a leg.
struct LegSide {
  std::size_t leg = 0, facet = 0;
};

class Finder {
 public:
  Finder(const std::vector<WallSpec>& walls, const std::vector<Corner>& corners, WallsPlan& plan) : walls_(walls), plan_(plan) {
    for (const Corner& c : corners) own_.insert({c.before, c.behind});
    for (const Corner& c : corners) add_corner(c);
  }

  void find() {
    Faults faults;
    const std::size_t n = plan_.legs.size();
    std::vector<std::pair<LegSide, LegSide>> pairs;
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        if (!leg(a).height.overlaps(leg(b).height)) continue;
        for (std::size_t f = 0; f < leg(a).facets.size(); ++f) {
          for (std::size_t g = 0; g < leg(b).facets.size(); ++g) {
            if (!is_own_corner({a, f}, {b, g})) pairs.push_back({{a, f}, {b, g}});
          }
        }
      }
    }
    for (const auto& [a, b] : pairs) find_ends(a, b), find_ends(b, a);
    for (const auto& pair : pairs) faults.attempt([&] { meet(pair.first, pair.second); });
    faults.raise();
    share_places();
    for (Leg& l : plan_.legs) std::ranges::sort(l.stations, {}, [](const Station& s) { return s.low.at; });
  }

 private:
  [[nodiscard]] Leg& leg(std::size_t i) const { return plan_.legs[i]; }
  [[nodiscard]] const Facet& facet(LegSide s) const { return leg(s.leg).facets[s.facet]; }
  [[nodiscard]] bool is_last(LegSide s) const { return s.facet + 1 == leg(s.leg).facets.size(); }
  [[nodiscard]] bool has_end(LegSide s, LegEnd which) const { return which == LegEnd::low ? s.facet == 0 : is_last(s); }

  [[nodiscard]] bool is_own_corner(LegSide a, LegSide b) const {
    return (own_.contains({a.leg, b.leg}) && is_last(a) && b.facet == 0) || (own_.contains({b.leg, a.leg}) && is_last(b) && a.facet == 0);
  }

  /// The two faces of b as cuts through a. \pre the facets are not parallel
  [[nodiscard]] Station strip(LegSide a, LegSide b) const {
    const Facet &fa = facet(a), &fb = facet(b);
    const double sine = dot(fa.along, fb.across), slope = -dot(fa.across, fb.across) / sine, off = dot(fa.from - fb.from, fb.across);
    const auto face = [&](double e) { return LegCut{fa.start + (e - off) / sine, slope}; };
    Station s;
    s.low = face(sine > 0.0 ? -leg(b.leg).half : leg(b.leg).half);
    s.high = face(sine > 0.0 ? leg(b.leg).half : -leg(b.leg).half);
    return s;
  }
  [[nodiscard]] double sine(LegSide a, LegSide b) const { return std::abs(dot(facet(a).along, facet(b).across)); }

  void add_station(LegSide a, LegSide b, LegEnd end) {
    Station s = strip(a, b);
    s.end = end, s.meeting = plan_.meetings.size();
    leg(a.leg).stations.push_back(s);
  }

  void add_corner(const Corner& c) {
    const LegSide a{c.before, leg(c.before).facets.size() - 1}, b{c.behind, 0};
    add_station(a, b, LegEnd::high), add_station(b, a, LegEnd::low);
    const bool first_hosts = c.number % 2 == 1;
    plan_.meetings.push_back({first_hosts ? c.before : c.behind, first_hosts ? c.behind : c.before});
  }

  /// The cuts at the ends of a facet. \param through  at an end in another wall: at its far face, else at the near one
  [[nodiscard]] std::pair<LegCut, LegCut> ends_of(LegSide a, bool through) const {
    const Leg& l = leg(a.leg);
    const Facet& f = facet(a);
    std::pair<LegCut, LegCut> ends{{f.start, 0.0}, {f.start + f.length, 0.0}};
    const auto ending = [&](LegEnd which) -> const Station* {
      if (const Station* s = l.end(which)) return s;
      const auto found = free_ends_.find({a.leg, which});
      return found == free_ends_.end() ? nullptr : &found->second.station;
    };
    if (const Station* s = a.facet == 0 ? ending(LegEnd::low) : nullptr) ends.first = through ? s->low : s->high;
    if (const Station* s = is_last(a) ? ending(LegEnd::high) : nullptr) ends.second = through ? s->high : s->low;
    return ends;
  }

  [[nodiscard]] geometry::Polygon outline(LegSide a, bool through) const {
    const auto [low, high] = ends_of(a, through);
    const Leg& l = leg(a.leg);
    const Facet& f = facet(a);
    geometry::Polygon all;
    for (const auto& [cut, d] : {std::pair{low, -l.half}, {high, -l.half}, {high, l.half}, {low, l.half}}) {
      const Vec3 p = f.from + (cut(d) - f.start) * f.along + d * f.across;
      all.push_back({p.x, p.y});
    }
    return all;
  }
  [[nodiscard]] bool overlap(LegSide a, LegSide b, bool through) const {
    return geometry::region(geometry::intersection(outline(a, through), outline(b, through))).area > kNoArea;
  }

  /// Notes the free ends of a that lie in b.
  void find_ends(LegSide a, LegSide b) {
    const Leg &la = leg(a.leg), &lb = leg(b.leg);
    if (la.ring || sine(a, b) < kLeastSine) return;
    const Facet &fa = facet(a), &fb = facet(b);
    const double margin = lb.ring ? kPlanTolerance : 2.0 * la.half + kPlanTolerance;
    for (const LegEnd which : {LegEnd::low, LegEnd::high}) {
      if (!has_end(a, which) || la.end(which) != nullptr) continue;
      const Vec3 p = fa.from + (which == LegEnd::high ? fa.length : 0.0) * fa.along + la.line * fa.across;
      const double along = dot(p - fb.from, fb.along), across = dot(p - fb.from, fb.across);
      if (std::abs(across) > lb.half + kPlanTolerance) continue;
      const auto [low, high] = ends_of(b, true);
      if (along + fb.start < low(across) - (b.facet == 0 ? margin : 0.0)) continue;
      if (along + fb.start > high(across) + (is_last(b) ? margin : 0.0)) continue;
      Station s = strip(a, b);
      s.end = which;
      free_ends_.emplace(std::pair{a.leg, which}, FreeEnd{b, s});
    }
  }

  [[nodiscard]] LegEnd end_in(LegSide a, LegSide b) const {
    for (const LegEnd which : {LegEnd::low, LegEnd::high}) {
      if (!has_end(a, which)) continue;
      const auto found = free_ends_.find({a.leg, which});
      if (found != free_ends_.end() && found->second.in.leg == b.leg && found->second.in.facet == b.facet) return which;
    }
    return LegEnd::none;
  }

  /// Whether the strip of b lies in a from face to face.
  [[nodiscard]] bool passes(LegSide a, LegSide b) const {
    const double half = leg(a.leg).half;
    const auto [low, high] = ends_of(a, true);
    const Station s = strip(a, b);
    return shorter_side(low, s.low, half) > -kPlanTolerance && shorter_side(s.high, high, half) > -kPlanTolerance;
  }

  [[noreturn]] void refuse(LegSide a, LegSide b, const std::string& problem) const {
    const std::size_t later = std::max(leg(a.leg).wall, leg(b.leg).wall);
    const LegSide mine = leg(b.leg).wall == later ? b : a, other = leg(b.leg).wall == later ? a : b;
    throw InputError(wall_key(later, "points"), "the " + leg(mine.leg).tag + " and the " + leg(other.leg).tag + problem);
  }

  /// Refuses a wall whose foot lies in the upper half of one along which it stands, once for each pair of walls.
  void refuse_sunk(LegSide a, LegSide b) {
    const bool a_on_b = leg(a.leg).height.low > leg(b.leg).height.low;
    const Leg &upper = leg(a_on_b ? a.leg : b.leg), &lower = leg(a_on_b ? b.leg : a.leg);
    if (upper.height.low <= (lower.height.low + lower.eaves) / 2 || upper.height.low >= lower.eaves) return;
    if (!sunk_.insert(std::minmax(upper.wall, lower.wall)).second) return;
    throw InputError(wall_key(upper.wall, "base"), text(walls_[upper.wall].base) + " m: the " + upper.tag + " would begin inside the " +
                                                       lower.tag + ", whose top is at " + metres_text(lower.eaves) +
                                                       " m; nearest: " + metres_text(lower.eaves) + " m");
  }

  void meet(LegSide a, LegSide b) {
    if (sine(a, b) < kLeastSine) {
      if (!overlap(a, b, false)) return;
      refuse_sunk(a, b);
      if (!sunk_.contains(std::minmax(leg(a.leg).wall, leg(b.leg).wall)))
        refuse(a, b, " overlap at an angle below 30 degrees; a wall that two buildings share is given once, and others end in it");
      return;
    }
    const LegEnd end_a = end_in(a, b), end_b = end_in(b, a);
    if (end_a == LegEnd::none && end_b == LegEnd::none && !overlap(a, b, true)) return;
    if ((end_a == LegEnd::none && !passes(a, b)) || (end_b == LegEnd::none && !passes(b, a)))
      refuse(a, b,
             " meet in part only: each runs through the other from face to face, or ends in it (its last point lies in it or on its face); "
             "bends are not in the way");
    add_station(a, b, end_a), add_station(b, a, end_b);
    const std::size_t wall_a = leg(a.leg).wall, wall_b = leg(b.leg).wall;
    const bool a_ends = end_a != LegEnd::none, b_ends = end_b != LegEnd::none, a_hosts = a_ends == b_ends ? wall_a <= wall_b : b_ends;
    const bool toothed = wall_a == wall_b || walls_[std::max(wall_a, wall_b)].meeting == WallMeeting::toothed;
    plan_.meetings.push_back({a_hosts ? a.leg : b.leg, a_hosts ? b.leg : a.leg, toothed});
  }

  /// Finds meetings that share a place: one leg is the host of all of them, and the guests run through it in turn.
  void share_places() {
    geometry::DisjointSets places(plan_.meetings.size());
    for (const Leg& l : plan_.legs) {
      for (const Station& s : l.stations) {
        for (const Station& t : l.stations) {
          if (longer_side(s.low, t.high, l.half) > kPlanTolerance && longer_side(t.low, s.high, l.half) > kPlanTolerance)
            places.join(s.meeting, t.meeting);
        }
      }
    }
    std::map<std::size_t, std::vector<std::size_t>> of_place;
    for (std::size_t m = 0; m < plan_.meetings.size(); ++m) of_place[places.of(m)].push_back(m);
    Faults faults;
    for (const auto& place : of_place) {
      if (place.second.size() > 1) faults.attempt([&] { take_turns(place.second); });
    }
    faults.raise();
    for (std::size_t i = 0; i < plan_.legs.size(); ++i) {
      for (Station& s : leg(i).stations) s.host = plan_.meetings[s.meeting].host == i;
    }
  }

  void take_turns(const std::vector<std::size_t>& all) {
    const Meeting first = plan_.meetings[all[0]];
    const auto is_in_all = [&](std::size_t l) {
      return std::ranges::all_of(all, [&](std::size_t m) {
        const Meeting& x = plan_.meetings[m];
        return x.host == l || (x.guest == l && x.toothed);
      });
    };
    const bool host = is_in_all(first.host);
    if (!host && !is_in_all(first.guest)) {
      const Meeting& last = plan_.meetings[all.back()];
      refuse({last.host, 0}, {last.guest, 0},
             " meet where another wall meets one of them; where three walls meet, two of them end in the third or cross it, in one line");
    }
    const std::size_t common = host ? first.host : first.guest;
    int turns = 0;
    for (const std::size_t m : all) {
      Meeting& x = plan_.meetings[m];
      x = {common, x.host == common ? x.guest : x.host, x.toothed, turns};
      turns += x.toothed ? 1 : 0;
    }
    for (const std::size_t m : all) plan_.meetings[m].turns = std::max(1, turns);
  }

  struct FreeEnd {
    LegSide in;
    Station station;
  };
  const std::vector<WallSpec>& walls_;
  WallsPlan& plan_;
  std::set<std::pair<std::size_t, std::size_t>> own_;            // legs before and behind a corner
  std::set<std::pair<std::size_t, std::size_t>> sunk_;           // walls of which one begins in the other: told
  std::map<std::pair<std::size_t, LegEnd>, FreeEnd> free_ends_;  // by leg
};

}  // namespace

double shorter_side(const LegCut& a, const LegCut& b, double half) noexcept { return std::min(b(half) - a(half), b(-half) - a(-half)); }
double longer_side(const LegCut& a, const LegCut& b, double half) noexcept { return std::max(b(half) - a(half), b(-half) - a(-half)); }

void find_meetings(const std::vector<WallSpec>& walls, const std::vector<Corner>& corners, WallsPlan& plan) {
  Finder(walls, corners, plan).find();
  geometry::DisjointSets groups(walls.size());
  for (const Meeting& m : plan.meetings) groups.join(plan.legs[m.host].wall, plan.legs[m.guest].wall);
  for (std::size_t i = 0; i < walls.size(); ++i) plan.group.push_back(groups.of(i));
}

}  // namespace voussoir::cases
