// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polyhedron.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/message.h"
#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Twice the signed area of the polygon, counted about its first corner.
double doubled_area(std::span<const std::array<double, 2>> corners) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const double ay = corners[i][0] - corners[0][0], az = corners[i][1] - corners[0][1];
    const double by = corners[i + 1][0] - corners[0][0], bz = corners[i + 1][1] - corners[0][1];
    sum += ay * bz - az * by;
  }
  return sum;
}

void check_prism(std::span<const std::array<double, 2>> corners, double x0, double x1) {
  if (corners.size() < 3) throw ModelError("a prism needs 3 corners or more, not " + std::to_string(corners.size()), -1);
  if (!(std::isfinite(x0) && std::isfinite(x1) && x0 < x1)) {
    throw ModelError("a prism from x0 = " + figure(x0) + " m to x1 = " + figure(x1) + " m: x0 must be less than x1", -1);
  }
  double perimeter = 0.0, shortest = INFINITY;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& a = corners[i];
    const auto& b = corners[(i + 1) % corners.size()];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    perimeter += length;
    shortest = std::min(shortest, length);
  }
  const double area = 0.5 * std::abs(doubled_area(corners));
  if (!std::isfinite(perimeter) || !(shortest > 1e-9 * perimeter) || !(area > 1e-12 * perimeter * perimeter)) {
    throw ModelError("degenerate polygon of a prism: area " + figure(area) + " m2, shortest edge " + figure(shortest) + " m", -1);
  }
}

}  // namespace

Polyhedron make_box(Vec3 low, Vec3 high) {
  const Vec3 edges = high - low;
  if (!is_finite(edges) || !(edges.x > 0.0 && edges.y > 0.0 && edges.z > 0.0)) {
    throw ModelError(
        "a box with edges " + figure(edges.x) + " x " + figure(edges.y) + " x " + figure(edges.z) + " m: every edge must be positive", -1);
  }
  const std::array<Vec3, 8> vertices{{{low.x, low.y, low.z},
                                      {high.x, low.y, low.z},
                                      {high.x, high.y, low.z},
                                      {low.x, high.y, low.z},
                                      {low.x, low.y, high.z},
                                      {high.x, low.y, high.z},
                                      {high.x, high.y, high.z},
                                      {low.x, high.y, high.z}}};
  return make_hexahedron(vertices);
}

Polyhedron make_hexahedron(std::span<const Vec3, 8> vertices) {
  static const FaceLoops kFaces = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  return {{vertices.begin(), vertices.end()}, kFaces};
}

Polyhedron make_prism(std::span<const std::array<double, 2>> polygon_yz, double x0, double x1) {
  check_prism(polygon_yz, x0, x1);
  std::vector<std::array<double, 2>> ring(polygon_yz.begin(), polygon_yz.end());
  if (doubled_area(ring) < 0.0) std::reverse(ring.begin() + 1, ring.end());
  const auto n = static_cast<std::int32_t>(ring.size());

  Polyhedron p;
  for (const double x : {x0, x1}) {
    for (const auto& corner : ring) p.vertices.push_back({x, corner[0], corner[1]});
  }
  if (n == 4) return make_hexahedron(std::span<const Vec3, 8>(p.vertices));
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t next = (i + 1) % n;
    p.faces.push_back({i, next, next + n, i + n});
  }
  std::vector<std::int32_t> loop(ring.size());
  std::iota(loop.begin(), loop.end(), n);
  p.faces.push_back(loop);
  std::iota(loop.rbegin(), loop.rend(), 0);
  p.faces.insert(p.faces.end() - 1, loop);
  return p;
}

Polyhedron rotated(const Polyhedron& p, Vec3 axis, double angle, Vec3 about) {
  const Vec3 e = normalised(axis);
  double c = std::cos(angle), s = std::sin(angle);
  // cos(π/2) is 6e-17 in floating point; set to zero, so that a quarter turn of a box gives a box.
  if (std::abs(c) < 1e-15) c = 0.0, s = std::copysign(1.0, s);
  if (std::abs(s) < 1e-15) s = 0.0, c = std::copysign(1.0, c);
  Polyhedron out = p;
  for (Vec3& v : out.vertices) {
    const Vec3 r = v - about;
    v = about + (c * r + s * cross(e, r) + ((1.0 - c) * dot(e, r)) * e);
  }
  return out;
}

Polyhedron moved(const Polyhedron& p, Vec3 by) {
  Polyhedron out = p;
  for (Vec3& v : out.vertices) v += by;
  return out;
}

Polyhedron mirrored(const Polyhedron& p, Vec3 n, Vec3 at) {
  const std::size_t count = p.vertices.size();
  // A mirrored cell with its vertices in the old order would be inside out for VTK, so bottom and top ring are exchanged.
  const std::size_t shift = count % 2 == 0 ? count / 2 : 0;
  Polyhedron out = p;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 v = p.vertices[i];
    out.vertices[(i + shift) % count] = v - (2.0 * dot(v - at, n)) * n;
  }
  for (auto& loop : out.faces) {
    for (std::int32_t& i : loop) i = static_cast<std::int32_t>((static_cast<std::size_t>(i) + shift) % count);
    std::reverse(loop.begin(), loop.end());
  }
  return out;
}

FacePlane face_plane(const Polyhedron& p, int face) {
  const auto& loop = nth(p.faces, face);
  const auto at = [&](std::size_t i) { return nth(p.vertices, loop[i]); };
  const Vec3 first = at(0);
  Vec3 doubled;  // Σ of the fan's cross products: twice the area times the normal
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) doubled += cross(at(i) - first, at(i + 1) - first);
  const Vec3 normal = normalised(doubled);
  Vec3 moment;
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vec3 a = at(i) - first, b = at(i + 1) - first;
    const double weight = dot(cross(a, b), normal);
    moment += weight * (a + b);
    sum += weight;
  }
  return {normal, 0.5 * sum, first + moment / (3.0 * sum)};
}

double least_width(const Polyhedron& p) {
  double least = INFINITY;
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const FacePlane plane = face_plane(p, static_cast<int>(f));
    double width = 0.0;
    for (const Vec3& v : p.vertices) width = std::max(width, dot(plane.centroid - v, plane.normal));
    least = std::min(least, width);
  }
  return least;
}

Box3 bounds(const Polyhedron& p) {
  Box3 box{p.vertices.front(), p.vertices.front()};
  for (const Vec3& v : p.vertices) {
    box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y), std::min(box.low.z, v.z)};
    box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y), std::max(box.high.z, v.z)};
  }
  return box;
}

}  // namespace voussoir::geometry
