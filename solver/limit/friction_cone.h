// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace voussoir::solver {

/// The limit of shear at a contact point, |T| <= N tan φ, as linear programmes see it: T lies in a polygon of `corners` times N tan φ.
class FrictionCone {
 public:
  /// A polygon of `facets` corners, one of them along the first axis, in the circle, or (outer) round it.
  FrictionCone(int facets, bool outer);
  /// Shears along the first axis alone: the circle itself.
  static FrictionCone in_plane();

  [[nodiscard]] const std::vector<geometry::Point2>& corners() const noexcept { return corners_; }
  /// By how much the polygon takes friction too low (in the circle) or too high, at most: a ratio.
  [[nodiscard]] double error() const noexcept { return error_; }
  /// The factor by which the polygon must grow to hold this shear; <= 1: it holds it.
  [[nodiscard]] double gauge(geometry::Point2 shear) const noexcept;
  /// The largest product of a shear of the polygon with this slip.
  [[nodiscard]] double support(geometry::Point2 slip) const noexcept;

 private:
  FrictionCone() = default;
  std::vector<geometry::Point2> corners_;
  double error_ = 0.0;
  bool plane_ = false;
};

}  // namespace voussoir::solver
