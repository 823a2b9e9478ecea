// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/separation.h"
#include "geometry/solids/mesh.h"

/// Reflex edges of a solid that is not convex, and the planes that bisect them.
namespace voussoir::geometry {

struct Fold {
  std::int32_t from = 0, to = 0;  // vertices of the edge
  HalfSpace left, right;          // planes of the two faces at the edge
  HalfSpace between;              // plane through the edge, at equal angles to both faces
  double turn = 0.0;              // rad, angle between the faces; 0: they are coplanar
};

/// The best-fit plane of a face's loop.
HalfSpace half_space_of(const Mesh& m, std::size_t face);

/// All reflex edges (inner angle above 180°). \pre closed
std::vector<Fold> reflex_folds(const Mesh& m);

/// The plane along which to cut at a fold between its two faces: `between`, or, if a corner lies within `snap` [m] of that plane (and
/// within a small part of the size), the plane through the edge and the farthest such corner, so that the cut meets the corner and leaves
/// no sliver.
HalfSpace cut_along(const Mesh& m, const Fold& fold, double snap);

}  // namespace voussoir::geometry
