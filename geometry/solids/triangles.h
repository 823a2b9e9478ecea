// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/solids/mesh.h"

namespace voussoir::geometry {

/// A face, convex or not, as triangles of the same orientation (ears are cut off).
std::vector<std::array<Vec3, 3>> triangles_of(const Mesh& m, std::size_t face);

/// Faces warped by more than `most` [m] as triangles, shortest diagonals first, so that two faces over the same corners (within `most`) are
/// parted alike, from whichever side they are seen. \param parted  how many they were
Mesh with_parted_faces(const Mesh& m, double most, std::size_t& parted);

/// 1 inside a closed mesh, 0 outside: its solid angle seen from the point over 4π.
double winding_number(const Mesh& m, Vec3 point);

}  // namespace voussoir::geometry
