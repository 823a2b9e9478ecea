// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/solids/mesh.h"

/// Random arches and walls whose stones fit exactly, and the same as if drawn without care.
namespace masonry {

using voussoir::Vec3;
using voussoir::geometry::Mesh;

/// The same numbers with every library.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(random_()) / 4294967295.0; }
  int number(int low, int high) { return low + static_cast<int>(between(0.0, high - low + 0.999)); }
  Vec3 vector(double most) {
    const double x = between(-most, most), y = between(-most, most), z = between(-most, most);
    return {x, y, z};
  }

 private:
  std::mt19937 random_;
};

/// A hexahedron of two loops of four corners, the first seen counter-clockwise from outside.
inline Mesh hexahedron(const std::vector<Vec3>& corners) {
  return {corners, {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}};
}

/// Voussoirs of a random circular arch, of unlike lengths.
inline std::vector<Mesh> arch(Numbers& any) {
  const int count = any.number(5, 15);
  const double inner = any.between(1.0, 3.0), outer = inner + any.between(0.2, 0.5), depth = any.between(0.3, 0.8);
  const double from = any.between(0.0, 0.5), to = std::numbers::pi - any.between(0.0, 0.5);
  std::vector<double> joints{0.0};
  for (int i = 0; i < count; ++i) joints.push_back(joints.back() + any.between(0.7, 1.3));
  std::vector<Mesh> out;
  for (int i = 0; i < count; ++i) {
    std::vector<Vec3> corners;
    for (const double y : {0.0, depth}) {
      for (const auto& [r, k] : {std::pair(inner, i), {outer, i}, {outer, i + 1}, {inner, i + 1}}) {
        const double a = from + (to - from) * joints[static_cast<std::size_t>(k)] / joints.back();
        corners.push_back({r * std::cos(a), y, r * std::sin(a)});
      }
    }
    out.push_back(hexahedron(corners));
  }
  return out;
}

/// A wall of random courses in running bond.
inline std::vector<Mesh> wall(Numbers& any) {
  const double length = any.between(1.5, 3.0), depth = any.between(0.2, 0.4);
  std::vector<Mesh> out;
  double z = 0.0;
  for (int course = any.number(3, 6), k = 0; k < course; ++k) {
    const double height = any.between(0.15, 0.3), unit = any.between(0.4, 0.6);
    for (double x = k % 2 == 0 ? 0.0 : -0.5 * unit; x < length - 1e-6; x += unit) {
      const double low = std::max(x, 0.0), high = length - (x + unit) < 0.15 ? length : x + unit;
      const auto box = voussoir::geometry::make_box({low, 0, z}, {high, depth, z + height});
      out.push_back({box.vertices, box.faces});
      if (high == length) break;
    }
    z += height;
  }
  return out;
}

/// Each stone shifted, turned, made larger or smaller, and its corners moved, all by no more than `most` [m] together.
inline std::vector<Mesh> drawn_without_care(std::vector<Mesh> stones, Numbers& any, double most) {
  for (Mesh& m : stones) {
    const Vec3 shift = any.vector(0.25 * most / std::sqrt(3.0)),
               centre = 0.5 * (voussoir::geometry::box_of(m).low + voussoir::geometry::box_of(m).high);
    const double reach = 0.5 * voussoir::geometry::diagonal(m);
    const Vec3 turn = any.vector(0.25 * most / reach / std::sqrt(3.0));
    const double growth = any.between(-0.25, 0.25) * most / reach;
    for (Vec3& v : m.vertices) {
      const Vec3 r = v - centre;
      v += shift + cross(turn, r) + growth * r + any.vector(0.25 * most / std::sqrt(3.0));
    }
  }
  return stones;
}

}  // namespace masonry
