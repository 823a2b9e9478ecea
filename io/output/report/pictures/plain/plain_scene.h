// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/vec3.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/joint_cracks.h"
#include "io/output/replay/placed_elements.h"
#include "io/output/report/pictures/plain/canvas.h"

namespace voussoir::io {

/// A run, or a model that has not been run, as the program itself draws it: elements by material, open joints and broken faces in red,
/// shadows on the ground with a grid of metres. Words, scale, legend and ties are those of the page alone.
class PlainScene {
 public:
  /// \param run  a run.h5, which must outlive the scene; without frames: of a model \param faults  elements in red \throw FileError
  explicit PlainScene(const Hdf5File& run, const std::vector<std::int32_t>& faults = {});

  /// The nearest frame to a time. \param view  one of kViews (stills.h) \param time  s \param width,height  pixels
  [[nodiscard]] Image picture(const std::string& view, double time, int width, int height) const;

 private:
  struct Face {
    std::int32_t element = 0;
    Vec3 normal;                // outward, in the reference configuration
    std::vector<Vec3> corners;  // from the centroid of the element [m]
    double opened = 0.0;        // s, since when it is red
  };
  [[nodiscard]] std::vector<Vec3> placed(const Face& face, const std::vector<Pose>& poses) const;
  [[nodiscard]] std::vector<Vec3> in_view(const std::vector<Pose>& poses) const;
  void read_faces();
  void draw_ground(Canvas& canvas, const std::vector<Pose>& poses) const;
  void draw_cracks(Canvas& canvas, const std::vector<Pose>& poses, std::size_t frame) const;

  const Hdf5File& run_;
  FrameReader frames_;
  JointCracks cracks_;
  std::optional<double> base_;  // m, where there is one
  std::vector<Rgb> colour_;     // by element
  std::vector<Face> faces_;
  Vec3 low_, high_;  // of the model in the reference configuration [m]
};

}  // namespace voussoir::io
