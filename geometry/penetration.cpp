// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "geometry/nth.h"
#include "geometry/segments/touching.h"

namespace voussoir::geometry {

namespace {

struct Interval {
  double low, high;
};

/// Interval of the vertices along an axis, counted from `origin`, so that elements far from the global origin keep their digits.
Interval project(const Polyhedron& p, Vec3 axis, Vec3 origin) {
  Interval r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec3& v : p.vertices) {
    const double x = dot(v - origin, axis);
    r.low = std::min(r.low, x), r.high = std::max(r.high, x);
  }
  return r;
}

/// Least depth of `other` behind a face of `element` [m]. Stops at the first depth of at most `enough`.
double depth_behind_faces(const Scene& scene, std::int32_t element, std::int32_t other, double enough) {
  const Element& e = nth(scene.elements, element);
  const Polyhedron& shape = *nth(scene.parts, other).shape;
  double least = std::numeric_limits<double>::infinity();
  for (std::int32_t f = e.first_face; f < e.first_face + e.face_count; ++f) {
    const PlacedGrid& g = nth(scene.grids, f);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& v : shape.vertices) lowest = std::min(lowest, dot(v - g.origin, g.grid->normal));
    least = std::min(least, -lowest);
    if (least <= enough) break;
  }
  return least;
}

/// Unit directions of the edges, parallel ones once.
std::vector<Vec3> edge_directions(const Polyhedron& p) {
  std::vector<Vec3> out;
  for (const auto& loop : p.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 from = nth(p.vertices, loop[i]);
      const Vec3 to = nth(p.vertices, loop[(i + 1) % loop.size()]);
      const Vec3 e = normalised(to - from);
      const auto parallel = [&](Vec3 o) { return norm(cross(o, e)) < 1e-9; };
      if (std::none_of(out.begin(), out.end(), parallel)) out.push_back(e);
    }
  }
  return out;
}

}  // namespace

double penetration(const Scene& scene, std::int32_t a, std::int32_t b, double enough) {
  double least = depth_behind_faces(scene, a, b, enough);
  if (least <= enough) return least;
  least = std::min(least, depth_behind_faces(scene, b, a, enough));
  if (least <= enough) return least;

  const Polyhedron& shape_a = *nth(scene.parts, a).shape;
  const Polyhedron& shape_b = *nth(scene.parts, b).shape;
  const Vec3 origin = shape_a.vertices.front();
  const std::vector<Vec3> edges_b = edge_directions(shape_b);
  for (const Vec3& ea : edge_directions(shape_a)) {
    for (const Vec3& eb : edges_b) {
      const Vec3 product = cross(ea, eb);
      // The product of edges closer to parallel than this is round-off; a face normal covers the axis.
      if (norm(product) < 1e-6) continue;
      const Vec3 axis = normalised(product);
      const Interval pa = project(shape_a, axis, origin), pb = project(shape_b, axis, origin);
      least = std::min({least, pa.high - pb.low, pb.high - pa.low});
      if (least <= enough) return least;
    }
  }
  return least;
}

}  // namespace voussoir::geometry
