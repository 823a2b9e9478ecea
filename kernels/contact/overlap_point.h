// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "kernels/contact/overlap.h"

/// Where a body meets the face of another under which it is deepest. Internal to kernels/overlap*.cpp.
namespace voussoir::kernels {

inline constexpr double kFlush = 1e-9;  // m, vertices that differ by less are equally deep under a face: their edge or face lies along it

/// A convex body in the axes in which its overlap is looked at: those of one of the two bodies.
struct PlacedShape {
  const ConvexShape& shape;
  Mat3 turn;
  Vec3 centre;
  [[nodiscard]] Vec3 vertex(std::size_t i) const noexcept { return centre + turn * shape.vertices[i]; }
};

/// The part of a segment that lies in a body: its share of the length, and its middle.
struct PartInside {
  double share;
  Vec3 middle;
};
inline PartInside part_inside(const PlacedShape& body, Vec3 from, Vec3 to) noexcept {
  double first = 0.0, last = 1.0;
  for (const Face& f : body.shape.faces) {
    const Vec3 n = body.turn * f.normal;
    const double room = f.distance + kFlush - dot(n, from - body.centre), falls = dot(n, to - from);
    if (falls > 0.0) last = std::min(last, room / falls);
    if (falls < 0.0) first = std::max(first, room / falls);
    if (falls == 0.0 && room < 0.0) last = 0.0;
  }
  return {std::max(0.0, last - first), from + 0.5 * (first + last) * (to - from)};
}

/// The vertex that lies least far along the outward normal of a face, on its way into the body that has the face. An edge or a face that
/// lies along that face meets it in the middle of what is over it: each of its corners may be far beside the body.
/// \param lowest  the number of that vertex, and how far it lies
inline Vec3 meeting_point(const PlacedShape& other, const PlacedShape& body, Vec3 normal, std::size_t lowest, double low) noexcept {
  const auto is_deep = [&](Vec3 v) { return dot(v, normal) <= low + kFlush; };
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
      if ((j <= i && j != lowest) || !is_deep(to)) continue;
      const PartInside part = part_inside(body, from, to);
      if (part.share == 0.0) continue;
      const double weight = part.share * norm(to - from);
      length += weight, sum += weight * part.middle;
    }
  }
  if (alone) return other.vertex(lowest);
  if (length > 0.0) return sum / length;
  // Its edges and diagonals pass by: the face lies within them.
  double top = -1e300, corners = 0.0;
  for (std::size_t i = 0; i < body.shape.vertices.size(); ++i) top = std::max(top, dot(body.vertex(i), normal));
  for (std::size_t i = 0; i < body.shape.vertices.size(); ++i) {
    if (const Vec3 v = body.vertex(i); dot(v, normal) >= top - kFlush) sum += v, corners += 1.0;
  }
  return sum / corners + (low - top) * normal;
}

}  // namespace voussoir::kernels
