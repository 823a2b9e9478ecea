// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/fit/fit_contacts.h"

#include <algorithm>
#include <cmath>

#include "geometry/nth.h"
#include "geometry/polygon.h"

namespace voussoir::geometry {

namespace {

constexpr double kExact = 5e-7;           // m: faces this near are in one plane
constexpr double kOpposite = -0.8660254;  // cosine: normals are opposite within 30 degrees
constexpr double kSmall = 0.1;            // of the smaller face
constexpr double kSame = 0.8191520;       // cosine of 35 degrees: contacts of one plane

/// Axes of a plane between two faces.
struct Between {
  Vec3 origin, normal, s, t;
};

Between between(const FlatFace& f, const FlatFace& g) {
  Between b;
  b.origin = f.plane.centre;
  b.normal = normalised(f.plane.normal - g.plane.normal);
  const Vec3 aside = std::abs(b.normal.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  b.s = normalised(cross(aside, b.normal));
  b.t = cross(b.normal, b.s);
  return b;
}

Polygon seen(const Between& p, const FlatFace& f, bool from_behind) {
  Polygon out;
  for (const Point2 q : f.polygon) {
    const Vec3 r = f.plane.centre - p.origin + q.s * f.axis_s + q.t * f.axis_t;
    out.push_back({dot(r, p.s), dot(r, p.t)});
  }
  if (from_behind) std::reverse(out.begin(), out.end());
  return out;
}

/// The point of a face under (or over) a point of the plane between.
Vec3 on_face(const Between& p, const FlatFace& f, Point2 q) {
  const Vec3 foot = p.origin + q.s * p.s + q.t * p.t;
  return foot + (dot(f.plane.normal, f.plane.centre - foot) / dot(f.plane.normal, p.normal)) * p.normal;
}

double breadth(const Polygon& p, double area) {
  double longest = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) longest = std::max(longest, std::hypot(p[i].s - p[k].s, p[i].t - p[k].t));
  }
  return longest > 0.0 ? area / longest : 0.0;
}

/// What two faces that look at each other have in common. \param reach  m, most gap or overlap at the middle
std::optional<FitContact> contact(const FlatFace& f, const FlatFace& g, double reach, double narrow) {
  if (dot(f.plane.normal, g.plane.normal) > kOpposite) return std::nullopt;
  if (norm(g.plane.centre - f.plane.centre) > f.reach + g.reach + reach) return std::nullopt;
  const Between p = between(f, g);
  if (std::abs(dot(g.plane.centre - f.plane.centre, p.normal)) > reach + 0.3 * (f.reach + g.reach)) return std::nullopt;
  const Polygon shared = intersection(seen(p, f, false), seen(p, g, true));
  FitContact c;
  const Region middle = region(shared);
  c.area = middle.area;
  if (!(c.area > 0.0) || breadth(shared, c.area) <= narrow) return std::nullopt;
  const double gap = dot(on_face(p, g, middle.centroid) - on_face(p, f, middle.centroid), p.normal);
  if (gap > 0.5 * reach || gap < -reach) return std::nullopt;
  c.low = 1e300, c.high = -1e300;
  for (const Point2 q : shared) {
    c.on_a.push_back(on_face(p, f, q)), c.on_b.push_back(on_face(p, g, q));
    const double apart = dot(c.on_b.back() - c.on_a.back(), p.normal);
    c.low = std::min(c.low, apart), c.high = std::max(c.high, apart);
  }
  if (c.high > reach || c.low < -2.0 * reach) return std::nullopt;
  c.exact = c.low > -kExact && c.high < kExact;
  // A small part of two faces that do not fit is no joint: both meet other stones there.
  if (std::max(-c.low, c.high) > std::max(narrow, 0.25 * reach) && c.area < kSmall * std::min(f.plane.area, g.plane.area))
    return std::nullopt;
  return c;
}

bool near_box(const FlatFace& f, const Box3& box, double reach) {
  const Vec3 c = f.plane.centre;
  const double r = f.reach + reach;
  return c.x - r <= box.high.x && c.x + r >= box.low.x && c.y - r <= box.high.y && c.y + r >= box.low.y && c.z - r <= box.high.z &&
         c.z + r >= box.low.z;
}

}  // namespace

std::vector<FitContact> contacts_of(std::span<const FitBody> bodies, std::int32_t a, std::int32_t b, double depth) {
  const FitBody& first = nth(bodies, a);
  const FitBody& second = nth(bodies, b);
  const double reach = first.limit + second.limit, narrow = std::max(first.snap, second.snap);
  std::vector<FitContact> out;
  for (std::size_t i = 0; i < first.faces.size(); ++i) {
    if (!near_box(first.faces[i], second.box, reach)) continue;
    for (std::size_t k = 0; k < second.faces.size(); ++k) {
      auto c = contact(first.faces[i], second.faces[k], reach, narrow);
      // Faces that look at each other through both bodies overlap by more than the bodies do.
      if (!c || -c->high > 2.0 * std::max(depth, 0.0) + kExact) continue;
      c->a = a, c->b = b, c->face_a = static_cast<std::int32_t>(i), c->face_b = static_cast<std::int32_t>(k);
      out.push_back(*std::move(c));
    }
  }
  if (out.size() < 2) return out;
  const auto largest = std::max_element(out.begin(), out.end(), [](const auto& p, const auto& q) { return p.area < q.area; });
  const Vec3 normal = nth(first.faces, largest->face_a).plane.normal;
  std::erase_if(out, [&](const FitContact& c) { return dot(nth(first.faces, c.face_a).plane.normal, normal) < kSame; });
  return out;
}

std::vector<FitContact> base_contacts_of(std::span<const FitBody> bodies, std::int32_t a, double base_z) {
  const FitBody& body = nth(bodies, a);
  std::vector<FitContact> out;
  for (std::size_t i = 0; i < body.faces.size(); ++i) {
    const FlatFace& f = body.faces[i];
    if (f.plane.normal.z > kOpposite || std::abs(f.plane.centre.z - base_z) > body.limit) continue;
    FitContact c;
    c.a = a, c.face_a = static_cast<std::int32_t>(i), c.area = f.plane.area;
    c.low = 1e300, c.high = -1e300;
    for (const Point2 q : f.polygon) {
      Vec3 v = f.plane.centre + q.s * f.axis_s + q.t * f.axis_t;
      c.low = std::min(c.low, v.z - base_z), c.high = std::max(c.high, v.z - base_z);
      c.on_a.push_back(v);
      v.z = base_z;
      c.on_b.push_back(v);
    }
    c.exact = c.low > -kExact && c.high < kExact;
    out.push_back(std::move(c));
  }
  return out;
}

}  // namespace voussoir::geometry
