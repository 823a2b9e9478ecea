// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/cases/walls/plan_walls.h"

/// Floors and roofs between walls of [[wall]].
namespace voussoir::testing {

inline cases::WallFloor floor_between(std::string name, std::vector<std::string> walls) {
  cases::WallFloor f;
  f.name = std::move(name), f.walls = std::move(walls), f.material = "wood";
  f.beams.beam = {0.1, 0.2}, f.beams.spacing = 0.6, f.beams.bearing = 0.2, f.beams.element = 0.4;
  return f;
}

inline cases::WallRoof roof_between(std::string name, std::vector<std::string> walls, std::vector<std::string> gables) {
  cases::WallRoof r;
  r.name = std::move(name), r.walls = std::move(walls), r.gables = std::move(gables), r.material = "wood";
  r.rafters.beam = {0.1, 0.16}, r.rafters.between_beams = "wood";
  return r;
}

/// The case turned about z and moved, mirrored at x = 0 before.
inline cases::Case moved(cases::Case c, double angle, bool mirror) {
  const auto place = [&](std::array<double, 2>& p, double by) {
    const double x = mirror ? -p[0] : p[0], y = p[1];
    p = {std::cos(angle) * x - std::sin(angle) * y + 3.0 * by, std::sin(angle) * x + std::cos(angle) * y - 7.0 * by};
  };
  for (cases::WallSpec& w : c.walls) {
    for (auto& p : w.points) place(p, 1.0);
    if (mirror && w.line != cases::WallLine::middle) w.line = w.line == cases::WallLine::left ? cases::WallLine::right : cases::WallLine::left;
  }
  for (cases::WallFloor& f : c.floors) {
    for (auto& p : f.corners) place(p, 1.0);
    if (f.direction) place(*f.direction, 0.0);
  }
  for (cases::WallRoof& r : c.roofs) {
    for (auto& p : r.corners) place(p, 1.0);
  }
  for (cases::WallVault& v : c.vaults) {
    for (auto& p : v.corners) place(p, 1.0);
  }
  return c;
}

/// Two models have the same elements, joints and ties, wherever they stand.
inline void check_same(const cases::Model& a, const cases::Model& b) {
  const auto volumes = [](const cases::Model& m) {
    std::vector<double> all;
    for (const geometry::Element& e : m.assembly.elements) all.push_back(e.mass.volume);
    std::ranges::sort(all);
    return all;
  };
  const std::vector<double> one = volumes(a), other = volumes(b);
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i] == doctest::Approx(other[i]).epsilon(1e-6));
  CHECK(a.assembly.joints.size() == b.assembly.joints.size());
  REQUIRE(a.tie_bill.size() == b.tie_bill.size());
  for (std::size_t i = 0; i < a.tie_bill.size(); ++i) {
    CHECK(a.tie_bill[i].ties == b.tie_bill[i].ties);
    CHECK(a.tie_bill[i].area == doctest::Approx(b.tie_bill[i].area).epsilon(1e-6));
  }
}

}  // namespace voussoir::testing
