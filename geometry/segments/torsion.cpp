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

namespace voussoir::geometry {

namespace {

constexpr double kBeside = 0.02;     // of the shorter edge: how far beside an edge, and before the joint's plane, something is looked for
constexpr double kRectangle = 1e-6;  // relative difference of areas up to which an overlap is a rectangle
constexpr double kFacing = 0.999;    // cosine from which a face is the joint's own

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

/// How far one can go from a point of the joint in its plane until an element ends [m].
double way_out(const Assembly& a, std::int32_t element, const Frame& frame, Vec3 direction) {
  double way = std::numeric_limits<double>::infinity();
  for (const Face& f : faces_of(a, element)) {
    const double along = dot(f.normal, direction);
    if (std::abs(dot(f.normal, frame.normal)) > kFacing || along <= 1e-9) continue;
    way = std::min(way, (f.offset - dot(f.normal, frame.centre)) / along);
  }
  return way;
}

/// The rectangle along the axes of a joint that its overlap would fill, seen from the joint's centre [m].
struct Extent {
  double low[2], high[2];  // along s, t
  [[nodiscard]] double edge(int axis) const { return high[axis] - low[axis]; }
};

Extent extent_of(const Assembly& a, const Joint& j) {
  Extent e{};
  for (int axis = 0; axis < 2; ++axis) {
    const Vec3 to = axis == 0 ? j.frame.axis_s : j.frame.axis_t;
    const auto way = [&](Vec3 direction) {
      const double own = way_out(a, j.element_a, j.frame, direction);
      return j.element_b == kBase ? own : std::min(own, way_out(a, j.element_b, j.frame, direction));
    };
    e.low[axis] = -way(-1.0 * to), e.high[axis] = way(to);
  }
  return e;
}

/// Whether material goes on beyond a place at an edge of the joint.
class Beyond {
 public:
  Beyond(const Assembly& a, const Joint& j, const std::vector<std::vector<std::int32_t>>& near) : a_(a), j_(j), near_(near) {}

  [[nodiscard]] bool solid(Vec3 x, double before) const {
    return within(j_.element_a, x - before * j_.frame.normal) &&
           (j_.element_b == kBase || within(j_.element_b, x + before * j_.frame.normal));
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
  const Vec3 along = axis == 0 ? j.frame.axis_s : j.frame.axis_t, across = axis == 0 ? j.frame.axis_t : j.frame.axis_s;
  const double step = kBeside * std::min(e.edge(0), e.edge(1));
  int free = 0;
  for (const double end : {e.low[axis] - step, e.high[axis] + step}) {
    int held = 0;
    for (const double share : {1.0 / 6.0, 0.5, 5.0 / 6.0}) {
      const double at = e.low[1 - axis] + share * e.edge(1 - axis);
      held += beyond.solid(j.frame.centre + end * along + at * across, step) ? 1 : 0;
    }
    free += held < 2 ? 1 : 0;
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
    const Extent e = extent_of(a, j);
    const Beyond beyond(a, j, near);
    const bool rectangle = std::abs(e.edge(0) * e.edge(1) - j.area) <= kRectangle * j.area;
    all.push_back(rectangle ? torsion_of_rectangle(j, e, beyond) : torsion_of_any(j, e, beyond));
  }
  return all;
}

}  // namespace voussoir::geometry
