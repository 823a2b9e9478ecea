// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/solids/mesh.h"

namespace voussoir::geometry {

/// Triangulation of a face, convex or not, by ear clipping; the triangles keep the orientation of the face.
std::vector<std::array<Vec3, 3>> triangles_of(const Mesh& m, std::size_t face);

/// A copy with faces warped by more than `most` [m] triangulated, shortest diagonals first, so that two faces over the same corners (within
/// `most`) are triangulated alike, whichever way they face. \param parted  increased by the number of such faces
Mesh with_parted_faces(const Mesh& m, double most, std::size_t& parted);

/// Winding number of a point: 1 inside a closed mesh, 0 outside; the solid angle of the mesh seen from the point, over 4π.
double winding_number(const Mesh& m, Vec3 point);

}  // namespace voussoir::geometry
