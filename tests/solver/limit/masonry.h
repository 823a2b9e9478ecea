// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "cases/case.h"
#include "geometry/polyhedron.h"

/// Small assemblies of dry stones for limit analysis, which can be moved, turned, mirrored and put into another order.
namespace voussoir::testing {

struct DryStone {
  std::string name;
  geometry::Polyhedron shape;
  bool fixed = false;
  bool heavy = false;  // of a second material
};

struct Masonry {
  std::vector<DryStone> stones;
  double friction = 35.0, density = 2000.0, heavy_density = 8000.0;  // degrees, kg/m3

  [[nodiscard]] cases::Case as_case() const {
    cases::Case c;
    c.materials["stone"] = {density, 5e9, 0.2};
    c.materials["heavy"] = {heavy_density, 5e9, 0.2};
    c.contact.friction = friction;
    c.segment_rule = geometry::SegmentRule::rim;
    for (const DryStone& s : stones) {
      cases::StonesSpec set;
      set.file = "none.obj", set.material = s.heavy ? "heavy" : "stone";
      set.stones.push_back({s.name, {}, s.fixed, {{s.shape, {}}}, ""});
      c.stones.push_back(set);
    }
    return c;
  }
  template <class Change>
  [[nodiscard]] Masonry changed(const Change& change) const {
    Masonry out = *this;
    for (DryStone& s : out.stones) s.shape = change(s.shape);
    return out;
  }
  [[nodiscard]] Masonry moved(Vec3 by) const {
    return changed([&](const geometry::Polyhedron& p) { return geometry::moved(p, by); });
  }
  [[nodiscard]] Masonry turned(double degrees) const {
    return changed([&](const geometry::Polyhedron& p) { return geometry::rotated(p, {0, 0, 1}, degrees * std::numbers::pi / 180.0, {}); });
  }
  [[nodiscard]] Masonry mirrored() const {
    return changed([](const geometry::Polyhedron& p) { return geometry::mirrored(p, {1, 0, 0}, {}); });
  }
  [[nodiscard]] Masonry scaled(double by) const {
    return changed([&](geometry::Polyhedron p) {
      for (Vec3& v : p.vertices) v = by * v;
      return p;
    });
  }
  [[nodiscard]] Masonry shuffled(std::mt19937& random) const {
    Masonry out = *this;
    std::ranges::shuffle(out.stones, random);
    return out;
  }
};

/// Voussoirs of equal angle in the x-z plane, 0 to `depth` in y; the first and the last are fixed.
inline Masonry dry_arch(int voussoirs, double inner, double outer, double depth, double from = 0.0) {
  Masonry m;
  for (int k = 0; k < voussoirs; ++k) {
    const auto corner = [&](int end, double radius, double y) {
      const double angle = (from + (180.0 - 2.0 * from) * (k + end) / voussoirs) * std::numbers::pi / 180.0;
      return Vec3{radius * std::cos(angle), y, radius * std::sin(angle)};
    };
    const std::array<Vec3, 8> corners{corner(1, inner, 0), corner(0, inner, 0), corner(0, inner, depth), corner(1, inner, depth),
                                      corner(1, outer, 0), corner(0, outer, 0), corner(0, outer, depth), corner(1, outer, depth)};
    m.stones.push_back({"v" + std::to_string(k), geometry::make_hexahedron(corners), k == 0 || k == voussoirs - 1});
  }
  return m;
}

/// Courses of `stones` stones in running bond on a fixed footing, under a heavy beam.
inline Masonry dry_wall(int courses, int stones, double heavy_density) {
  constexpr double kLength = 0.2, kHeight = 0.15, kDepth = 0.2;
  Masonry m;
  m.density = 2600.0, m.heavy_density = heavy_density, m.friction = 31.7989;
  m.stones.push_back({"footing", geometry::make_box({0, 0, -0.2}, {kLength * stones, kDepth, 0}), true});
  for (int course = 0; course < courses; ++course) {
    const double z = kHeight * course, end = kLength * stones;
    const double first = course % 2 == 0 ? kLength : 0.5 * kLength;
    for (double x0 = 0.0, x1 = first; x0 < end - 1e-9; x0 = x1, x1 = std::min(end, x1 + kLength))
      m.stones.push_back({"c" + std::to_string(course) + "_" + std::to_string(m.stones.size()),
                          geometry::make_box({x0, 0, z}, {x1, kDepth, z + kHeight})});
  }
  const double top = kHeight * courses;
  m.stones.push_back({"beam", geometry::make_box({0, 0, top}, {kLength * stones, kDepth, top + 0.25}), false, true});
  return m;
}

}  // namespace voussoir::testing
