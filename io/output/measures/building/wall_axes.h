// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "io/input/files/hdf5_file.h"

/// Boxes of elements along the axes of the wall in which they are.
namespace voussoir::io {

/// A box along some axes [m]; `low` and `high` of x, y, z.
struct Box {
  std::array<double, 3> low, high;

  /// A box that contains nothing.
  static Box empty() noexcept;
  void include(const Box& other) noexcept;
  void include(Vec3 point) noexcept;
  [[nodiscard]] double centre(std::size_t axis) const noexcept { return 0.5 * (low[axis] + high[axis]); }
  [[nodiscard]] double size(std::size_t axis) const noexcept { return high[axis] - low[axis]; }
};

/// Axes of a wall: those of the model, for a wall in another direction turned about z so that x runs along it.
struct WallAxes {
  double cosine = 1.0, sine = 0.0;

  [[nodiscard]] bool turned() const noexcept { return sine != 0.0; }
  /// A vector of the model along these axes.
  [[nodiscard]] Vec3 of(Vec3 v) const noexcept { return turned() ? Vec3{cosine * v.x + sine * v.y, cosine * v.y - sine * v.x, v.z} : v; }
};

/// Vertices of the elements of a run in the reference configuration.
class ElementVertices {
 public:
  ElementVertices() = default;
  /// \throw FileError
  ElementVertices(const Hdf5File& run, std::size_t elements);

  [[nodiscard]] Box box(std::size_t element, const WallAxes& axes = {}) const;
  /// All faces of the run, as in /model/face.
  struct Faces {
    std::vector<double> normal;
    std::vector<std::int32_t> element;
  };
  /// The axes of a straight wall in any direction; nothing for a wall that bends. A wall is straight if half of the upright faces of its
  /// elements or more lie along one direction or across it. \param wall  its elements
  [[nodiscard]] std::optional<WallAxes> axes_along(std::span<const std::size_t> wall, const Faces& faces) const;

 private:
  std::vector<std::size_t> first_;  // vertex of each element, and the end
  std::vector<Vec3> vertex_;        // m
};

}  // namespace voussoir::io
