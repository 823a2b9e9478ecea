// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/facing.h"

#include <algorithm>
#include <cmath>

#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

constexpr double kMostTilt = 0.05;  // rad

double turn(Point2 a, Point2 b, Point2 c) { return (b.s - a.s) * (c.t - a.t) - (b.t - a.t) * (c.s - a.s); }

bool is_convex_polygon(const Polygon& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2 a = p[i], b = p[(i + 1) % p.size()], c = p[(i + 2) % p.size()];
    if (turn(a, b, c) < -1e-9 * (std::hypot(b.s - a.s, b.t - a.t) * std::hypot(c.s - b.s, c.t - b.t))) return false;
  }
  return true;
}

/// Convex hull by Andrew's monotone chain, counter-clockwise.
Polygon hull(Polygon points) {
  std::sort(points.begin(), points.end(), [](Point2 a, Point2 b) { return a.s < b.s || (a.s == b.s && a.t < b.t); });
  Polygon out;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = out.size();
    for (const Point2 p : points) {
      while (out.size() >= start + 2 && turn(out[out.size() - 2], out.back(), p) <= 0.0) out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return out;
}

/// The corners of b in the plane of a, in reverse order, since b is seen from behind.
Polygon seen_from(const FlatFace& a, const FlatFace& b) {
  Polygon out;
  for (auto p = b.polygon.rbegin(); p != b.polygon.rend(); ++p) {
    const Vec3 from = (b.plane.centre - a.plane.centre) + p->s * b.axis_s + p->t * b.axis_t;
    out.push_back({dot(from, a.axis_s), dot(from, a.axis_t)});
  }
  return out;
}

/// The part of `subject` within `cutter`. `subject` need not be convex. \pre `cutter` is convex
Polygon cut_by(Polygon subject, const Polygon& cutter) {
  Polygon scratch;
  for (std::size_t i = 0; i < cutter.size() && !subject.empty(); ++i) {
    const Point2 p = cutter[i], q = cutter[(i + 1) % cutter.size()];
    const Point2 outward{q.t - p.t, p.s - q.s};
    clip(subject, outward, outward.s * p.s + outward.t * p.t, scratch);
  }
  return subject;
}

}  // namespace

FlatFace flat_face(const Mesh& m, std::size_t face) {
  FlatFace f;
  f.plane = loop_plane(m, face);
  const Vec3 n = f.plane.normal, aside = std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  f.axis_s = normalised(cross(aside, n));
  f.axis_t = cross(n, f.axis_s);
  for (const std::int32_t v : m.faces[face]) {
    const Vec3 r = nth(m.vertices, v) - f.plane.centre;
    f.polygon.push_back({dot(r, f.axis_s), dot(r, f.axis_t)});
    f.reach = std::max(f.reach, norm(r));
  }
  f.convex = is_convex_polygon(f.polygon);
  return f;
}

std::optional<Facing> facing(const FlatFace& a, const FlatFace& b, double most) {
  const Vec3 sum = a.plane.normal + b.plane.normal;
  if (dot(sum, sum) > kMostTilt * kMostTilt) return std::nullopt;
  const Vec3 between = b.plane.centre - a.plane.centre;
  if (norm(between) > a.reach + b.reach + most) return std::nullopt;
  if (std::abs(dot(between, a.plane.normal)) > most + kMostTilt * (a.reach + b.reach)) return std::nullopt;
  Polygon other = seen_from(a, b), shared;
  if (b.convex) {
    shared = cut_by(a.polygon, other);
  } else {
    shared = a.convex ? cut_by(std::move(other), a.polygon) : cut_by(a.polygon, hull(std::move(other)));
  }
  Facing f;
  f.tilt = norm(sum);
  f.area = region(shared).area;
  if (!(f.area > 0.0)) return std::nullopt;
  f.low = 1e300, f.high = -1e300;
  double longest = 0.0;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    const Vec3 point = shared[i].s * a.axis_s + shared[i].t * a.axis_t;  // relative to the centre of a
    const double apart = dot(between - point, b.plane.normal) / dot(a.plane.normal, b.plane.normal);
    f.low = std::min(f.low, apart), f.high = std::max(f.high, apart);
    for (std::size_t k = 0; k < i; ++k) longest = std::max(longest, std::hypot(shared[i].s - shared[k].s, shared[i].t - shared[k].t));
  }
  f.width = f.area / longest;
  if (f.high > most || f.low < -most) return std::nullopt;
  return f;
}

}  // namespace voussoir::geometry
