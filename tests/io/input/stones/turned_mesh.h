// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>

#include "geometry/solids/mesh.h"

namespace stones {

/// A mesh turned at random, then moved.
inline voussoir::geometry::Mesh turned(const voussoir::geometry::Mesh& m, std::mt19937& random, voussoir::Vec3 by = {}) {
  using voussoir::Vec3;
  const auto any = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0; };
  const auto vector = [&] {
    const double x = any(), y = any(), z = any();
    return Vec3{x, y, z};
  };
  const Vec3 a = normalised(vector()), other = vector(), b = normalised(other - dot(a, other) * a), c = cross(a, b);
  voussoir::geometry::Mesh out = m;
  for (Vec3& v : out.vertices) v = v.x * a + v.y * b + v.z * c + by;
  return out;
}

/// Its coordinates as a file with so many digits holds them.
inline voussoir::geometry::Mesh rounded(voussoir::geometry::Mesh m, double grain) {
  for (voussoir::Vec3& v : m.vertices)
    v = {grain * std::round(v.x / grain), grain * std::round(v.y / grain), grain * std::round(v.z / grain)};
  return m;
}

}  // namespace stones
