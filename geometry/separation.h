// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/polyhedron.h"

/// How deep two convex polyhedra are in each other, and how far they are apart, wherever they lie: exact but for round-off, by separating
/// axes and by distances between features. Shares no code with the contact of the kernels, so that it can judge it.
namespace voussoir::geometry {

/// The points x with normal · x <= offset. Unit normal, outward; m.
struct HalfSpace {
  Vec3 normal;
  double offset = 0.0;
};

/// A convex polyhedron with what questions about two of them need. Global axes once it is placed.
struct ConvexBody {
  std::vector<Vec3> vertices;  // m
  std::vector<HalfSpace> faces;
  std::vector<std::array<std::int32_t, 2>> edges;  // vertices at both ends, each edge once
  std::vector<Vec3> directions;                    // of the edges, unit, parallel ones once
};

/// From the vertices and the planes of all faces: edges are where two faces meet.
/// \pre convex and closed; vertices lie on their faces to 1e-7 of the size
ConvexBody convex_body(std::vector<Vec3> vertices, std::vector<HalfSpace> faces);
/// \pre the polyhedron is valid
ConvexBody convex_body(const Polyhedron& p);

/// Turns a body about the origin and moves it. \param out  overwritten; asks for no memory where it held as large a body before
void place(const ConvexBody& body, const Mat3& rotation, Vec3 by, ConvexBody& out);
ConvexBody placed(const ConvexBody& body, const Mat3& rotation, Vec3 by);

/// The least translation that parts two bodies.
struct Penetration {
  double depth = 0.0;  // m; 0 or less: they are apart, by as much or more
  Vec3 axis;           // unit; moving the second body by `depth` along it parts them
};

/// Over the normals of the faces of both and the products of their edges. \param enough  m; as soon as some axis shows no more than this,
/// its depth is returned, which need not be the least
Penetration penetration_of(const ConvexBody& a, const ConvexBody& b, double enough = -std::numeric_limits<double>::infinity());

/// Between the nearest points of two bodies, m; 0 if they touch or overlap.
double distance(const ConvexBody& a, const ConvexBody& b);

/// Under the plane z = `height`: of the lowest vertex, m; below 0: above the plane by as much.
double depth_under(const ConvexBody& a, double height);

}  // namespace voussoir::geometry
