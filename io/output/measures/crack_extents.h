// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/output/measures/building/building.h"
#include "io/output/replay/joint_openings.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// Area of a wall's open joints over that of its horizontal section (length times thickness): 1 corresponds to one crack from end to end.
struct CrackExtent {
  double any = 0;    // joints that have opened since time zero, closed again or not
  double fine = 0;   // joints whose faces are at least kFineCrack apart, now
  double large = 0;  // joints whose faces are at least kLargeCrack apart, now
};

/// Extent of cracks in each wall. The width of a crack is the distance, in opening and sliding together, of the two points that initially
/// coincided in the middle of a joint. A joint between two walls counts for both; one with timber on a wall (Building::is_seat) counts for
/// none.
class Cracks {
 public:
  static constexpr double kFineCrack = 1e-3, kLargeCrack = 5e-3;  // m

  /// \param start  poses in the reference configuration \throw FileError
  Cracks(const Hdf5File& run, const Building& building, const std::vector<Pose>& start);

  /// Extents of all walls at one time. \param time  of the poses [s]
  [[nodiscard]] std::vector<CrackExtent> extents(double time, const std::vector<Pose>& poses) const;

  /// Time of the first opening of any of a wall's joints, at or after time zero [s].
  [[nodiscard]] std::optional<double> first_time(std::size_t wall) const;

 private:
  struct CrackedJoint {
    OpenJoint joint;
    double area;                  // m2
    std::int32_t wall_a, wall_b;  // −1: none, or equal to the other
  };
  std::vector<CrackedJoint> joints_;
  std::vector<double> section_;  // m2, by wall
};

}  // namespace voussoir::io
