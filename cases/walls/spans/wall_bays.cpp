// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_bays.h"

#include <algorithm>
#include <cmath>

#include "cases/input_error.h"
#include "cases/names.h"
#include "cases/walls/wall_tops.h"

namespace voussoir::cases {
namespace {

constexpr double kFarOff = 1e5;  // m, beyond any wall

Vec3 middle_of(const Leg& leg) { return leg.at(0.5 * leg.length(), 0.0); }

std::array<std::size_t, 2> two_sides(const std::vector<WallSpec>& walls, const WallsPlan& plan, const Spanning& what,
                                     const std::vector<std::string>& names) {
  if (names.size() != 2) throw InputError(what.key("walls"), "names " + std::to_string(names.size()) + " sides; it spans between two");
  std::array<std::size_t, 2> found{};
  Faults faults;
  for (std::size_t k = 0; k < 2; ++k)
    faults.attempt([&] { found[k] = find_side(walls, plan, names[k], indexed_key(what.key("walls"), k, "")); });
  faults.raise();
  if (found[0] == found[1]) throw InputError(what.key("walls"), "are both " + quoted(names[0]) + "; it spans between two sides");
  for (std::size_t k = 0; k < 2; ++k) {
    if (plan.legs[found[k]].facets.size() > 1)
      throw InputError(indexed_key(what.key("walls"), k, ""), quoted(names[k]) + " bends; beams and rafters rest on straight sides");
  }
  return found;
}

Vec3 direction_of(const WallsPlan& plan, const std::array<std::size_t, 2>& sides, const Spanning& what,
                  const std::optional<std::array<double, 2>>& direction) {
  const Leg &a = plan.legs[sides[0]], &b = plan.legs[sides[1]];
  Vec3 along = a.facets[0].across;
  if (direction) {
    const Vec3 given{(*direction)[0], (*direction)[1], 0.0};
    if (!(norm(given) > 1e-9)) throw InputError(what.key("direction"), "has no length");
    along = normalised(given);
  }
  for (const Leg* leg : {&a, &b}) {
    if (std::abs(dot(along, leg->facets[0].across)) < kLeastSine)
      throw InputError(what.key(direction ? "direction" : "walls"), "lies at less than 30 degrees to the " + leg->tag);
  }
  return dot(middle_of(b) - middle_of(a), along) < 0.0 ? -along : along;
}

}  // namespace

Tick eaves(const WallSpec& wall) { return ticks(wall.base + wall.height); }

std::string Spanning::key(const char* field) const { return indexed_key(list, index, field); }

std::string side_name(const Leg& leg) { return leg.tag.substr(0, leg.tag.rfind(' ')); }

std::size_t find_side(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::string& name, const std::string& key) {
  std::vector<std::string> names;
  std::string known, of_wall;
  for (std::size_t i = 0; i < plan.legs.size(); ++i) {
    names.push_back(side_name(plan.legs[i]));
    if (names.back() == name) return i;
    known += (i == 0 ? "" : ", ") + names.back();
    if (walls[plan.legs[i].wall].name == name) of_wall += (of_wall.empty() ? "" : ", ") + names.back();
  }
  if (!of_wall.empty()) throw InputError(key, quoted(name) + " has several sides; name one of them: " + of_wall);
  throw InputError(key,
                   quoted(name) + " is no side of a wall; " + did_you_mean(name, names) + "known: " + (known.empty() ? "none" : known));
}

double v_of(const WallsPlan& plan, const Bay& bay, WallFace line, double u) {
  const Leg& leg = plan.legs[line.leg];
  const Vec3 p = leg.at(0.0, line.d) - bay.from, e = leg.facets[0].along;
  return dot(p, bay.along) + (u - dot(p, bay.across)) / dot(e, bay.across) * dot(e, bay.along);
}

LegCut cut_at(const Leg& leg, const Bay& bay, double u) {
  const Facet& f = leg.facets[0];
  const Vec3 p = bay.at(u, 0.0) - f.from;
  const double slope = dot(bay.along, f.along) / dot(bay.along, f.across);
  return {dot(p, f.along) - slope * dot(p, f.across), slope};
}

std::array<Vec3, 4> in_bay(const Bay& bay, const std::array<double, 2>& u, const std::array<double, 2>& begin,
                           const std::array<double, 2>& end) {
  std::array<Vec3, 4> all{bay.at(u[0], begin[0]), bay.at(u[1], begin[1]), bay.at(u[1], end[1]), bay.at(u[0], end[0])};
  if (cross(bay.across, bay.along).z < 0.0) std::swap(all[1], all[3]);
  return all;
}

geometry::Polygon outline_of(const Leg& leg, std::size_t facet) {
  const Facet& f = leg.facets[facet];
  LegCut low{f.start, 0.0}, high{f.start + f.length, 0.0};
  if (const Station* s = leg.end(LegEnd::low); s != nullptr && facet == 0) low = s->low;
  if (const Station* s = leg.end(LegEnd::high); s != nullptr && facet + 1 == leg.facets.size()) high = s->high;
  geometry::Polygon all;
  for (const auto& [cut, d] : {std::pair{low, -leg.half}, {high, -leg.half}, {high, leg.half}, {low, leg.half}}) {
    const Vec3 p = f.from + (cut(d) - f.start) * f.along + d * f.across;
    all.push_back({p.x, p.y});
  }
  return all;
}

bool lies_in(const Leg& leg, Vec3 p) {
  for (std::size_t f = 0; f < leg.facets.size(); ++f) {
    const geometry::Polygon outline = outline_of(leg, f);
    bool inside = true;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const geometry::Point2 a = outline[i], b = outline[(i + 1) % outline.size()];
      inside = inside && (b.s - a.s) * (p.y - a.t) - (b.t - a.t) * (p.x - a.s) > -kPlanTolerance;
    }
    if (inside) return true;
  }
  return false;
}

Bay find_bay(const std::vector<WallSpec>& walls, const WallsPlan& plan, const Spanning& what, const std::vector<std::string>& sides,
             const std::optional<std::array<double, 2>>& direction, const std::vector<std::array<double, 2>>& corners) {
  const std::array<std::size_t, 2> legs = two_sides(walls, plan, what, sides);
  Bay bay;
  bay.along = direction_of(plan, legs, what, direction);
  for (std::size_t k = 0; k < 2; ++k) {
    const Leg& leg = plan.legs[legs[k]];
    const double inner = dot(bay.along, leg.facets[0].across) * (k == 0 ? 1.0 : -1.0);
    bay.faces[k] = {legs[k], inner > 0.0 ? leg.half : -leg.half};
  }
  const Leg &a = plan.legs[legs[0]], &b = plan.legs[legs[1]];
  bay.across = left_of(bay.along);
  if (dot(bay.across, a.facets[0].along) < 0.0) bay.across = -bay.across;
  bay.from = a.at(0.0, bay.faces[0].d);
  bay.low = 0.0, bay.high = a.length() * dot(a.facets[0].along, bay.across);
  const double one = dot(b.at(0.0, bay.faces[1].d) - bay.from, bay.across),
               other = dot(b.at(b.length(), bay.faces[1].d) - bay.from, bay.across);
  bay.low = std::max(bay.low, std::min(one, other)), bay.high = std::min(bay.high, std::max(one, other));
  const double u = 0.5 * (bay.low + bay.high);
  if (!(bay.high > bay.low) || !(v_of(plan, bay, bay.faces[1], u) > v_of(plan, bay, bay.faces[0], u)))
    throw InputError(what.key("walls"), "do not face each other: no beam goes from the " + a.tag + " to the " + b.tag);
  if (!corners.empty()) bound(plan, what, corners, kPlanTolerance, bay);
  return bay;
}

void bound(const WallsPlan& plan, const Spanning& what, const std::vector<std::array<double, 2>>& corners, double slack, Bay& bay) {
  double turn = 0.0;
  std::array<Vec3, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = {corners[i][0], corners[i][1], 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const double here = cross(p[(i + 1) % 4] - p[i], p[(i + 2) % 4] - p[(i + 1) % 4]).z;
    if (!(std::abs(here) > 1e-9) || here * turn < 0.0)
      throw InputError(what.key("corners"), "are those of no convex quadrilateral; give four corners in turn, no three in one line");
    turn = here;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 edge = normalised(p[(i + 1) % 4] - p[i]), inwards = (turn > 0.0 ? 1.0 : -1.0) * left_of(edge);
    for (const WallFace& face : bay.faces) {
      const Vec3 q = bay.at(0.0, v_of(plan, bay, face, 0.0)), step = bay.at(1.0, v_of(plan, bay, face, 1.0)) - q;
      const double rise = dot(step, inwards), start = dot(q - p[i], inwards) + slack;
      if (std::abs(rise) < 1e-9) {
        if (start < slack - kPlanTolerance) bay.high = bay.low;
      } else if (rise > 0.0) {
        bay.low = std::max(bay.low, -start / rise);
      } else {
        bay.high = std::min(bay.high, -start / rise);
      }
    }
  }
  if (!(bay.high > bay.low))
    throw InputError(what.key("corners"), "hold no part of both faces; a corner lies in a wall or on its face, not short of it");
}

void reach_to_ends(const WallsPlan& plan, Bay& bay) {
  double low = -kFarOff, high = kFarOff;
  for (const WallFace& face : bay.faces) {
    const Leg& leg = plan.legs[face.leg];
    const Station *first = leg.end(LegEnd::low), *last = leg.end(LegEnd::high);
    const double from = first == nullptr ? 0.0 : first->low(face.d), to = last == nullptr ? leg.length() : last->high(face.d);
    const double one = dot(leg.at(from, face.d) - bay.from, bay.across), other = dot(leg.at(to, face.d) - bay.from, bay.across);
    low = std::max(low, std::min(one, other)), high = std::min(high, std::max(one, other));
  }
  bay.low = low, bay.high = high;
}

void check_level_pair(const std::vector<WallSpec>& walls, const WallsPlan& plan, const Spanning& what, const Bay& bay,
                      const std::array<const char*, 2>& why) {
  const Leg &a = plan.legs[bay.faces[0].leg], &b = plan.legs[bay.faces[1].leg];
  if (std::abs(cross(a.facets[0].along, b.facets[0].along).z) > kSquare)
    throw InputError(what.key("walls"), "are not parallel: the " + a.tag + " and the " + b.tag + "; " + why[0]);
  if (eaves(walls[a.wall]) != eaves(walls[b.wall]))
    throw InputError(what.key("walls"), "have tops at " + metres_text(eaves(walls[a.wall])) + " and " + metres_text(eaves(walls[b.wall])) +
                                            " m above the base: the " + a.tag + " and the " + b.tag + "; " + why[1]);
}

BayAxes::BayAxes(const WallsPlan& plan, const Bay& bay)
    : bay_(&bay), length_(bay.high - bay.low), from_(v_of(plan, bay, bay.faces[0], 0.0)), mirrored_(cross(bay.across, bay.along).z < 0.0) {
  span_ = v_of(plan, bay, bay.faces[1], 0.0) - from_;
}

Vec3 BayAxes::in_case(Vec3 p) const noexcept {
  const Vec3 plan = bay_->at(bay_->low + p.x, from_ + p.y);
  return {plan.x, plan.y, p.z};
}

geometry::Polyhedron BayAxes::in_case(geometry::Polyhedron shape) const {
  if (mirrored_) shape = geometry::mirrored(shape, {1.0, 0.0, 0.0}, {0.5 * length_, 0.0, 0.0});
  for (Vec3& v : shape.vertices) v = in_case(mirrored_ ? Vec3{length_ - v.x, v.y, v.z} : v);
  return shape;
}

void raise_to(const std::vector<WallSpec>& walls, const std::string& side, const std::string& key, const BayAxes& axes,
              const geometry::Polygon& line, const Spanning& what, WallsPlan& plan) {
  const std::string list = what.list;
  const std::size_t found = find_side(walls, plan, side, key);
  const Bay& bay = axes.bay();
  Leg& leg = plan.legs[found];
  const Facet& f = leg.facets[0];
  const double seat = line.front().t;
  if (leg.facets.size() > 1 || std::abs(cross(f.along, bay.along).z) > kSquare)
    throw InputError(key, "the " + leg.tag + " is not square to the " + (list == "vault" ? "axis of the vault" : "ridge of the roof") +
                              "; a gable has to be");
  if (eaves(walls[leg.wall]) != ticks(seat))
    throw InputError(key, "the " + leg.tag + " ends at " + metres_text(eaves(walls[leg.wall])) +
                              " m above the base, and what it rises to rests at " + text(seat) + " m; a gable begins at that height");
  const double u = dot(leg.at(0.5 * leg.length(), 0.0) - bay.from, bay.across);
  if (u + leg.half < bay.low - kPlanTolerance || u - leg.half > bay.high + kPlanTolerance)
    throw InputError(key, "the " + leg.tag + " does not stand under the " + list);
  geometry::Polygon top;
  for (const geometry::Point2 p : line) top.push_back({dot(axes.in_case(Vec3{u - bay.low, p.s, 0.0}) - f.from, f.along), p.t});
  if (top.front().s > top.back().s) std::ranges::reverse(top);
  const Station *first = leg.end(LegEnd::low), *last = leg.end(LegEnd::high);
  if (top.front().s < (first == nullptr ? 0.0 : first->low.at) - kPlanTolerance ||
      top.back().s > (last == nullptr ? leg.length() : last->high.at) + kPlanTolerance)
    throw InputError(key, "the " + leg.tag + " does not reach from the " + plan.legs[bay.faces[0].leg].tag + " to the " +
                              plan.legs[bay.faces[1].leg].tag + "; a gable does");
  top.insert(top.begin(), {-kFarOff, seat}), top.push_back({kFarOff, seat});
  raise(walls[leg.wall], top, key, leg);
}

}  // namespace voussoir::cases
