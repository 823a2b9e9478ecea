// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/solids/stones.h"
#include "geometry/solids/flatten.h"
#include "io/input/stones/raw_stones.h"

/// A stone on its way from a file into the case. Internal to io/input/stones/.
namespace voussoir::io {

/// The state of one stone during import.
struct StoneItem {
  std::size_t table = 0;
  RawStone raw;
  std::size_t nearly_flat = 0;   // faces merged although not exactly in one plane
  std::size_t in_triangles = 0;  // warped faces divided into triangles
  geometry::Mesh drawn = {};     // as read from the file
  int taken_back = 0;            // number of resets to the drawn mesh, see Import::take_back
  std::vector<geometry::Polyhedron> pieces = {};
  double dents = 0.0;       // m, shallower dents were ignored when it was cut into pieces
  double parted = 0.0;      // m, greatest depth of cuts where it overlapped other stones
  std::string fitted = {};  // what the fit to planes did to it
};

/// Describes the changes made to a stone. \param law  name of the law between pieces of its material; empty: they never part
std::string change_of(const StoneItem& item, const geometry::Flattened& done, std::size_t pieces, const std::string& law);

}  // namespace voussoir::io
