// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/solids/mesh.h"

namespace voussoir::geometry {

/// A face, convex or not, as triangles of the same orientation (ears are cut off).
std::vector<std::array<Vec3, 3>> triangles_of(const Mesh& m, std::size_t face);

/// 1 inside a closed mesh, 0 outside: its solid angle seen from the point over 4π.
double winding_number(const Mesh& m, Vec3 point);

}  // namespace voussoir::geometry
