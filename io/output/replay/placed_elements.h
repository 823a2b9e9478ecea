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

/// Where an element is: of its centroid, m, and turned from the reference configuration.
struct Pose {
  Vec3 centre;
  Mat3 rotation;

  /// Now, of a material point. \param from_centroid  in the reference configuration [m]
  [[nodiscard]] Vec3 point(Vec3 from_centroid) const noexcept { return centre + rotation * from_centroid; }
};

/// Of all elements in the reference configuration.
std::vector<Pose> first_poses(const FrameReader& frames);
/// Of all elements in a frame. \throw FileError
std::vector<Pose> poses_of(const FrameReader& frames, std::uint64_t frame);

/// Of the spheres about the centroids that hold the elements, m. \throw FileError
std::vector<double> element_radii(const Hdf5File& run, std::size_t elements);

/// What of a vertical line lies in an element, m.
struct Chord {
  double low = 0, high = 0;
};

/// Elements as the half-spaces of their faces, so that vertical lines can be cut with them.
class ElementShapes {
 public:
  /// \param run  its /model/face \throw FileError
  ElementShapes(const Hdf5File& run, std::size_t elements);

  /// The part of the vertical line through (x, y) within an element. \param pose  of this element
  [[nodiscard]] std::optional<Chord> chord(std::size_t element, const Pose& pose, double x, double y) const noexcept;
  /// Of the sphere about the centroid that holds the element, m.
  [[nodiscard]] double radius(std::size_t element) const noexcept { return radius_[element]; }

 private:
  struct HalfSpace {
    Vec3 normal;      // outward, in the reference configuration
    double distance;  // from the centroid, m
  };
  std::vector<HalfSpace> faces_;
  std::vector<std::size_t> first_;  // of an element's faces; one more at the end
  std::vector<double> radius_;
};

}  // namespace voussoir::io
