// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/nth.h"
#include "geometry/polyhedron.h"
#include "solver/world/world.h"

/// Pose of an element, and its bounding box. Internal to solver/contact/.
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

}  // namespace voussoir::solver
