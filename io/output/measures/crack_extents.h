// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/output/measures/building.h"
#include "io/output/replay/joint_openings.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// Area of a wall's open joints over that of its horizontal section (length times thickness): 1 is as much as one crack from end to end.
struct CrackExtent {
  double any = 0;    // joints that have come open since time zero, closed again or not
  double fine = 0;   // joints whose faces are kFineCrack apart or more, now
  double large = 0;  // the same with kLargeCrack
};

/// How far cracks go in each wall. A crack's width is the distance, in opening and sliding together, of the two points that met in the
/// middle of a joint. A joint between two walls counts for both; one with timber that lies on a wall (Building::is_seat) counts for none.
class Cracks {
 public:
  static constexpr double kFineCrack = 1e-3, kLargeCrack = 5e-3;  // m

  /// \param start  poses in the reference configuration \throw FileError
  Cracks(const Hdf5File& run, const Building& building, const std::vector<Pose>& start);

  /// One for each wall. \param time  of the poses [s]
  [[nodiscard]] std::vector<CrackExtent> extents(double time, const std::vector<Pose>& poses) const;

  /// When the first of a wall's joints came open, at or after time zero [s].
  [[nodiscard]] std::optional<double> first_time(std::size_t wall) const;

 private:
  struct CrackedJoint {
    OpenJoint joint;
    double area;                  // m2
    std::int32_t wall_a, wall_b;  // −1: none, or the other's
  };
  std::vector<CrackedJoint> joints_;
  std::vector<double> section_;  // m2, of each wall
};

}  // namespace voussoir::io
