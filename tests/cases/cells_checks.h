// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <map>

#include "cases/model.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/walls/plan_walls.h"

/// What holds of units in cells.
namespace voussoir::testing {

inline int product(const cases::CellCounts& n) { return n[0] * n[1] * n[2]; }

/// Faces between the cells of a unit, by counting.
inline int joints_in(const cases::CellCounts& n) { return (n[0] - 1) * n[1] * n[2] + n[0] * (n[1] - 1) * n[2] + n[0] * n[1] * (n[2] - 1); }

struct OfUnit {
  int cells = 0, joints = 0;
  double volume = 0.0, area = 0.0;  // m3; m2, of the joints
  Vec3 centroid;
  Mat3 inertia = Mat3::zero();  // about the centroid, for unit density
};

inline Mat3 point_inertia(double volume, Vec3 r) {
  const double square = dot(r, r);
  return volume * (Mat3::diagonal(square, square, square) - outer(r, r));
}

inline double size_of(const Mat3& m) { return std::sqrt(dot(m.r0, m.r0) + dot(m.r1, m.r1) + dot(m.r2, m.r2)); }

inline std::map<std::int32_t, OfUnit> units_of(const cases::Model& m) {
  std::map<std::int32_t, OfUnit> units;
  for (std::size_t e = 0; e < m.blocks.size(); ++e) {
    if (m.blocks[e].unit < 0) continue;
    OfUnit& u = units[m.blocks[e].unit];
    const geometry::MassProperties& mass = m.assembly.elements[e].mass;
    ++u.cells, u.volume += mass.volume, u.centroid += mass.volume * mass.centroid;
  }
  for (auto& [number, u] : units) u.centroid = u.centroid / u.volume;
  for (std::size_t e = 0; e < m.blocks.size(); ++e) {
    if (m.blocks[e].unit < 0) continue;
    OfUnit& u = units[m.blocks[e].unit];
    const geometry::MassProperties& mass = m.assembly.elements[e].mass;
    u.inertia = u.inertia + mass.inertia + point_inertia(mass.volume, mass.centroid - u.centroid);
  }
  for (const geometry::Joint& j : m.assembly.joints) {
    if (j.element_b == geometry::kBase) continue;
    const std::int32_t a = m.blocks[static_cast<std::size_t>(j.element_a)].unit, b = m.blocks[static_cast<std::size_t>(j.element_b)].unit;
    if (a >= 0 && a == b) ++units[a].joints, units[a].area += j.area;
  }
  return units;
}

}  // namespace voussoir::testing
