// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/nth.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

class Hdf5File;

/// Opening time of each joint of a run [s]: when the springs of half of its area are broken; infinity: never.
/// \param run  with its joints and cracks \throw FileError
std::vector<double> joint_opening_times(const Hdf5File& run);

/// A joint that opens, and the two points that initially coincided in its middle.
struct OpenJoint {
  std::size_t row = 0;        // row of /model/joint
  double time = 0;            // s, of opening
  std::int32_t a = 0, b = 0;  // elements; b = −1: the base
  Vec3 centre;                // m, in the reference configuration
  Vec3 from_a, from_b;        // m, of the centre from the elements' centroids; for the base, from the origin

  /// Vector from the point of a to that of b [m].
  [[nodiscard]] Vec3 apart(const std::vector<Pose>& poses) const {
    const Vec3 at_b = b < 0 ? from_b : nth(poses, b).point(from_b);
    return at_b - nth(poses, a).point(from_a);
  }
  /// Width of the crack (io/MEASURES.md) [m].
  [[nodiscard]] double width(const std::vector<Pose>& poses) const { return norm(apart(poses)); }
};

/// Joints of a run that open, by row. \param start  poses of the elements in the reference configuration \throw FileError
std::vector<OpenJoint> open_joints(const Hdf5File& run, const std::vector<Pose>& start);

}  // namespace voussoir::io
