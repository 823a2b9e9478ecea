// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "geometry/face_loops.h"
#include "geometry/vec3.h"

namespace voussoir::geometry {

/// A fault of the shapes in the input. `subject` is the index of the polyhedron at fault (−1: not known), `other` that of a second one (an
/// overlap) or −1.
class ModelError : public std::runtime_error {
 public:
  ModelError(std::string what, int subject, int other = -1) : std::runtime_error(std::move(what)), subject_(subject), other_(other) {}
  [[nodiscard]] int subject() const noexcept { return subject_; }
  [[nodiscard]] int other() const noexcept { return other_; }

 private:
  int subject_, other_;
};

/// A convex polyhedron: vertices [m] in global axes, faces as loops of vertex indices, counter-clockwise seen from outside.
/// Boxes, hexahedra (VTK vertex order) and prisms (all bottom vertices, then all top vertices) keep that vertex order, so output can write
/// cells.
struct Polyhedron {
  std::vector<Vec3> vertices;
  FaceLoops faces;
};

/// Axis-aligned box; faces in the order −x, +x, −y, +y, −z, +z; vertices in VTK hexahedron order.
/// \throw ModelError if any edge is not positive.
Polyhedron make_box(Vec3 low, Vec3 high);

/// Hexahedron from 8 vertices in VTK order (0-3 bottom counter-clockwise seen from above, 4-7 above them).
/// Same face order as make_box. Not validated: see validate().
Polyhedron make_hexahedron(std::span<const Vec3, 8> vertices);

/// Prism: a convex polygon (3 or more corners, either winding) in the y-z plane extruded from x0 to x1 (x0 < x1).
/// Vertices: the polygon at x0 counter-clockwise seen from +x and from its first corner, then the same corners at x1. Four corners give a
/// hexahedron (faces as in make_hexahedron); other numbers give faces in the order: sides in the order of the polygon's edges, faces at x0
/// and x1.
/// Convexity is left to validate().
///
/// \throw ModelError if the polygon is degenerate or x0 >= x1.
Polyhedron make_prism(std::span<const std::array<double, 2>> polygon_yz, double x0, double x1);

/// Rotates about an axis (any length but zero) through `about` by `angle` [rad] (right-hand rule). Quarter turns are exact.
Polyhedron rotated(const Polyhedron& p, Vec3 axis, double angle, Vec3 about);
Polyhedron moved(const Polyhedron& p, Vec3 by);
/// Mirror image at the plane through `at` with unit normal n. Faces keep their order; loops are reversed so that they stay
/// counter-clockwise seen from outside, and the first and second half of an even number of vertices are exchanged, so that boxes, hexahedra
/// and prisms stay valid cells.
Polyhedron mirrored(const Polyhedron& p, Vec3 n, Vec3 at);

/// Checks that a polyhedron is closed, convex and outward, with plane faces and a volume. Tolerance: 1e-9 of the diagonal of the bounding
/// box, plus the round-off of coordinates far from the origin.
/// \throw ModelError "not convex", "inside out", "a face is not plane", "zero volume", "a vertex is used by no face" ..., with the
/// offending figures in the message, after "block <subject>: " where the subject is known.
void validate(const Polyhedron& p, int subject = -1);

/// Volume [m3], centroid [m], inertia tensor about the centroid for unit density [m5] in global axes, and its
/// principal moments (ascending) with axes as rows (right-handed). For an axis-aligned box the axes are the global ones, exactly.
/// \pre the polyhedron is valid. Digits do not depend on the distance to the global origin.
struct MassProperties {
  double volume = 0.0;
  Vec3 centroid;
  Mat3 inertia;
  Vec3 principal;
  Mat3 axes;
};
MassProperties mass_properties(const Polyhedron& p);

/// Outward unit normal, area [m2] and centroid [m] of a face.
struct FacePlane {
  Vec3 normal;
  double area = 0.0;
  Vec3 centroid;
};
FacePlane face_plane(const Polyhedron& p, int face);

/// The least distance [m] between a face and the vertex farthest behind that face: the shortest edge of a box.
double least_width(const Polyhedron& p);

struct Box3 {
  Vec3 low, high;
};
Box3 bounds(const Polyhedron& p);

}  // namespace voussoir::geometry
