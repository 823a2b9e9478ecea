// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/separation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

constexpr double kOnFace = 1e-7;    // of the size of a body: allowed distance of a vertex from the plane of its face
constexpr double kParallel = 1e-9;  // sine of the angle below which directions count as parallel

double size_of(std::span<const Vec3> vertices) {
  double most = 0.0;
  for (const Vec3& v : vertices) most = std::max(most, norm(v - vertices.front()));
  return most;
}

/// Faces that contain a vertex, ascending.
std::vector<std::int32_t> faces_at(Vec3 v, std::span<const HalfSpace> faces, double allowed) {
  std::vector<std::int32_t> on;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (std::abs(dot(faces[f].normal, v) - faces[f].offset) <= allowed) on.push_back(static_cast<std::int32_t>(f));
  }
  return on;
}

bool share_two(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
  std::vector<std::int32_t> both;
  std::ranges::set_intersection(a, b, std::back_inserter(both));
  return both.size() >= 2;
}

void add_direction(std::vector<Vec3>& directions, Vec3 edge) {
  const Vec3 d = normalised(edge);
  if (std::ranges::none_of(directions, [&](Vec3 o) { return norm(cross(o, d)) < kParallel; })) directions.push_back(d);
}

/// The least coordinate of the vertices along an axis [m]. The greatest is minus that along the opposite axis.
double lowest(std::span<const Vec3> vertices, Vec3 axis) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& v : vertices) least = std::min(least, dot(v, axis));
  return least;
}

/// The axis of least depth so far. take() returns true once the depth is at most `enough`.
class LeastOverlap {
 public:
  explicit LeastOverlap(double enough) : enough_(enough) {}
  bool take(double depth, Vec3 axis) {
    if (depth < best_.depth) best_ = {depth, axis};
    return best_.depth <= enough_;
  }
  [[nodiscard]] const Penetration& best() const { return best_; }

 private:
  double enough_;
  Penetration best_{std::numeric_limits<double>::infinity(), {}};
};

bool try_edges(const ConvexBody& a, const ConvexBody& b, LeastOverlap& least) {
  for (const Vec3& ea : a.directions) {
    for (const Vec3& eb : b.directions) {
      const Vec3 product = cross(ea, eb);
      if (norm(product) < kParallel) continue;  // nearly parallel edges: the product is round-off, and a face normal covers the axis
      const Vec3 axis = normalised(product);
      const double low_a = lowest(a.vertices, axis), high_a = -lowest(a.vertices, -axis);
      const double low_b = lowest(b.vertices, axis), high_b = -lowest(b.vertices, -axis);
      if (least.take(high_a - low_b, axis) || least.take(high_b - low_a, -axis)) return true;
    }
  }
  return false;
}

/// Squared distance from a point to a face [m2].
double from_point_to_face(Vec3 p, const ConvexBody& b, const HalfSpace& face, double allowed) {
  const double height = dot(face.normal, p) - face.offset;
  const Vec3 foot = p - height * face.normal;
  const bool on_it = std::ranges::all_of(b.faces, [&](const HalfSpace& f) { return dot(f.normal, foot) - f.offset <= allowed; });
  return on_it ? height * height : std::numeric_limits<double>::infinity();
}

double from_vertices_to_faces(const ConvexBody& a, const ConvexBody& b) {
  const double allowed = kParallel * size_of(b.vertices);
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& v : a.vertices) {
    for (const HalfSpace& f : b.faces) least = std::min(least, from_point_to_face(v, b, f, allowed));
  }
  return least;
}

/// Squared distance between two segments p + s u and q + t v, 0 <= s, t <= 1 [m2]: between the lines, or from an end to the other segment.
double between_segments(Vec3 p, Vec3 u, Vec3 q, Vec3 v) {
  const auto end_to = [](Vec3 end, Vec3 from, Vec3 along) {
    const double t = std::clamp(dot(end - from, along) / dot(along, along), 0.0, 1.0);
    const Vec3 r = end - (from + t * along);
    return dot(r, r);
  };
  double least = std::min({end_to(p, q, v), end_to(p + u, q, v), end_to(q, p, u), end_to(q + v, p, u)});
  const Vec3 normal = cross(u, v), between = q - p;
  const double square = dot(normal, normal);
  if (square <= kParallel * kParallel * dot(u, u) * dot(v, v)) return least;
  const double s = dot(cross(between, v), normal) / square, t = dot(cross(between, u), normal) / square;
  if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
    const double apart = dot(between, normal);
    least = std::min(least, apart * apart / square);
  }
  return least;
}

double between_edges(const ConvexBody& a, const ConvexBody& b) {
  const auto from = [](const ConvexBody& c, const auto& e) { return nth(c.vertices, e[0]); };
  const auto along = [](const ConvexBody& c, const auto& e) { return nth(c.vertices, e[1]) - nth(c.vertices, e[0]); };
  double least = std::numeric_limits<double>::infinity();
  for (const auto& ea : a.edges) {
    for (const auto& eb : b.edges) least = std::min(least, between_segments(from(a, ea), along(a, ea), from(b, eb), along(b, eb)));
  }
  return least;
}

}  // namespace

ConvexBody convex_body(std::vector<Vec3> vertices, std::vector<HalfSpace> faces) {
  ConvexBody body;
  const double allowed = kOnFace * size_of(vertices);
  std::vector<std::vector<std::int32_t>> on;
  for (const Vec3& v : vertices) on.push_back(faces_at(v, faces, allowed));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t k = i + 1; k < vertices.size(); ++k) {
      if (!share_two(on[i], on[k])) continue;
      body.edges.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(k)});
      add_direction(body.directions, vertices[k] - vertices[i]);
    }
  }
  body.vertices = std::move(vertices), body.faces = std::move(faces);
  return body;
}

ConvexBody convex_body(const Polyhedron& p) {
  std::vector<HalfSpace> faces;
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const FacePlane plane = face_plane(p, static_cast<int>(f));
    faces.push_back({plane.normal, dot(plane.normal, plane.centroid)});
  }
  return convex_body(p.vertices, std::move(faces));
}

void place(const ConvexBody& body, const Mat3& rotation, Vec3 by, ConvexBody& out) {
  out.vertices.resize(body.vertices.size());
  out.faces.resize(body.faces.size());
  out.directions.resize(body.directions.size());
  out.edges = body.edges;
  std::ranges::transform(body.vertices, out.vertices.begin(), [&](Vec3 v) { return by + rotation * v; });
  std::ranges::transform(body.directions, out.directions.begin(), [&](Vec3 d) { return rotation * d; });
  std::ranges::transform(body.faces, out.faces.begin(), [&](const HalfSpace& f) {
    const Vec3 n = rotation * f.normal;
    return HalfSpace{n, f.offset + dot(n, by)};
  });
}

ConvexBody placed(const ConvexBody& body, const Mat3& rotation, Vec3 by) {
  ConvexBody out = body;
  place(body, rotation, by, out);
  return out;
}

Penetration penetration_of(const ConvexBody& a, const ConvexBody& b, double enough) {
  LeastOverlap least(enough);
  for (const HalfSpace& f : a.faces) {
    if (least.take(f.offset - lowest(b.vertices, f.normal), f.normal)) return least.best();
  }
  for (const HalfSpace& f : b.faces) {
    if (least.take(f.offset - lowest(a.vertices, f.normal), -f.normal)) return least.best();
  }
  try_edges(a, b, least);
  return least.best();
}

double distance(const ConvexBody& a, const ConvexBody& b) {
  if (penetration_of(a, b, 0.0).depth > 0.0) return 0.0;
  return std::sqrt(std::min({from_vertices_to_faces(a, b), from_vertices_to_faces(b, a), between_edges(a, b)}));
}

double depth_under(const ConvexBody& a, double height) { return height - lowest(a.vertices, {0.0, 0.0, 1.0}); }

}  // namespace voussoir::geometry
