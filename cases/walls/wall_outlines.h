// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/walls/wall_case.h"
#include "geometry/vec3.h"

namespace voussoir::cases {

/// An opening in a straight part of a wall.
struct OutlinedOpening {
  double from = 0.0, to = 0.0;   // m, along the part's middle line from its start
  double low = 0.0, high = 0.0;  // m, above the base
};

/// A straight part of a side of a wall, as a drawing shows it. Points and directions have z = 0.
struct WallOutline {
  std::string name;              // of the side: "outer 2"
  Vec3 from, along, left;        // m, start of its middle line; unit vectors
  double length = 0.0;           // m, of the middle line
  double half = 0.0;             // m, half the thickness
  double foot = 0.0, top = 0.0;  // m, above the base; top without gables
  bool bent = false;             // one of several parts between bends
  double along_line = 1.0;       // lengths along the line of the wall, which the case gives, over those of the middle line
  std::vector<OutlinedOpening> openings;
};

/// All straight parts of all walls. \pre blocks_of_walls() finds no fault
std::vector<WallOutline> wall_outlines(const std::vector<WallSpec>& walls, const WallSpans& spans);

}  // namespace voussoir::cases
