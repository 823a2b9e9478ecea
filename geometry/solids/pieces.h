// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/separation.h"
#include "geometry/solids/mesh.h"

/// Decomposition of solids that are not convex into convex polyhedra.
namespace voussoir::geometry {

/// The part of a convex polyhedron in a half-space. Vertices within `tolerance` [m] of the plane count as on it. A polyhedron with no
/// vertex beyond the plane is returned unchanged; one with no vertex within, without faces.
Polyhedron clipped(const Polyhedron& p, const HalfSpace& h, double tolerance);

/// Cuts a solid along its reflex edges (those whose inner angle is above 180°) into convex polyhedra that fill it and do not overlap. A cut
/// goes along one of the two faces of the edge where they turn by 45° or more, else between them; of all cuts the one that takes most
/// reflex edges and cuts fewest faces comes first. A cut between two faces goes through a corner that it would miss by no more than `snap`
/// [m] (cut_along); other cuts that would just miss a corner are avoided. Faces made by one cut lie against each other exactly.
/// \param tolerance  relative to the size: thinner parts are left out or filled. Above 1e-9 the faces of pieces are plane to ten times the
/// tolerance only.
/// \pre fault_of(solid) is nothing, its faces are plane to 1e-9 of its size
/// \throw ModelError if the solid takes more than 500 pieces, or the pieces do not fill it (its surface intersects itself)
std::vector<Polyhedron> convex_pieces(const Mesh& solid, double snap, double tolerance = 1e-9);

}  // namespace voussoir::geometry
