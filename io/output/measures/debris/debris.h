// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "io/output/measures/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// How far what has fallen is scattered.
struct Debris {
  /// How far beyond the building's footprint it lies: the largest horizontal distance of a fallen element's centroid, and the distance
  /// within which 95 % of the fallen mass lies, m; 0 if nothing has fallen or all of it inside. The footprint is the rectangle along x and
  /// y about the houses in the reference configuration (without a house: about all elements that are not fixed).
  double reach = 0, reach_95 = 0;
  /// Seen from above: cells of 0.05 m whose centres lie under or in fallen elements, m2.
  double area = 0;
};

/// \param fallen  1 for each element that has
Debris debris_of(const Building& building, const ElementShapes& shapes, const std::vector<Pose>& poses,
                 const std::vector<std::uint8_t>& fallen);

}  // namespace voussoir::io
