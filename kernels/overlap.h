// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "kernels/contact_patch.h"

/// How deep two convex bodies are in each other: the least translation that parts them, by separating axes. Exact for polyhedra: the axis
/// is a normal of one of their faces, or at right angles to an edge of each.
namespace voussoir::kernels {

/// A convex polyhedron in its body axes, from its centroid.
struct ConvexShape {
  std::span<const Vec3> vertices;  // m, at most kMostVertices
  std::span<const Vec3> edges;     // unit directions, parallel ones once
  std::span<const Face> faces;
};
inline constexpr int kMostVertices = 2 * kMostFaces - 4;  // of a convex polyhedron with so many faces

/// Along the axis of least overlap, in global axes.
struct Overlap {
  double depth = 0.0;  // m; 0 or less: that far apart, or more
  Vec3 normal;         // unit, from the first body to the second
  Vec3 arm_a, arm_b;   // m, from the two centroids to the point between the two features that meet
};

/// \param from_a_to_b  m, between the centroids, global axes
/// \param enough       m; a depth at most this is not looked into any further: some axis has it, perhaps not the least one
Overlap overlap_of(const ConvexShape& a, const Pose& pose_a, const ConvexShape& b, const Pose& pose_b, Vec3 from_a_to_b,
                   double enough) noexcept;

/// The same against a half-space whose normal is +z.
/// \param height  m, of the body's centroid over its plane
Overlap overlap_with_base(const ConvexShape& a, const Pose& pose_a, double height) noexcept;

}  // namespace voussoir::kernels
