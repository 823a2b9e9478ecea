// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/output/measures/building/building.h"
#include "io/output/replay/joint_openings.h"
#include "io/output/replay/placed_elements.h"

/// Slip of beams and rafters on the walls that bear them (io/MEASURES.md).
namespace voussoir::io {

/// Where a beam or rafter lies on a wall, or on the ring beam upon it: all joints with the timber above, whose normal is nearer to the
/// vertical than 60 degrees.
struct Seat {
  std::string timber;      // "roof beam 3"
  std::int32_t wall = -1;  // index into Building::walls; −1: a ring beam
  double area = 0;         // m2, of all its joints

  struct Bed {
    OpenJoint joint;
    Vec3 normal;      // unit, in the reference configuration
    double area = 0;  // m2
  };
  std::vector<Bed> beds;
};

class SeatSlip {
 public:
  /// A slip in one frame. `lost`: half of the seat, by area, is gone: the timber or what bore it has fallen or has moved by more than 1 m.
  struct Slip {
    double metres = 0;
    bool lost = false;
  };

  /// \param start  poses in the reference configuration \throw FileError
  SeatSlip(const Hdf5File& run, const Building& building, const std::vector<std::string>& tags, const std::vector<Pose>& start);

  [[nodiscard]] const std::vector<Seat>& seats() const noexcept { return seats_; }
  /// Slip at each seat: the way along its joints that the points which met in their middles have parted by, the mean by area.
  /// \param fallen  by element, 1: fallen
  [[nodiscard]] std::vector<Slip> at(const std::vector<Pose>& poses, const std::vector<std::uint8_t>& fallen) const;

 private:
  std::vector<Seat> seats_;
};

}  // namespace voussoir::io
