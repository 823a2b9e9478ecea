// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/vec3.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/replay/frame_reader.h"

namespace voussoir::io {

/// Pose of an element: centroid [m], and rotation from the reference configuration.
struct Pose {
  Vec3 centre;
  Mat3 rotation;

  /// Current position of a material point [m]. \param from_centroid  in the reference configuration [m]
  [[nodiscard]] Vec3 point(Vec3 from_centroid) const noexcept { return centre + rotation * from_centroid; }
};

/// Poses of all elements in the reference configuration.
std::vector<Pose> first_poses(const FrameReader& frames);
/// Poses of all elements in a frame. \throw FileError
std::vector<Pose> poses_of(const FrameReader& frames, std::uint64_t frame);

/// Radii [m] of the spheres about the centroids that enclose the elements. \throw FileError
std::vector<double> element_radii(const Hdf5File& run, std::size_t elements);

/// The part of a vertical line inside an element [m].
struct Chord {
  double low = 0, high = 0;
};

/// Elements as half-spaces of their faces, for intersection with vertical lines.
class ElementShapes {
 public:
  /// \param run  with its /model/face \throw FileError
  ElementShapes(const Hdf5File& run, std::size_t elements);

  /// The part of the vertical line through (x, y) within an element. \param pose  of the element
  [[nodiscard]] std::optional<Chord> chord(std::size_t element, const Pose& pose, double x, double y) const noexcept;
  /// Radius of the sphere about the centroid that encloses the element [m].
  [[nodiscard]] double radius(std::size_t element) const noexcept { return radius_[element]; }

 private:
  struct HalfSpace {
    Vec3 normal;      // outward, in the reference configuration
    double distance;  // from the centroid, m
  };
  std::vector<HalfSpace> faces_;
  std::vector<std::size_t> first_;  // index of each element's first face; one more entry at the end
  std::vector<double> radius_;
};

}  // namespace voussoir::io
