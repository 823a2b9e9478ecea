// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "kernels/contact/overlap.h"

/// The point at which a body meets the face of another body that is least deep. Internal to kernels/contact/overlap*.cpp.
namespace voussoir::kernels {

// rad: an edge or a face tilted less than this lies along a face. Greater than the angle between edges whose normal is round-off
// (kParallel), as such edges have no crossing.
inline constexpr double kFlush = 2e-6;

// m: crossed edges that are shallower than every face by less than this count as parallel to a face, since their lines may cross anywhere.
inline constexpr double kNoLess = 1e-7;
inline constexpr double kTouch = 1e-9;  // m, round-off on the boundary of a body

/// A convex body in the axes of the overlap test, which are those of one of the two bodies.
struct PlacedShape {
  const ConvexShape& shape;
  Mat3 turn;
  Vec3 centre;
  [[nodiscard]] Vec3 vertex(std::size_t i) const noexcept { return centre + turn * shape.vertices[i]; }
};

/// The part of a segment inside a body: its share of the length, and its midpoint.
struct PartInside {
  double share;
  Vec3 middle;
};
inline PartInside part_inside(const PlacedShape& body, Vec3 from, Vec3 to) noexcept {
  double first = 0.0, last = 1.0;
  for (const Face& f : body.shape.faces) {
    const Vec3 n = body.turn * f.normal;
    const double room = f.distance + kTouch - dot(n, from - body.centre), falls = dot(n, to - from);
    if (falls > 0.0) last = std::min(last, room / falls);
    if (falls < 0.0) first = std::max(first, room / falls);
    if (falls == 0.0 && room < 0.0) last = 0.0;
  }
  return {std::max(0.0, last - first), from + 0.5 * (first + last) * (to - from)};
}

/// The point of `other` that is deepest in `body`, under the face with the outward normal `normal`. If an edge or a face of `other` lies
/// along that face, the result is the middle of its part over the face, since each of its corners may be far outside the body.
/// \param lowest  index of the deepest vertex of `other`
/// \param depth  of that vertex under the face [m]
inline Vec3 meeting_point(const PlacedShape& other, const PlacedShape& body, Vec3 normal, std::size_t lowest, double depth) noexcept {
  const Vec3 deepest = other.vertex(lowest);
  const double low = dot(deepest, normal), face = low + depth;
  const auto is_deep = [&](Vec3 v) { return dot(v, normal) <= low + kFlush * norm(v - deepest); };
  const auto on_face = [&](Vec3 v) { return v + (face - dot(v, normal)) * normal; };
  const std::size_t count = other.shape.vertices.size();
  double length = 0.0;
  Vec3 sum;
  bool alone = true;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 from = other.vertex(i);
    if (i == lowest || !is_deep(from)) continue;
    alone = false;
    for (std::size_t j = 0; j < count; ++j) {
      const Vec3 to = other.vertex(j);
      if (j != lowest && (j <= i || !is_deep(to))) continue;
      const PartInside part = part_inside(body, on_face(from), on_face(to));
      if (part.share == 0.0) continue;
      const double weight = part.share * norm(to - from);
      length += weight, sum += weight * part.middle;
    }
  }
  if (alone) return deepest;
  if (length > 0.0) return sum / length - depth * normal;
  // No edge or diagonal crosses the face, so the face lies within them.
  double corners = 0.0;
  for (std::size_t i = 0; i < body.shape.vertices.size(); ++i) {
    if (const Vec3 v = body.vertex(i); dot(v, normal) >= face - kTouch) sum += v, corners += 1.0;
  }
  return corners > 0.0 ? sum / corners - depth * normal : deepest;
}

}  // namespace voussoir::kernels
