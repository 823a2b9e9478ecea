// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/vec3.h"

namespace voussoir::io {

/// From where a picture is seen, in perspective. Its own axes: x to the right, y up, z the distance in front of it [m].
struct Camera {
  Vec3 place;            // m
  Vec3 right, up, back;  // unit vectors
  double focal = 1.0;    // pixels: a length of 1 m at a distance of 1 m
  int width = 0, height = 0;

  /// A point in the camera's own axes.
  [[nodiscard]] Vec3 seen(Vec3 p) const noexcept { return {dot(p - place, right), dot(p - place, up), -dot(p - place, back)}; }
  /// A direction in the camera's own axes.
  [[nodiscard]] Vec3 turned(Vec3 d) const noexcept { return {dot(d, right), dot(d, up), -dot(d, back)}; }
  [[nodiscard]] double column(Vec3 seen) const noexcept { return 0.5 * width + focal * seen.x / seen.z; }
  [[nodiscard]] double row(Vec3 seen) const noexcept { return 0.5 * height - focal * seen.y / seen.z; }
};

/// A camera that has all points just in its picture, as the page's has (scripts/report/src/views.js). \param view  one of kViews (stills.h)
Camera camera_for(const std::string& view, const std::vector<Vec3>& points, int width, int height);

}  // namespace voussoir::io
