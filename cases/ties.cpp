// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/ties.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "cases/names.h"
#include "geometry/polygon.h"

namespace voussoir::cases {
namespace {

constexpr double kNear = 1e-3;      // m, from a point to the element that it belongs to, and from a face to its plate
constexpr double kShortest = 1e-2;  // m, tie
constexpr double kCovered = 0.5;    // least share of a plate that lies on faces
constexpr double kNever = std::numeric_limits<double>::infinity();

std::string point_text(Vec3 p) { return "[" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + "]"; }

/// One end of a tie, as the case file has it.
struct End {
  std::string key;  // "tie[0].from"
  Vec3 point;
  Vec3 inwards;  // unit, to the other end
};

/// m, from the point to the element: of the face that it is farthest outside of, below 0 inside.
double distance_outside(const geometry::Assembly& a, std::size_t element, Vec3 point) {
  double most = -kNever;
  const geometry::Element& e = a.elements[element];
  for (std::int32_t f = 0; f < e.face_count; ++f) {
    const geometry::Face& face = a.faces[static_cast<std::size_t>(e.first_face + f)];
    most = std::max(most, dot(face.normal, point) - face.offset);
  }
  return most;
}

[[noreturn]] void refuse_point(const Case& c, const Model& model, const End& end) {
  double least = kNever;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double d = distance_outside(model.assembly, i, end.point);
    if (d < least) least = d, nearest = i;
  }
  const std::string base = c.base ? ", nor on the base (z = " + text(c.base->z) + " m)" : "";
  throw InputError(end.key, point_text(end.point) + " m lies in no element" + base + "; the nearest, " +
                                describe(model.blocks[nearest], nearest) + ", is " + text(std::round(least * 1e3) / 1e3) + " m away");
}

std::vector<TieHold> hold_at_point(const Case& c, const Model& model, const End& end) {
  double least = kNear;
  std::int32_t found = -1;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double d = distance_outside(model.assembly, i, end.point);
    if (d < least - 1e-9) least = d, found = static_cast<std::int32_t>(i);
  }
  if (found >= 0) return {{found, 1.0, end.point}};
  if (c.base && std::abs(end.point.z - c.base->z) <= kNear) return {{geometry::kBase, 1.0, end.point}};
  refuse_point(c, model, end);
}

/// Outward normal of the face under the plate: of those that the point lies on, the one that looks away from the other end most.
Vec3 face_under_plate(const Model& model, const End& end) {
  double most = 0.5;  // within 60 degrees
  Vec3 normal;
  const geometry::Assembly& a = model.assembly;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (distance_outside(a, i, end.point) > kNear) continue;
    for (std::int32_t f = 0; f < a.elements[i].face_count; ++f) {
      const geometry::Face& face = a.faces[static_cast<std::size_t>(a.elements[i].first_face + f)];
      if (std::abs(dot(face.normal, end.point) - face.offset) > kNear) continue;
      const double away = -dot(face.normal, end.inwards);
      if (away > most + 1e-9) most = away, normal = face.normal;
    }
  }
  if (normal == Vec3{})
    throw InputError(end.key,
                     point_text(end.point) + " m lies on no face that looks away from the other end, so its plate has nothing to press on");
  return normal;
}

/// Faces in the plane of the plate, and what it covers of them.
std::vector<TieHold> hold_by_plate(const Model& model, const End& end, const std::array<double, 2>& plate) {
  const Vec3 n = face_under_plate(model, end);
  const Vec3 across = std::abs(n.z) > 0.99 ? Vec3{1, 0, 0} : normalised(cross(Vec3{0, 0, 1}, n)), up = cross(n, across);
  const auto in_plane = [&](Vec3 x) { return geometry::Point2{dot(x - end.point, across), dot(x - end.point, up)}; };
  const geometry::Polygon shape = geometry::to_polygon({{-0.5 * plate[0], -0.5 * plate[1]}, {0.5 * plate[0], 0.5 * plate[1]}});
  const geometry::Assembly& a = model.assembly;
  std::vector<TieHold> holds;
  double covered = 0.0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (distance_outside(a, i, end.point) > plate[0] + plate[1]) continue;
    for (std::int32_t f = 0; f < a.elements[i].face_count; ++f) {
      const geometry::Face& face = a.faces[static_cast<std::size_t>(a.elements[i].first_face + f)];
      if (dot(face.normal, n) < 1.0 - 1e-6 || std::abs(dot(face.normal, end.point) - face.offset) > kNear) continue;
      geometry::Polygon corners;
      for (const std::int32_t v : model.blocks[i].shape.faces[static_cast<std::size_t>(f)])
        corners.push_back(in_plane(model.blocks[i].shape.vertices[static_cast<std::size_t>(v)]));
      const geometry::Region region = geometry::region(geometry::intersection(shape, corners));
      if (region.area < 1e-6 * plate[0] * plate[1]) continue;
      holds.push_back({static_cast<std::int32_t>(i), region.area, end.point + region.centroid.s * across + region.centroid.t * up});
      covered += region.area;
    }
  }
  for (TieHold& h : holds) h.share /= covered;
  if (covered < kCovered * plate[0] * plate[1])
    throw InputError(end.key, "only " + text(std::round(100.0 * covered / (plate[0] * plate[1]))) + " % of the plate at " +
                                  point_text(end.point) + " m lies on faces of the model; wanted " + text(100.0 * kCovered) + " % or more");
  return holds;
}

Vec3 middle(const std::vector<TieHold>& holds) {
  Vec3 at;
  for (const TieHold& h : holds) at += h.share * h.point;
  return at;
}

bool is_one_element(const TieBar& bar) {
  std::set<std::int32_t> elements;
  for (const auto& end : bar.ends)
    for (const TieHold& h : end) elements.insert(h.element);
  return elements.size() == 1;
}

TieBar place(const Case& c, const Model& model, const Tie& tie, const std::string& key) {
  const double apart = norm(tie.to - tie.from);
  if (apart < kShortest)
    throw InputError(key + ".to", "is " + text(apart) + " m from tie.from; a tie has a length of " + text(kShortest) + " m or more");
  const Vec3 along = normalised(tie.to - tie.from);
  TieBar bar;
  bar.name = tie.name;
  const std::array<End, 2> ends{End{key + ".from", tie.from, along}, End{key + ".to", tie.to, -along}};
  for (std::size_t k = 0; k < 2; ++k)
    bar.ends[k] = tie.plate ? hold_by_plate(model, ends[k], *tie.plate) : hold_at_point(c, model, ends[k]);
  if (is_one_element(bar)) throw InputError(key, "holds one element alone: both ends are on it");
  bar.length = norm(middle(bar.ends[1]) - middle(bar.ends[0]));
  bar.stiffness = tie.young * tie.area / bar.length;
  bar.yield = tie.yield ? *tie.yield * tie.area : kNever;
  // Stress over strain has the slope E_t beyond yield, so stress over plastic strain has E E_t / (E − E_t).
  bar.hardening = tie.young * tie.hardening / (tie.young - tie.hardening) * tie.area / bar.length;
  bar.breaking = tie.elongation ? *tie.elongation * bar.length : kNever;
  bar.pretension = tie.pretension;
  bar.compression = tie.compression;
  return bar;
}

}  // namespace

std::vector<TieBar> place_ties(const Case& c, const Model& model) {
  std::vector<TieBar> bars;
  std::set<std::string> names;
  for (std::size_t i = 0; i < c.ties.size(); ++i) {
    if (!names.insert(c.ties[i].name).second)
      throw InputError(indexed_key("tie", i, "name"), quoted(c.ties[i].name) + " is the name of another tie, too");
    bars.push_back(place(c, model, c.ties[i], indexed_key("tie", i, "")));
  }
  return bars;
}

}  // namespace voussoir::cases
