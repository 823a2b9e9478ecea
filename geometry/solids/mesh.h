// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/polyhedron.h"

/// Polygon meshes as geometry files hold them, before they are known to bound solids.
namespace voussoir::geometry {

/// Polygons over vertices [m]: loops of vertex numbers, counter-clockwise seen from outside. Not necessarily closed or convex.
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::int32_t>> faces;
};

/// Bounding box of all vertices [m], including vertices that no face uses. \pre there is a vertex
Box3 box_of(const Mesh& m);
/// Diagonal of the bounding box [m]. \pre there is a vertex
double diagonal(const Mesh& m);

/// The mean plane of a loop that need not be plane: unit normal of the vector area, through the mean of the corners.
struct LoopPlane {
  Vec3 normal, centre;
  double area = 0.0;  // m2; if 0, the normal is zero
};
LoopPlane loop_plane(const Mesh& m, std::size_t face);

/// Greatest distance of the corners of a face from its mean plane [m].
double warp(const Mesh& m, std::size_t face);

/// Volume by the divergence theorem [m3]; negative: inside out. \pre closed
double volume(const Mesh& m);

/// A copy with vertices nearer than `tolerance` [m] merged into the first of them; repeated corners of a loop, faces of fewer than three
/// corners and vertices that no face uses are removed.
Mesh welded(const Mesh& m, double tolerance);

/// A copy with duplicate faces (equal corners in the same direction of travel) removed but for the first.
Mesh without_doubled_faces(const Mesh& m);

/// Turns faces round so that neighbours agree and the volume is positive. \return how many were turned. Nothing is turned if the mesh is
/// open, or if more than two faces meet at an edge: then which side is outside is not known.
std::size_t turn_outward(Mesh& m);

/// The reason why the mesh bounds no solid, with the place and the remedy: open, faces turned against each other, inside out, no volume.
/// Nothing if the mesh bounds a solid; then every edge is used once in each direction.
std::optional<std::string> fault_of(const Mesh& m);

/// A copy with neighbouring faces of one plane merged into one face: all corners within `tolerance` [m] of the plane of the largest of the
/// faces, and turned by no more than `angle` [rad] from that face. Faces whose union would have a hole stay separate; vertices left on two
/// faces only are removed.
/// \pre fault_of(m) is nothing
Mesh with_merged_faces(const Mesh& m, double tolerance, double angle);

/// Whether no vertex is above the plane of any face by more than `tolerance` [m]. \pre closed
bool is_convex(const Mesh& m, double tolerance);

/// "(1.2, 0, 3.45)", metres, for messages.
std::string place_text(Vec3 v);

}  // namespace voussoir::geometry
