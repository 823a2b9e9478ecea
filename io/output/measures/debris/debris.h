// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "io/output/measures/building/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// Extent of the debris of a collapse.
struct Debris {
  /// Distance of debris beyond the building's footprint [m]: the largest horizontal distance of a fallen element's centroid, and the
  /// distance that contains 95 % of the fallen mass; 0 if nothing has fallen or everything fell inside. The footprint is the rectangle
  /// along x and y around the houses in the reference configuration (without a house: around all elements that are not fixed).
  double reach = 0, reach_95 = 0;
  /// Area in plan [m2]: cells of 0.05 m whose centres lie under or in fallen elements, within 25 m of the centroid of each.
  double area = 0;
};

/// Computes the debris of one frame. \param fallen  by element, 1: fallen
Debris debris_of(const Building& building, const ElementShapes& shapes, const std::vector<Pose>& poses,
                 const std::vector<std::uint8_t>& fallen);

}  // namespace voussoir::io
