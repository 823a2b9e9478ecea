// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/verification/fixture.h"

/// A semicircular arch of plane-faced voussoirs, in the plane (y, z): what limit analysis needs to know of it, and how to put it in a case.
namespace voussoir::testing {

struct Point {
  double y = 0.0, z = 0.0;  // m
};

/// Area and first moments of a plane figure about y = 0 and z = 0.
struct Lamina {
  double area = 0.0, moment_y = 0.0, moment_z = 0.0;  // m2, m3
};

struct Arch {
  double radius = 1.5, thickness = 0.0;  // m; radius of the centre line
  int voussoirs = 25, points = 4;        // points: segments across the thickness
  bool rim = false;                      // segments.rule

  using Section = std::array<Point, 4>;

  /// From the centre line to the outermost contact points.
  [[nodiscard]] double lever() const { return 0.5 * thickness * (rim ? 1.0 : 1.0 - 1.0 / points); }
  /// A point of joint i at a distance r from the centre; joints 0 and `voussoirs` are the springings, 0 at y > 0.
  [[nodiscard]] Point on_joint(double r, int i) const {
    const double angle = kPi * i / voussoirs;
    return {r * std::cos(angle), i == 0 || i == voussoirs ? 0.0 : r * std::sin(angle)};
  }
  [[nodiscard]] Point inner(int i) const { return on_joint(radius - lever(), i); }
  [[nodiscard]] Point outer(int i) const { return on_joint(radius + lever(), i); }
  /// Corners of voussoir i, which lies between joints i and i + 1.
  [[nodiscard]] Section section(int i) const {
    const double low = radius - 0.5 * thickness, high = radius + 0.5 * thickness;
    return {on_joint(low, i), on_joint(high, i), on_joint(high, i + 1), on_joint(low, i + 1)};
  }
  [[nodiscard]] Lamina lamina(int i) const {
    const Section s = section(i);
    Lamina l;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point a = s[k], b = s[(k + 1) % 4];
      const double c = a.y * b.z - b.y * a.z;
      l.area += 0.5 * c, l.moment_y += (a.y + b.y) * c / 6.0, l.moment_z += (a.z + b.z) * c / 6.0;
    }
    return l;
  }
  /// Gives the blocks of the case, the first of which are the voussoirs, this arch's sections, and its faces their contact points.
  void shape(cases::Case& c) const {
    for (int i = 0; i < voussoirs; ++i) {
      std::vector<std::array<double, 2>>& polygon = c.blocks.at(static_cast<std::size_t>(i)).polygon;
      polygon.clear();
      for (const Point p : section(i)) polygon.push_back({p.y, p.z});
    }
    c.segment_size = thickness / points;
    c.segment_rule = rim ? geometry::SegmentRule::rim : geometry::SegmentRule::centres;
  }
};

}  // namespace voussoir::testing
