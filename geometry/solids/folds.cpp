// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/folds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

constexpr double kFlat = 1e-9;          // rad
constexpr double kNear = 1e-3;          // of the size
constexpr double kExactlyPlane = 1e-9;  // of the size: distance of corners that lie in the plane

Vec3 corner(const Mesh& m, std::int32_t v) { return nth(m.vertices, v); }

}  // namespace

HalfSpace half_space_of(const Mesh& m, std::size_t face) {
  const LoopPlane p = loop_plane(m, face);
  return {p.normal, dot(p.normal, p.centre)};
}

std::vector<Fold> reflex_folds(const Mesh& m) {
  std::vector<HalfSpace> plane;
  std::vector<std::array<std::int32_t, 3>> edges;  // from, to, face
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    plane.push_back(half_space_of(m, f));
    const auto& loop = m.faces[f];
    for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()], static_cast<std::int32_t>(f)});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Fold> out;
  for (const auto& [a, b, f] : edges) {
    if (a > b) continue;
    const auto back = std::lower_bound(edges.begin(), edges.end(), std::array{b, a, std::int32_t{-1}});
    const HalfSpace &left = nth(plane, f), &right = nth(plane, (*back)[2]);
    const Vec3 from = corner(m, a), along = normalised(corner(m, b) - from);
    const double sine = -dot(cross(left.normal, right.normal), along);
    if (sine <= kFlat) continue;
    const Vec3 normal = normalised(cross(along, left.normal + right.normal));
    out.push_back({a, b, left, right, {normal, dot(normal, from)}, std::atan2(sine, dot(left.normal, right.normal))});
  }
  return out;
}

HalfSpace cut_along(const Mesh& m, const Fold& fold, double snap) {
  const double size = diagonal(m), reach = std::min(snap, kNear * size);
  const Vec3 from = corner(m, fold.from), along = normalised(corner(m, fold.to) - from);
  Vec3 to_corner;
  double farthest = kNear * size, off = 0.0;
  for (const Vec3& v : m.vertices) {
    const double height = std::abs(dot(fold.between.normal, v) - fold.between.offset);
    const Vec3 aside = (v - from) - dot(v - from, along) * along;
    if (height > reach) continue;
    off = std::max(off, height);
    if (norm(aside) > farthest) farthest = norm(aside), to_corner = aside;
  }
  if (off <= kExactlyPlane * size || to_corner == Vec3{}) return fold.between;
  const Vec3 normal = normalised(cross(along, to_corner));
  return {normal, dot(normal, from)};
}

}  // namespace voussoir::geometry
