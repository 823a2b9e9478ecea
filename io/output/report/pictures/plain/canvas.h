// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "io/output/report/pictures/plain/camera.h"
#include "io/output/report/pictures/plain/image.h"

namespace voussoir::io {

/// A picture in the making: of all that falls on a pixel, the nearest is seen. Four samples a pixel.
class Canvas {
 public:
  /// \param camera  of the picture
  explicit Canvas(const Camera& camera);

  /// Fills what is seen of a level plane, and gives what is above its horizon `sky`. \param z  height of the plane [m] \param colour  of
  /// its points, by x and y
  void ground(double z, Rgb sky, const std::function<Rgb(double x, double y)>& colour);
  /// Fills all with one colour, infinitely far away.
  void fill(Rgb colour);
  /// Draws a plane convex polygon. What is partly behind the camera is left out. \param corners  in turn [m] \param normal  out of the side
  /// that is seen; none: both sides are \param edges  how dark its edges are, 0 to 1; they fade where it is small
  void polygon(std::span<const Vec3> corners, std::optional<Vec3> normal, Rgb colour, double edges);
  /// Draws a line over what is not nearer than it. \param width  pixels \param strength  0 to 1 \param nearer  how much nearer than it is
  /// [m], so that the faces on which it lies do not hide it
  void line(Vec3 from, Vec3 to, double width, Rgb colour, double strength, double nearer);
  /// The mean of each pixel's samples.
  [[nodiscard]] Image image() const;

 private:
  struct Area;
  /// Blends a colour into a sample, if it is not hidden. \param inverse  1 over its distance [1/m] \param keeps  whether it hides what
  /// comes
  void put(std::size_t sample, float inverse, Rgb colour, double strength, bool keeps);
  void fill_area(const Area& area, const Rgb& colour, double edges);

  Camera camera_;                                  // whose pixels are samples
  std::vector<float> inverse_;                     // of the distance of what is seen, by sample [1/m]
  std::vector<std::array<std::uint8_t, 3>> seen_;  // its colour
};

}  // namespace voussoir::io
