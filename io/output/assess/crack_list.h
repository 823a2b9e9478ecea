// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/output/assess/wall_cracks.h"

/// Cracks of a run: open joints of a wall that hang together, with place, length and width (io/MEASURES.md). The source of the crack table
/// of `voussoir assess`, of that of the page, and of the numbers on crack maps.
namespace voussoir::io {

struct Crack {
  std::int32_t wall = 0;               // index into Building::walls
  std::vector<std::size_t> joints;     // rows of /model/joint
  std::array<double, 2> along{}, z{};  // m: from the left end of the wall, as seen from outside; Building::height_of: least and largest
  double length = 0;                   // m, of all its branches, on that face of the wall on which they are longer
  double width = 0;                    // m, of its widest joint at the assessed frame
  Vec3 widest;                         // m, middle of that joint, in the reference configuration
  double peak = 0, peak_time = 0;      // m, s: largest width of any of its joints in any frame
  double at_end = 0;                   // m, in the last frame

  /// From end to end in the plane of the wall: the diagonal of the box about it [m].
  [[nodiscard]] double extent() const noexcept { return std::hypot(along[1] - along[0], z[1] - z[0]); }
};

/// Cracks at one time, the widest first; of equal ones the longer. Joints of elements that have fallen are left out. A
/// joint between two walls is in a crack of one of them: where it is seen as a line, else of the first.
/// \param joints  of the whole run at this time (joint_widths) \param fallen  by element, 1: fallen \throw FileError
std::vector<Crack> cracks_of(const Hdf5File& run, const Building& building, const std::vector<JointWidth>& joints,
                             const std::vector<std::uint8_t>& fallen);

/// Width [m] of each crack in each frame: of its widest joint that is open by then. Frame by frame. \throw FileError
std::vector<std::vector<double>> widths_over_time(const Hdf5File& run, const FrameReader& frames, const std::vector<Crack>& cracks);

/// Sets `peak`, `peak_time` and `at_end` of all cracks. \throw FileError
void follow(const Hdf5File& run, const FrameReader& frames, std::vector<Crack>& cracks);

}  // namespace voussoir::io
