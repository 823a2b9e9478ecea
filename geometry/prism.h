// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedron.h"

namespace voussoir::geometry {

/// Whether a polyhedron is a prism in the order that Polyhedron promises: all bottom vertices, then all top vertices, corner i below corner
/// i + k; two faces of k corners, and k sides of four. Boxes and hexahedra are prisms over four corners.
bool is_prism(const Polyhedron& p) noexcept;

/// The same polyhedron with vertices and faces in the order of make_hexahedron or make_prism, if it is a prism in any order of vertices and
/// faces (its sides need not be parallel: a voussoir is a prism, too); else as it is. Of several pairs of ends the lowest (by the z of its
/// centroid), then the first, is the bottom; the first vertex of the bottom is the one with the least (z, y, x).
/// \pre closed, outward
Polyhedron in_prism_order(const Polyhedron& p);

}  // namespace voussoir::geometry
