// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "geometry/nth.h"
#include "kernels/contact/overlap.h"
#include "kernels/contact/overlap_point.h"

/// Axes that cannot have the least overlap are skipped by a bound. The depth along a unit axis n, outward from a, is the distance of a's
/// supporting plane from any point q, plus the reach of b past q against n. If q belongs to b, the second term is not negative. Therefore
/// - a face has at least the depth of q under it,
/// - no axis of an edge of a is better than the least depth so far if q is deeper than that under both faces of the edge: a normal between
/// two unit normals is a sum of both, divided by a length of at most the sum of the parts.
namespace voussoir::kernels {

namespace {

constexpr double kParallel = 1e-12;  // as in overlap.cpp
constexpr double kRound = 1e-9;      // sine of the angle by which an axis may miss the normals of its edge

/// The second body in the frame of the first: its points are centre + turn · r.
struct Pairing {
  const ConvexShape &own, &other;
  Mat3 turn;
  Vec3 centre;
  [[nodiscard]] Vec3 of_other(std::int32_t vertex) const noexcept { return centre + turn * nth(other.vertices, vertex); }
};

const Vec3& vertex_of(const ConvexShape& s, std::int32_t i) noexcept { return nth(s.vertices, i); }
const Face& face_of(const ConvexShape& s, std::int32_t i) noexcept { return nth(s.faces, i); }

/// The vertex with the least coordinate along an axis.
std::int32_t lowest(const ConvexShape& s, Vec3 axis) noexcept {
  double least = 1e300;
  std::int32_t at = 0;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(s.vertices.size()); ++i) {
    const double x = dot(vertex_of(s, i), axis);
    if (x < least) least = x, at = i;
  }
  return at;
}

/// The vertex of the other body that reaches farthest against an axis of the first body.
Vec3 reaching(const Pairing& p, Vec3 axis) noexcept { return p.of_other(lowest(p.other, transposed(p.turn) * axis)); }

/// Depth of a point under a face [m].
double under(const Face& f, Vec3 q) noexcept { return f.distance - dot(f.normal, q); }

struct BestFace {
  double depth = 1e300;
  Vec3 normal, reached;  // outward from its body; the point of the other body deepest under it
};

/// The point midway between the face and the part of the other body deepest under it.
Vec3 point_under(const Pairing& p, const BestFace& best) noexcept {
  const std::int32_t low = lowest(p.other, transposed(p.turn) * best.normal);
  const PlacedShape other{p.other, p.turn, p.centre}, own{p.own, Mat3{}, {}};
  return meeting_point(other, own, best.normal, static_cast<std::size_t>(low), best.depth) + 0.5 * best.depth * best.normal;
}

/// The face of the first body under which the other body is least deep. \param depth  only lesser depths are searched
BestFace best_face(const Pairing& p, double depth) noexcept {
  const double apart = norm(p.centre);
  BestFace best;
  best.reached = reaching(p, apart > 0.0 ? p.centre / apart : Vec3{1.0, 0.0, 0.0});
  best.depth = depth;
  const auto try_face = [&](const Face& f) {
    if (under(f, best.reached) >= best.depth) return;
    const Vec3 q = reaching(p, f.normal);
    if (under(f, q) < best.depth) best = {under(f, q), f.normal, q};
  };
  const auto least = std::ranges::min_element(p.own.faces, {}, [&](const Face& f) { return under(f, best.reached); });
  try_face(*least);
  for (const Face& f : p.own.faces) try_face(f);
  return best;
}

/// The axis of least depth so far, in axes of the first body.
struct Best {
  double depth = 1e300;
  Vec3 normal, point;
};

/// Whether an axis of the edge may have less depth. \param q  a point of the other body
bool is_near(const ConvexShape& s, const Crease& e, Vec3 q, double depth) noexcept {
  return std::min(under(face_of(s, e.left), q), under(face_of(s, e.right), q)) < std::max(depth, 0.0);
}

/// Whether the body lies behind the plane through its edge with the normal n, which is perpendicular to the edge. Where the edge is sharp,
/// also true for some other normals.
bool supports(const ConvexShape& s, const Crease& e, Vec3 n) noexcept {
  const Vec3 left = face_of(s, e.left).normal, right = face_of(s, e.right).normal;
  const double between = dot(left, right) - kRound;
  return dot(n, left) >= between && dot(n, right) >= between;
}

/// The point midway between two crossing edges at their nearest.
Vec3 between(Vec3 a, Vec3 along_a, Vec3 b, Vec3 along_b) noexcept {
  const Vec3 from = b - a;
  const double c = dot(along_a, along_b), x = dot(from, along_a), y = dot(from, along_b), sine2 = 1.0 - c * c;
  return 0.5 * ((a + (x - c * y) / sine2 * along_a) + (b + (c * x - y) / sine2 * along_b));
}

/// Tries both senses of the normal of two edges. \param of_faces  m, the least depth along normals of faces
void try_edges(const Pairing& p, const Crease& ea, const Crease& eb, double of_faces, Best& best) noexcept {
  const Vec3 along = p.turn * eb.direction, n = cross(ea.direction, along);
  const double square = dot(n, n);
  if (square < kParallel) return;
  for (const double length : {std::sqrt(square), -std::sqrt(square)}) {
    const Vec3 axis = n / length;
    if (!supports(p.own, ea, axis) || !supports(p.other, eb, transposed(p.turn) * -axis)) continue;
    const double depth = dot(axis, vertex_of(p.own, lowest(p.own, -axis)) - reaching(p, axis));
    const bool less = depth < std::min(best.depth, of_faces - kNoLess);
    best.depth = std::min(best.depth, depth);
    if (less) best = {depth, axis, between(vertex_of(p.own, ea.vertex), ea.direction, p.of_other(eb.vertex), along)};
  }
}

void try_crossed_edges(const Pairing& p, double enough, Best& best) noexcept {
  const double of_faces = best.depth;
  const Vec3 of_other = reaching(p, best.normal), of_own = vertex_of(p.own, lowest(p.own, -best.normal));
  const Vec3 of_own_there = transposed(p.turn) * (of_own - p.centre);
  for (const Crease& ea : p.own.creases) {
    if (!is_near(p.own, ea, of_other, best.depth)) continue;
    for (const Crease& eb : p.other.creases) {
      if (!is_near(p.other, eb, of_own_there, best.depth)) continue;
      try_edges(p, ea, eb, of_faces, best);
      if (best.depth <= enough) return;
    }
  }
}

}  // namespace

Overlap overlap_of_many(const ConvexShape& a, const Pose& pose_a, const ConvexShape& b, const Pose& pose_b, Vec3 from_a_to_b,
                        double enough) noexcept {
  const Mat3 ra = Mat3{} + pose_a.d, turn = transposed(ra) * (Mat3{} + pose_b.d);
  const Vec3 centre = transposed(ra) * from_a_to_b;
  const Pairing p{a, b, turn, centre}, back{b, a, transposed(turn), transposed(turn) * -centre};
  const BestFace of_a = best_face(p, 1e300);
  Best best{of_a.depth, of_a.normal, {}};
  if (best.depth > enough) best.point = point_under(p, of_a);
  if (best.depth > enough) {
    const BestFace of_b = best_face(back, best.depth);
    if (of_b.depth < best.depth) best = {of_b.depth, -(turn * of_b.normal), centre + turn * point_under(back, of_b)};
  }
  if (best.depth > enough) try_crossed_edges(p, enough, best);
  Overlap r{best.depth, ra * best.normal, ra * best.point, {}};
  r.arm_b = r.arm_a - from_a_to_b;
  return r;
}

}  // namespace voussoir::kernels
