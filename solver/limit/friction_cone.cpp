// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/friction_cone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace voussoir::solver {

using geometry::Point2;

FrictionCone::FrictionCone(int facets, bool outer) {
  const double half = std::numbers::pi / facets, reach = outer ? 1.0 / std::cos(half) : 1.0;
  for (int k = 0; k < facets; ++k) {
    const double angle = 2.0 * half * k + (outer ? half : 0.0);
    corners_.push_back({reach * std::cos(angle), reach * std::sin(angle)});
  }
  error_ = outer ? reach - 1.0 : 1.0 - std::cos(half);
}

FrictionCone FrictionCone::in_plane() {
  FrictionCone cone;
  cone.corners_ = {{1.0, 0.0}, {-1.0, 0.0}};
  cone.plane_ = true;
  return cone;
}

double FrictionCone::gauge(Point2 shear) const noexcept {
  if (plane_) return std::hypot(shear.s, shear.t);
  double most = 0.0;
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Point2 a = corners_[k], b = corners_[(k + 1) % corners_.size()];
    const Point2 middle{0.5 * (a.s + b.s), 0.5 * (a.t + b.t)};  // of an edge, whose normal it is
    most = std::max(most, (middle.s * shear.s + middle.t * shear.t) / (middle.s * middle.s + middle.t * middle.t));
  }
  return most;
}

double FrictionCone::support(Point2 slip) const noexcept {
  if (plane_) return std::hypot(slip.s, slip.t);
  double most = 0.0;
  for (const Point2 c : corners_) most = std::max(most, c.s * slip.s + c.t * slip.t);
  return most;
}

}  // namespace voussoir::solver
