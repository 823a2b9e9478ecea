// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/separation.h"
#include "geometry/solids/mesh.h"

/// Solids that are not convex as convex ones.
namespace voussoir::geometry {

/// What of a convex polyhedron lies in a half-space. Vertices within `tolerance` [m] of its plane count as on it; a polyhedron with none
/// beyond comes back as it is, one with none on this side without faces.
Polyhedron clipped(const Polyhedron& p, const HalfSpace& h, double tolerance);

/// Cuts a solid along its reflex edges (those whose inner angle is above 180°) into convex polyhedra that fill it and do not overlap. A cut
/// goes along one of the two faces of the edge where they turn by 45° or more, else between them; of all the one that takes most reflex
/// edges and cuts fewest faces comes first. A cut between two faces goes through a corner that it would miss by no more than `snap` [m]
/// (cut_along); others that would just miss a corner are avoided. Faces of pieces that a cut has made lie against each other exactly.
/// \param tolerance  of the size: what is no thicker is left out or filled. Above 1e-9 faces of pieces are plane to ten times as much only.
/// \pre fault_of(solid) is nothing, its faces are plane to 1e-9 of its size
/// \throw ModelError if it takes more than 500 pieces, or they do not fill it: its surface goes through itself
std::vector<Polyhedron> convex_pieces(const Mesh& solid, double snap, double tolerance = 1e-9);

}  // namespace voussoir::geometry
