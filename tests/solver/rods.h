// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tests/solver/small_wall.h"

/// Rods on edge: crossed, they meet by their edges alone, where contact points see nothing.
namespace voussoir::testing {

inline constexpr double kHalfDiagonal = 0.0707;  // m

/// A rod of 0.2 m with a square section that stands on an edge, along x or y, its axis through (0, 0, z).
inline cases::BlockSpec rod(bool along_y, double z) {
  cases::BlockSpec b = brick(along_y ? 1 : 0, 0, 0.0, 0.2);
  b.box.reset();
  const double corner[4][2] = {{0.0, -kHalfDiagonal}, {kHalfDiagonal, 0.0}, {0.0, kHalfDiagonal}, {-kHalfDiagonal, 0.0}};
  std::array<Vec3, 8> v{};
  for (std::size_t k = 0; k < 4; ++k) {
    const double across = corner[k][0], up = z + corner[k][1];
    v[k] = along_y ? Vec3{across, 0.1, up} : Vec3{-0.1, across, up};
    v[k + 4] = along_y ? Vec3{across, -0.1, up} : Vec3{0.1, across, up};
  }
  b.vertices.assign(v.begin(), v.end());
  return b;
}

}  // namespace voussoir::testing
