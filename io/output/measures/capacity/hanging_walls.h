// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/measures/building/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// A wall that the ground has left as it sank, in one frame: a gap under it that one can see through (io/MEASURES.md, Settlement).
struct HangingWall {
  static constexpr double kGap = 1e-3;  // m: a narrower one is a crack

  std::string wall;
  double length = 0;           // m, along the wall, of all gaps; what lies one above the other counts once
  double from = 0, to = 0;     // m, of the whole, from the left end of the wall as seen from outside
  double gap = 0, height = 0;  // m, the widest, and where it is: Building::height_of
};

/// The walls that hang over some length: bed joints at least kGap open, vertically, below which the masonry or the ground has sunk.
/// \param start, poses  of the elements in the reference configuration, and in the frame \throw FileError
std::vector<HangingWall> hanging_walls(const Hdf5File& run, const Building& building, const std::vector<Pose>& start,
                                       const std::vector<Pose>& poses);

}  // namespace voussoir::io
