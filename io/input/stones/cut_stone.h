// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyhedron.h"
#include "geometry/solids/mesh.h"

namespace voussoir::io {

struct CutStone {
  std::vector<geometry::Polyhedron> pieces;  // convex, in prism order
  double dents = 0.0;                        // m: what is shallower was left out or filled; 0: nothing was
};

/// A stone as convex pieces, itself if it is convex. Cuts go through corners within `snap` [m] (geometry::convex_pieces) or, where these
/// leave slivers, do not. If neither does, dents and slivers are passed over, at first those below 3e-9 of the size, at most below 3e-6:
/// faces that were meant to be plane, or to meet in a corner, do not because coordinates were rounded. \throw ModelError
CutStone cut_stone(const geometry::Mesh& mesh, double snap);

}  // namespace voussoir::io
