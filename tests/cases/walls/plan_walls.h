// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "geometry/disjoint_sets.h"
#include "tests/cases/house/house_checks.h"
#include "tests/cases/paper_house.h"

/// Cases of [[wall]], and what holds of all of them.
namespace voussoir::testing {

using Points = std::vector<std::array<double, 2>>;

inline cases::WallSpec wall(std::string name, Points points, double thickness, double height,
                            cases::WallBond bond = cases::WallBond::english) {
  cases::WallSpec w;
  w.name = std::move(name), w.points = std::move(points), w.thickness = thickness, w.height = height, w.bond = bond;
  w.brick = {0.4, 0.2, 0.2}, w.material = "adobe";
  return w;
}

inline cases::WallSpec closed(cases::WallSpec w) {
  w.closed = true;
  return w;
}

inline cases::Case case_of(std::vector<cases::WallSpec> walls) {
  cases::Case c = paper_materials();
  c.base = cases::Base{};
  c.walls = std::move(walls);
  return c;
}

inline double volume_of(const cases::Model& m) {
  double sum = 0.0;
  for (const geometry::Element& e : m.assembly.elements) sum += e.mass.volume;
  return sum;
}

/// Every element is joined with the base through others, head joints left out of account: beds carry it, or the joints of an arch, or of
/// a beam.
inline void check_stands(const cases::Model& m) {
  const std::size_t n = m.blocks.size();
  geometry::DisjointSets sets(n + 1);
  for (const geometry::Joint& j : m.assembly.joints) {
    const cases::Block &a = m.blocks[static_cast<std::size_t>(j.element_a)],
                       &b = m.blocks[static_cast<std::size_t>(std::max(0, j.element_b))];
    const bool of_arch = a.kind == cases::PartKind::arch_stone, of_beam = a.member >= 0 && j.element_b >= 0 && a.member == b.member;
    if (std::abs(j.frame().normal.z) < 0.99 && !of_arch && !of_beam) continue;
    sets.join(static_cast<std::size_t>(j.element_a), j.element_b == geometry::kBase ? n : static_cast<std::size_t>(j.element_b));
  }
  std::size_t loose = 0;
  for (std::size_t i = 0; i < n; ++i) loose += sets.same(i, n) ? 0 : 1;
  CHECK(loose == 0);
}

/// Length in plan [m] over which an upright joint goes on in the course above.
inline double joints_that_go_on(const cases::Model& m) {
  struct Line {
    Vec3 normal, from;  // from: a point, at its upper end
    double low, high, top, bottom;
  };
  std::vector<Line> lines;
  for (const geometry::Joint& j : m.assembly.joints) {
    if (j.element_b == geometry::kBase || std::abs(j.frame().normal.z) > 0.01) continue;
    Line l{j.frame().normal, j.centre, 1e9, -1e9, -1e9, 1e9};
    const Vec3 along{-l.normal.y, l.normal.x, 0.0};
    const cases::Block& a = m.blocks[static_cast<std::size_t>(j.element_a)];
    for (const std::int32_t v : a.shape.faces[static_cast<std::size_t>(j.face_a)]) {
      const Vec3 p = a.shape.vertices[static_cast<std::size_t>(v)];
      l.low = std::min(l.low, dot(along, p)), l.high = std::max(l.high, dot(along, p));
      l.top = std::max(l.top, p.z), l.bottom = std::min(l.bottom, p.z);
    }
    lines.push_back(l);
  }
  double sum = 0.0;
  for (const Line& l : lines) {
    for (const Line& u : lines) {
      if (std::abs(u.bottom - l.top) > 1e-6 || std::abs(dot(u.from - l.from, l.normal)) > 0.01 || norm(cross(u.normal, l.normal)) > 0.01)
        continue;
      const bool turned = dot(u.normal, l.normal) < 0.0;
      const double low = turned ? -u.high : u.low, high = turned ? -u.low : u.high;
      sum += std::max(0.0, std::min(l.high, high) - std::max(l.low, low));
    }
  }
  return sum;
}

/// Masonry holds together where its head joints do not: beds join every brick with all others, and no upright joint goes on.
/// \param joints_go_on  between the layers of thick walls in running bond, and where two walls run through a third one in turn
inline void check_bonded(const cases::Model& m, bool joints_go_on = false) {
  geometry::DisjointSets sets(m.blocks.size());
  for (const geometry::Joint& j : m.assembly.joints) {
    if (j.element_b != geometry::kBase && std::abs(j.frame().normal.z) > 0.99)
      sets.join(static_cast<std::size_t>(j.element_a), static_cast<std::size_t>(j.element_b));
  }
  std::size_t parts = 0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) parts += sets.of(i) == i ? 1 : 0;
  CHECK(parts == 1);
  if (!joints_go_on) CHECK(joints_that_go_on(m) < 0.05);
}

inline cases::Model check_sound(const cases::Case& c, double volume, double tolerance = 1e-9) {
  const cases::Model m = cases::build_model(c);
  CHECK(volume_of(m) == doctest::Approx(volume).epsilon(tolerance));
  check_joint_areas(m);
  check_nothing_unjoined(m);
  check_stands(m);
  return m;
}

}  // namespace voussoir::testing
