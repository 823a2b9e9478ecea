// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace voussoir::solver {

/// The shear limit at a contact point, |T| <= N tan φ, linearised for linear programmes: T lies in a polygon of `corners` times N tan φ.
class FrictionCone {
 public:
  /// A polygon of `facets` corners, one of them along the first axis, inscribed in the circle or (outer) circumscribed.
  FrictionCone(int facets, bool outer);
  /// Shears along the first axis only, where the limit is exact.
  static FrictionCone in_plane();

  [[nodiscard]] const std::vector<geometry::Point2>& corners() const noexcept { return corners_; }
  /// Greatest relative error of the friction by the polygon, too low (inscribed) or too high (circumscribed).
  [[nodiscard]] double error() const noexcept { return error_; }
  /// Factor by which the polygon must grow to contain this shear; <= 1: the polygon contains it.
  [[nodiscard]] double gauge(geometry::Point2 shear) const noexcept;
  /// Largest scalar product of a shear in the polygon and this slip.
  [[nodiscard]] double support(geometry::Point2 slip) const noexcept;

 private:
  FrictionCone() = default;
  std::vector<geometry::Point2> corners_;
  double error_ = 0.0;
  bool plane_ = false;
};

}  // namespace voussoir::solver
