// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "kernels/contact/contact_patch.h"

/// Penetration depth of two convex bodies: the least translation that separates them, by separating axes. Exact for polyhedra: the axis is
/// a normal of one of their faces, or perpendicular to an edge of each.
namespace voussoir::kernels {

/// An edge between two faces.
struct Crease {
  Vec3 direction;                    // unit
  std::int32_t vertex = 0;           // vertex index of one end
  std::int32_t left = 0, right = 0;  // faces at the edge
};

/// A convex polyhedron in body axes, relative to its centroid.
struct ConvexShape {
  std::span<const Vec3> vertices;  // m
  std::span<const Vec3> edges;     // unit directions, parallel ones once; only of a small shape
  std::span<const Face> faces;
  std::span<const Crease> creases;  // present if some shape of the model is not small
};
inline constexpr std::size_t kFewFaces = 128;
inline constexpr std::size_t kFewVertices = 2 * kFewFaces - 4;  // most vertices of so many faces, unless vertices lie within edges
/// Whether a shape has so few faces and vertices that all axes are tried, in memory of a fixed size.
constexpr bool is_small(std::size_t faces, std::size_t vertices) noexcept { return faces <= kFewFaces && vertices <= kFewVertices; }
inline bool is_small(const ConvexShape& s) noexcept { return is_small(s.faces.size(), s.vertices.size()); }

/// The overlap along the axis of least depth, in global axes.
struct Overlap {
  double depth = 0.0;  // m; 0 or less: the bodies are apart by at least −depth
  Vec3 normal;         // unit, from the first body to the second
  Vec3 arm_a, arm_b;   // m, from the two centroids to the point of action, between the two features that meet
};

/// Overlap of two bodies.
/// \param from_a_to_b  m, between the centroids, global axes
/// \param enough  m; the search stops at the first axis with a depth of at most this, which need not be the least; arms are then not set
/// \pre if either shape is not small, both have creases
Overlap overlap_of(const ConvexShape& a, const Pose& pose_a, const ConvexShape& b, const Pose& pose_b, Vec3 from_a_to_b,
                   double enough) noexcept;

/// overlap_of for shapes of many faces or vertices, without axes that cannot have the least overlap. overlap_of calls it if either shape is
/// not small: the number of all axes is the product of their numbers of edges, and a sphere of 500 faces has 750 edges.
Overlap overlap_of_many(const ConvexShape& a, const Pose& pose_a, const ConvexShape& b, const Pose& pose_b, Vec3 from_a_to_b,
                        double enough) noexcept;

/// Overlap of a body and a half-space whose normal is +z.
/// \param height  m, of the body's centroid above the plane
Overlap overlap_with_base(const ConvexShape& a, const Pose& pose_a, double height) noexcept;

}  // namespace voussoir::kernels
