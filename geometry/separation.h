// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/polyhedron.h"

/// Penetration depth and distance of two convex polyhedra in any position: exact up to round-off, by separating axes and by distances
/// between features. Shares no code with the contact of the kernels, so that it can check their results.
namespace voussoir::geometry {

/// The points x with normal · x <= offset [m]. The unit normal points outward.
struct HalfSpace {
  Vec3 normal;
  double offset = 0.0;
};

/// A convex polyhedron with its edges and face planes, as separating axes need them. In global axes once placed.
struct ConvexBody {
  std::vector<Vec3> vertices;  // m
  std::vector<HalfSpace> faces;
  std::vector<std::array<std::int32_t, 2>> edges;  // vertex indices of both ends, each edge once
  std::vector<Vec3> directions;                    // unit directions of the edges, parallel ones once
};

/// Body from vertices [m] and the planes of all faces: edges are where two faces meet.
/// \pre convex and closed; vertices lie on their faces to 1e-7 of the size
ConvexBody convex_body(std::vector<Vec3> vertices, std::vector<HalfSpace> faces);
/// \pre the polyhedron is valid
ConvexBody convex_body(const Polyhedron& p);

/// Turns a body about the origin, then moves it by `by` [m]. \param out  overwritten; no allocation where it held as large a body before
void place(const ConvexBody& body, const Mat3& rotation, Vec3 by, ConvexBody& out);
ConvexBody placed(const ConvexBody& body, const Mat3& rotation, Vec3 by);

/// The least translation that separates two bodies.
struct Penetration {
  double depth = 0.0;  // m; 0 or less: the bodies are apart by at least −depth
  Vec3 axis;           // unit; moving the second body by `depth` along it separates the bodies
};

/// Penetration over the face normals of both bodies and the cross products of their edges. \param enough  m; the search stops at the first
/// axis with a depth of at most this, and returns that depth, which need not be the least
Penetration penetration_of(const ConvexBody& a, const ConvexBody& b, double enough = -std::numeric_limits<double>::infinity());

/// Distance between the nearest points of two bodies [m]; 0 if they touch or overlap.
double distance(const ConvexBody& a, const ConvexBody& b);

/// Depth of the lowest vertex under the plane z = `height` [m]; negative: height above the plane.
double depth_under(const ConvexBody& a, double height);

}  // namespace voussoir::geometry
