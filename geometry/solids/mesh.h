// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/polyhedron.h"

/// Surfaces as files of geometry hold them, until they are known to be solids.
namespace voussoir::geometry {

/// Polygons over vertices [m]: loops of vertex numbers, counter-clockwise seen from outside. Neither closed nor convex, unless said so.
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::int32_t>> faces;
};

/// About all vertices, also those that no face uses. \pre there is one
Box3 box_of(const Mesh& m);
/// Of that box, m. \pre there is one
double diagonal(const Mesh& m);

/// The plane of a loop that need not be plane: unit normal of the vector area, through the mean of the corners.
struct LoopPlane {
  Vec3 normal, centre;
  double area = 0.0;  // m2; 0: the normal is none
};
LoopPlane loop_plane(const Mesh& m, std::size_t face);

/// How far corners of a face lie off its plane at most, m.
double warp(const Mesh& m, std::size_t face);

/// By the divergence theorem, m3; negative: inside out. \pre closed
double volume(const Mesh& m);

/// Vertices nearer than `tolerance` [m] as one, the first; corners of a loop that fell together once; without faces of fewer than three
/// corners and without vertices that no face uses.
Mesh welded(const Mesh& m, double tolerance);

/// Faces that stand twice, with the same corners the same way round, once.
Mesh without_doubled_faces(const Mesh& m);

/// Why the mesh bounds no solid, with the place and what to do: open, faces turned against each other, inside out, no volume; nothing if it
/// does bound one. Every edge must then be met once in each direction.
std::optional<std::string> fault_of(const Mesh& m);

/// Neighbouring faces that lie in one plane as one face: all corners within `tolerance` [m] of the plane of the largest of them, and turned
/// by no more than `angle` [rad] from it. Faces whose union would have a hole stay separate; vertices left on two faces only are removed.
/// \pre fault_of(m) is nothing
Mesh with_merged_faces(const Mesh& m, double tolerance, double angle);

/// Whether no vertex lies over the plane of any face by more than `tolerance` [m]. \pre closed
bool is_convex(const Mesh& m, double tolerance);

/// "(1.2, 0, 3.45)", metres, for messages.
std::string place_text(Vec3 v);

}  // namespace voussoir::geometry
