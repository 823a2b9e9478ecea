// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyhedron.h"
#include "geometry/solids/mesh.h"

namespace voussoir::io {

struct CutStone {
  std::vector<geometry::Polyhedron> pieces;  // convex, in prism order
  double dents = 0.0;                        // m: shallower dents were left out or filled; 0: none
};

/// Cuts a stone into convex pieces; a convex stone is its only piece. Cuts go through corners within `snap` [m] (geometry::convex_pieces)
/// or, where this leaves slivers, do not. If both leave slivers, dents and slivers below 3e-9 of the size, increased up to 3e-6, are
/// ignored: they come from rounded coordinates of faces that should be plane or meet in a corner. \throw ModelError
CutStone cut_stone(const geometry::Mesh& mesh, double snap);

}  // namespace voussoir::io
