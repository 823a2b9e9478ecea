// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/torsion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

#include "geometry/nth.h"
#include "geometry/polygon.h"

namespace voussoir::geometry {

namespace {

constexpr double kBeside = 0.02;     // of the shorter edge: how far beside an edge, and before the joint's plane, something is looked for
constexpr double kRectangle = 1e-6;  // relative difference of areas, and of lengths, up to which an overlap is a rectangle
constexpr double kFacing = 0.999;    // cosine from which a face is the joint's own
// Of an edge: where something is looked for beside it. At no share at which blocks usually end, since round-off would decide there.
constexpr double kPlaces[] = {0.13, 0.39, 0.61, 0.87};
constexpr int kHeld = 3;  // places from which an edge is not free

/// The elements that each element has a joint with.
std::vector<std::vector<std::int32_t>> neighbours_of(const Assembly& a) {
  std::vector<std::vector<std::int32_t>> near(a.elements.size());
  for (const Joint& j : a.joints) {
    if (j.element_b == kBase) continue;
    nth(near, j.element_a).push_back(j.element_b);
    nth(near, j.element_b).push_back(j.element_a);
  }
  return near;
}

std::span<const Face> faces_of(const Assembly& a, std::int32_t element) {
  const Element& e = nth(a.elements, element);
  return std::span(a.faces).subspan(static_cast<std::size_t>(e.first_face), static_cast<std::size_t>(e.face_count));
}

bool is_inside(const Assembly& a, std::int32_t element, Vec3 x) {
  return std::ranges::all_of(faces_of(a, element), [&](const Face& f) { return dot(f.normal, x) < f.offset; });
}

/// Half-plane in the plane of a joint, seen from the joint's centre: normal · (s, t) <= offset.
struct HalfPlane {
  Point2 normal;
  double offset;  // m
};

/// The half-planes whose common part is the overlap of a joint.
std::vector<HalfPlane> sides_of(const Assembly& a, const Joint& j) {
  std::vector<HalfPlane> all;
  const Frame frame = j.frame();
  for (const std::int32_t element : {j.element_a, j.element_b}) {
    if (element == kBase) continue;
    for (const Face& f : faces_of(a, element)) {
      if (std::abs(dot(f.normal, frame.normal)) > kFacing) continue;
      all.push_back({{dot(f.normal, frame.axis_s), dot(f.normal, frame.axis_t)}, f.offset - dot(f.normal, frame.centre)});
    }
  }
  return all;
}

/// A rectangle along the axes of a joint, seen from the joint's centre [m].
struct Extent {
  double low[2], high[2];  // along s, t
  [[nodiscard]] double edge(int axis) const { return high[axis] - low[axis]; }
};

/// From the centre along the axes until the overlap ends: the overlap, if it is a rectangle along them.
Extent cross_of(const std::vector<HalfPlane>& sides) {
  Extent e{};
  for (int axis = 0; axis < 2; ++axis) {
    const auto way = [&](double sign) {
      double least = std::numeric_limits<double>::infinity();
      for (const HalfPlane& h : sides) {
        const double along = sign * (axis == 0 ? h.normal.s : h.normal.t);
        if (along > 1e-9) least = std::min(least, h.offset / along);
      }
      return least;
    };
    e.low[axis] = -way(-1.0), e.high[axis] = way(1.0);
  }
  return e;
}

bool is_rectangle(const std::vector<HalfPlane>& sides, const Extent& e, double area) {
  if (!(std::abs(e.edge(0) * e.edge(1) - area) <= kRectangle * area)) return false;
  const double allowed = kRectangle * std::max(e.edge(0), e.edge(1));
  return std::ranges::all_of(sides, [&](const HalfPlane& h) {
    return std::max(h.normal.s * e.low[0], h.normal.s * e.high[0]) + std::max(h.normal.t * e.low[1], h.normal.t * e.high[1]) <=
           h.offset + allowed;
  });
}

/// The rectangle round an overlap. \param cross  cross_of(sides) \param area  m2, of the overlap
Extent round_of(const std::vector<HalfPlane>& sides, const Extent& cross, double area) {
  const double far = 2.0 * area / std::min(cross.edge(0), cross.edge(1));  // a convex outline reaches no farther than that
  Polygon overlap = to_polygon({{-far, -far}, {far, far}}), scratch;
  for (const HalfPlane& h : sides) clip(overlap, h.normal, h.offset, scratch);
  if (overlap.empty()) return cross;  // a sliver as wide as the tolerance of joints
  const Rectangle r = bounds(overlap);
  return {{r.low.s, r.low.t}, {r.high.s, r.high.t}};
}

/// Whether material goes on beyond a place at an edge of the joint.
class Beyond {
 public:
  Beyond(const Assembly& a, const Joint& j, const std::vector<std::vector<std::int32_t>>& near) : a_(a), j_(j), near_(near) {}

  [[nodiscard]] bool solid(Vec3 x, double before) const {
    return within(j_.element_a, x - before * j_.frame().normal) &&
           (j_.element_b == kBase || within(j_.element_b, x + before * j_.frame().normal));
  }

 private:
  [[nodiscard]] bool within(std::int32_t element, Vec3 x) const {
    return is_inside(a_, element, x) ||
           std::ranges::any_of(nth(near_, element), [&](std::int32_t other) { return is_inside(a_, other, x); });
  }

  const Assembly& a_;
  const Joint& j_;
  const std::vector<std::vector<std::int32_t>>& near_;
};

/// Number of free edges at the two ends of an axis.
int free_ends(const Joint& j, const Extent& e, int axis, const Beyond& beyond) {
  const Vec3 along = axis == 0 ? j.frame().axis_s : j.frame().axis_t, across = axis == 0 ? j.frame().axis_t : j.frame().axis_s;
  const double step = kBeside * std::min(e.edge(0), e.edge(1));
  int free = 0;
  for (const double end : {e.low[axis] - step, e.high[axis] + step}) {
    int held = 0;
    for (const double share : kPlaces) {
      const double at = e.low[1 - axis] + share * e.edge(1 - axis);
      held += beyond.solid(j.centre + end * along + at * across, step) ? 1 : 0;
    }
    free += held < kHeld ? 1 : 0;
  }
  return free;
}

/// THEORY.md (11c): half of the constant belongs to each end of the edge that is not free at both.
double constant_between(double thickness, double length, int free) {
  const double plate = thickness * thickness * thickness * length / 6.0;
  return 0.5 * (free * torsion_constant(thickness, length) + (2 - free) * plate);
}

JointTorsion torsion_of_rectangle(const Joint& j, const Extent& e, const Beyond& beyond) {
  const double s = e.edge(0), t = e.edge(1), polar = s * t * (s * s + t * t) / 12.0;
  const int free_s = free_ends(j, e, 0, beyond), free_t = free_ends(j, e, 1, beyond);
  if (free_s == 2) return {constant_between(s, t, free_t), polar};
  if (free_t == 2) return {constant_between(t, s, free_s), polar};
  return {polar, polar};
}

JointTorsion torsion_of_any(const Joint& j, const Extent& e, const Beyond& beyond) {
  double polar = 0.0;
  for (const Segment& p : j.side_a) polar += p.area * (p.s * p.s + p.t * p.t);
  const bool alone = free_ends(j, e, 0, beyond) == 2 && free_ends(j, e, 1, beyond) == 2;
  return {alone && polar > 0.0 ? std::min(polar, std::pow(j.area, 4) / (40.0 * polar)) : polar, polar};
}

}  // namespace

double torsion_constant(double a, double b) {
  constexpr int kTerms = 40;
  const double thin = std::min(a, b), wide = std::max(a, b);
  double sum = 0.0;
  for (int n = 1; n < 2 * kTerms; n += 2) sum += std::tanh(0.5 * n * std::numbers::pi * wide / thin) / std::pow(n, 5);
  return wide * thin * thin * thin * (1.0 / 3.0 - 64.0 / std::pow(std::numbers::pi, 5) * thin / wide * sum);
}

std::vector<JointTorsion> joint_torsion(const Assembly& a) {
  const std::vector<std::vector<std::int32_t>> near = neighbours_of(a);
  std::vector<JointTorsion> all;
  all.reserve(a.joints.size());
  for (const Joint& j : a.joints) {
    const std::vector<HalfPlane> sides = sides_of(a, j);
    const Extent cross = cross_of(sides);
    const Beyond beyond(a, j, near);
    all.push_back(is_rectangle(sides, cross, j.area) ? torsion_of_rectangle(j, cross, beyond)
                                                     : torsion_of_any(j, round_of(sides, cross, j.area), beyond));
  }
  return all;
}

}  // namespace voussoir::geometry
