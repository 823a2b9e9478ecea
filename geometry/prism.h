// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedron.h"

namespace voussoir::geometry {

/// Whether a polyhedron is a prism in the vertex order that Polyhedron promises: all bottom vertices, then all top vertices, corner i below
/// corner i + k; two faces of k corners, and k sides of four. Boxes and hexahedra are prisms over four corners.
bool is_prism(const Polyhedron& p) noexcept;

/// A copy with vertices and faces in the order of make_hexahedron or make_prism, if `p` is a prism in any order of vertices and faces
/// (sides need not be parallel: a voussoir is a prism, too); otherwise `p` unchanged. The bottom is the lowest (by the z of its centroid),
/// then the first, of several possible pairs of ends; its first vertex is the one with the least (z, y, x).
/// \pre closed, faces outward
Polyhedron in_prism_order(const Polyhedron& p);

}  // namespace voussoir::geometry
