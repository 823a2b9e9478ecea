// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "kernels/contact/contact_patch.h"

/// How deep two convex bodies are in each other: the least translation that parts them, by separating axes. Exact for polyhedra: the axis
/// is a normal of one of their faces, or at right angles to an edge of each.
namespace voussoir::kernels {

/// An edge between two faces.
struct Crease {
  Vec3 direction;                    // unit
  std::int32_t vertex = 0;           // one of its ends
  std::int32_t left = 0, right = 0;  // faces
};

/// A convex polyhedron in its body axes, from its centroid.
struct ConvexShape {
  std::span<const Vec3> vertices;  // m
  std::span<const Vec3> edges;     // unit directions, parallel ones once; of a small shape
  std::span<const Face> faces;
  std::span<const Crease> creases;  // where some shape of the model is not small
};
inline constexpr std::size_t kFewFaces = 128;
inline constexpr std::size_t kFewVertices = 2 * kFewFaces - 4;  // at most, of so many faces, unless vertices lie within edges
/// Whether a shape has so few faces and vertices that all axes are tried, in room of a fixed size.
constexpr bool is_small(std::size_t faces, std::size_t vertices) noexcept { return faces <= kFewFaces && vertices <= kFewVertices; }
inline bool is_small(const ConvexShape& s) noexcept { return is_small(s.faces.size(), s.vertices.size()); }

/// Along the axis of least overlap, in global axes.
struct Overlap {
  double depth = 0.0;  // m; 0 or less: that far apart, or more
  Vec3 normal;         // unit, from the first body to the second
  Vec3 arm_a, arm_b;   // m, from the two centroids to the point between the two features that meet
};

/// \param from_a_to_b  m, between the centroids, global axes
/// \param enough       m; a depth at most this is not looked into any further: some axis has it, perhaps not the least one, and no arms
/// \pre where either is not small, both have creases
Overlap overlap_of(const ConvexShape& a, const Pose& pose_a, const ConvexShape& b, const Pose& pose_b, Vec3 from_a_to_b,
                   double enough) noexcept;

/// The same for shapes of many faces or vertices, with axes left out that cannot have the least overlap. overlap_of calls it where either
/// is not small: all axes would be as many as the product of their edges, and a sphere of 500 faces has 750.
Overlap overlap_of_many(const ConvexShape& a, const Pose& pose_a, const ConvexShape& b, const Pose& pose_b, Vec3 from_a_to_b,
                        double enough) noexcept;

/// The same against a half-space whose normal is +z.
/// \param height  m, of the body's centroid over its plane
Overlap overlap_with_base(const ConvexShape& a, const Pose& pose_a, double height) noexcept;

}  // namespace voussoir::kernels
