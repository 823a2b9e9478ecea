// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/separation.h"
#include "geometry/solids/mesh.h"

/// Where a solid is not convex: its reflex edges, and the planes that halve them.
namespace voussoir::geometry {

struct Fold {
  std::int32_t from = 0, to = 0;  // vertices of the edge
  HalfSpace left, right;          // planes of its two faces
  HalfSpace between;              // along the edge, at the same angle to both
  double turn = 0.0;              // rad, between the faces; 0: they lie in one plane
};

/// The plane that a loop lies in, as far as it is plane.
HalfSpace half_space_of(const Mesh& m, std::size_t face);

/// All reflex edges. \pre closed
std::vector<Fold> reflex_folds(const Mesh& m);

/// The plane along which to cut at a fold between its two faces: `between`, or, if a corner lies nearly in that one (by no more than snap,
/// and little of the size), the plane through the edge and the farthest such corner, so that the cut meets the corner and leaves no sliver.
HalfSpace cut_along(const Mesh& m, const Fold& fold, double snap);

}  // namespace voussoir::geometry
