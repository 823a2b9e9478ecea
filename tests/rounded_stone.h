// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/polyhedron.h"

/// A stone of many faces.
namespace voussoir::testing {

/// Rings of faces about an axis, as on a sphere: rings × sides faces.
inline geometry::Polyhedron rounded_stone(int rings, int sides, double radius) {
  geometry::Polyhedron p;
  constexpr double pi = std::numbers::pi;
  const auto at = [&](int ring, int side) { return static_cast<std::int32_t>(1 + (ring - 1) * sides + side % sides); };
  p.vertices.push_back({0.0, 0.0, -radius});
  for (int r = 1; r < rings; ++r) {
    for (int s = 0; s < sides; ++s) {
      const double up = -std::cos(pi * r / rings), out = std::sin(pi * r / rings), angle = 2.0 * pi * s / sides;
      p.vertices.push_back(radius * Vec3{out * std::cos(angle), out * std::sin(angle), up});
    }
  }
  const auto top = static_cast<std::int32_t>(p.vertices.size());
  p.vertices.push_back({0.0, 0.0, radius});
  for (int s = 0; s < sides; ++s) {
    p.faces.push_back({0, at(1, s + 1), at(1, s)});
    for (int r = 1; r + 1 < rings; ++r) p.faces.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
    p.faces.push_back({at(rings - 1, s), at(rings - 1, s + 1), top});
  }
  return p;
}

}  // namespace voussoir::testing
