// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/contact/overlap.h"

#include <algorithm>
#include <cmath>

#include "geometry/nth.h"
#include "kernels/contact/overlap_point.h"

namespace voussoir::kernels {

namespace {

constexpr double kParallel = 1e-12;  // squared sine of two edges below which their normal is round-off; a face normal covers the axis

/// The vertex with the least coordinate along an axis.
struct Lowest {
  double value = 1e300;
  int vertex = 0;
};
Lowest lowest(std::span<const Vec3> vertices, Vec3 axis) noexcept {
  Lowest r;
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i) {
    const double x = dot(nth(vertices, i), axis);
    if (x < r.value) r = {x, i};
  }
  return r;
}

/// The axis of least depth so far, in axes of the first body, and the features that meet along it.
enum class Meets : std::uint8_t { face_of_a, face_of_b, edges };
struct Best {
  double depth = 1e300;
  Vec3 normal;
  Meets what = Meets::face_of_a;
  int edge_a = -1, edge_b = -1;  // of crossed edges
};

/// Both bodies in axes of the first.
struct PairOfShapes {
  const ConvexShape &a, &b;
  Mat3 turn;    // from axes of b to axes of a
  Vec3 centre;  // of b
  std::span<const Vec3> vertices_b;
};

void try_faces_of_a(const PairOfShapes& p, Best& best) noexcept {
  for (const Face& f : p.a.faces) {
    const Lowest low = lowest(p.vertices_b, f.normal);
    const double depth = f.distance - low.value;
    if (depth >= best.depth) continue;
    best = {depth, f.normal, Meets::face_of_a, -1, -1};
  }
}

void try_faces_of_b(const PairOfShapes& p, Best& best) noexcept {
  for (const Face& f : p.b.faces) {
    const Vec3 n = p.turn * f.normal;
    const Lowest low = lowest(p.a.vertices, n);
    const double depth = f.distance + dot(n, p.centre) - low.value;
    if (depth >= best.depth) continue;
    best = {depth, -n, Meets::face_of_b, -1, -1};
  }
}

/// Tries both senses of the normal of two edges. \param of_faces  m, the least depth along normals of faces
void try_axis(const PairOfShapes& p, Vec3 n, int edge_a, int edge_b, double of_faces, Best& best) noexcept {
  for (const double sign : {1.0, -1.0}) {
    const Vec3 axis = sign * n;
    const double depth = -lowest(p.a.vertices, -axis).value - lowest(p.vertices_b, axis).value;
    if (depth < std::min(best.depth, of_faces - kNoLess)) {
      best = {depth, axis, Meets::edges, edge_a, edge_b};
    } else {
      best.depth = std::min(best.depth, depth);
    }
  }
}

void try_crossed_edges(const PairOfShapes& p, double enough, Best& best) noexcept {
  const double of_faces = best.depth;
  for (int i = 0; i < static_cast<int>(p.a.edges.size()); ++i) {
    for (int j = 0; j < static_cast<int>(p.b.edges.size()); ++j) {
      const Vec3 n = cross(nth(p.a.edges, i), p.turn * nth(p.b.edges, j));
      const double square = dot(n, n);
      if (square < kParallel) continue;
      try_axis(p, n / std::sqrt(square), i, j, of_faces, best);
      if (best.depth <= enough) return;
    }
  }
}

/// The point midway between the two crossed edges at their nearest.
Vec3 point_of_crossed_edges(const PairOfShapes& p, const Best& best) noexcept {
  const Vec3 a = nth(p.a.vertices, lowest(p.a.vertices, -best.normal).vertex);
  const Vec3 b = nth(p.vertices_b, lowest(p.vertices_b, best.normal).vertex);
  const Vec3 ea = nth(p.a.edges, best.edge_a), eb = p.turn * nth(p.b.edges, best.edge_b);
  const Vec3 from = b - a;
  const double c = dot(ea, eb), along_a = dot(from, ea), along_b = dot(from, eb), sine2 = 1.0 - c * c;
  const double s = (along_a - c * along_b) / sine2, t = (c * along_a - along_b) / sine2;
  return 0.5 * ((a + s * ea) + (b + t * eb));
}

/// The point midway between the two features that meet.
Vec3 point_of(const PairOfShapes& p, const Best& best) noexcept {
  if (best.what == Meets::edges) return point_of_crossed_edges(p, best);
  const PlacedShape a{p.a, Mat3{}, {}}, b{p.b, p.turn, p.centre};
  const bool of_a = best.what == Meets::face_of_a;
  const Vec3 outward = of_a ? best.normal : -best.normal;
  const Lowest low = of_a ? lowest(p.vertices_b, outward) : lowest(p.a.vertices, outward);
  return meeting_point(of_a ? b : a, of_a ? a : b, outward, static_cast<std::size_t>(low.vertex), best.depth) + 0.5 * best.depth * outward;
}

/// Uninitialised memory for the vertices of the largest small shape; most shapes use little of it.
union VertexRoom {
  VertexRoom() noexcept {}  // NOLINT(modernize-use-equals-default): would set all of it
  Vec3 at[kFewVertices];
};

Vec3 turned(const Pose& p, Vec3 r) noexcept { return r + p.d * r; }
Vec3 turned_back(const Pose& p, Vec3 r) noexcept { return r + transposed(p.d) * r; }

}  // namespace

Overlap overlap_of(const ConvexShape& a, const Pose& pose_a, const ConvexShape& b, const Pose& pose_b, Vec3 from_a_to_b,
                   double enough) noexcept {
  if (!is_small(a) || !is_small(b)) return overlap_of_many(a, pose_a, b, pose_b, from_a_to_b, enough);
  VertexRoom room;
  Vec3* const vertices = room.at;
  const std::size_t count = b.vertices.size();
  PairOfShapes p{a, b, transposed(Mat3{} + pose_a.d) * (Mat3{} + pose_b.d), turned_back(pose_a, from_a_to_b), {vertices, count}};
  for (std::size_t i = 0; i < count; ++i) vertices[i] = p.centre + p.turn * b.vertices[i];
  Best best;
  try_faces_of_a(p, best);
  if (best.depth > enough) try_faces_of_b(p, best);
  if (best.depth > enough) try_crossed_edges(p, enough, best);
  if (best.depth <= enough) return {best.depth, turned(pose_a, best.normal), {}, {}};
  Overlap r{best.depth, turned(pose_a, best.normal), turned(pose_a, point_of(p, best)), {}};
  r.arm_b = r.arm_a - from_a_to_b;
  return r;
}

Overlap overlap_with_base(const ConvexShape& a, const Pose& pose_a, double height) noexcept {
  const Vec3 up = turned_back(pose_a, {0.0, 0.0, 1.0});
  const Lowest low = lowest(a.vertices, up);
  const double depth = -(height + low.value);
  const Vec3 deepest = nth(a.vertices, low.vertex);
  Vec3 sum;  // of equally deep vertices: a level edge or face meets the base in its middle
  double deep = 0.0;
  for (const Vec3& v : a.vertices) {
    if (dot(v, up) <= low.value + kFlush * norm(v - deepest)) sum += v, deep += 1.0;
  }
  const Vec3 point = deep > 1.0 ? sum / deep : deepest;
  Overlap r{depth, {0.0, 0.0, -1.0}, turned(pose_a, point) + Vec3{0.0, 0.0, 0.5 * depth}, {}};
  r.arm_b = r.arm_a;
  return r;
}

}  // namespace voussoir::kernels
