// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/nth.h"
#include "geometry/polyhedron.h"
#include "solver/world/world.h"

/// Pose of an element and of a patch, and what lies between them. Internal to solver/contact/.
namespace voussoir::solver {

struct PlacedElement {
  Vec3 x;  // m, centroid
  Mat3 r;  // orientation
};

inline PlacedElement placed_element(const World& w, std::int32_t e) {
  const kernels::Pose p = kernels::load_pose(w.elements.pose.data(), e);
  return {nth(w.elements.body, e).ref + p.u, Mat3{} + p.d};
}

inline Vec3 absolute(Vec3 v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// Half extents of an element's box in its own axes [m].
inline Vec3 half_extents(const World& w, std::int32_t e) {
  const auto i = static_cast<std::size_t>(e);
  return {w.elements.half_x[i], w.elements.half_y[i], w.elements.half_z[i]};
}

/// Bounding box of an element in a pose, along the global axes.
inline geometry::Box3 box_of(const World& w, std::int32_t e, const PlacedElement& at) {
  const Vec3 h = half_extents(w, e);
  const Vec3 half{dot(absolute(at.r.r0), h), dot(absolute(at.r.r1), h), dot(absolute(at.r.r2), h)};
  return {at.x - half, at.x + half};
}

/// As it stood when it was searched last.
inline PlacedElement placed_then(const World& w, std::int32_t e) {
  const Travel::Pose p = w.travel.searched_pose(e);
  return {nth(w.elements.body, e).ref + p.u, p.r};
}

/// A patch in the pose of its element.
struct PlacedPatch {
  Vec3 centre, es, et;  // of its rectangle; half edges
  geometry::Box3 box;
};
inline PlacedPatch placed(const kernels::Patch& k, const PlacedElement& b) {
  const Vec3 middle = k.centre + 0.5 * (k.s_low + k.s_high) * k.es + 0.5 * (k.t_low + k.t_high) * k.et;
  PlacedPatch r;
  r.centre = b.x + b.r * middle;
  r.es = 0.5 * (k.s_high - k.s_low) * (b.r * k.es);
  r.et = 0.5 * (k.t_high - k.t_low) * (b.r * k.et);
  const Vec3 half = absolute(r.es) + absolute(r.et);
  r.box = {r.centre - half, r.centre + half};
  return r;
}

/// A patch in the axes of another element, about its centroid: middle and half edges of its rectangle.
struct SeenPatch {
  Vec3 centre, es, et;
};
inline SeenPatch seen_from(const PlacedElement& b, const PlacedPatch& p) {
  const Mat3 back = transposed(b.r);
  return {back * (p.centre - b.x), back * p.es, back * p.et};
}

/// Least distance [m] to the plane of a face over the rectangle; below 0: some of it lies behind the plane.
inline double least_distance(const kernels::Face& face, const SeenPatch& p) {
  const double reach = std::abs(dot(face.normal, p.es)) + std::abs(dot(face.normal, p.et));
  return dot(face.normal, p.centre) - face.distance - reach;
}

}  // namespace voussoir::solver
