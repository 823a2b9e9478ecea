// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/torsion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/polygon.h"

using namespace voussoir;

namespace {

std::vector<geometry::JointTorsion> torsion_of(const std::vector<geometry::Polyhedron>& shapes, std::optional<double> base) {
  std::vector<geometry::Part> parts;
  parts.reserve(shapes.size());
  for (const geometry::Polyhedron& p : shapes) parts.push_back({.shape = &p, .segment_size = 0.05, .anchored = true});
  return geometry::joint_torsion(geometry::assemble(parts, base));
}

geometry::Polyhedron box(double x0, double x1, double y0, double y1, double z0, double z1) {
  return geometry::make_box({x0, y0, z0}, {x1, y1, z1});
}

}  // namespace

TEST_CASE("constants of torsion of rectangles: those of Timoshenko and Goodier, table of section 109") {
  CHECK(geometry::torsion_constant(1.0, 1.0) == doctest::Approx(0.1406).epsilon(5e-4).scale(0.0));
  CHECK(geometry::torsion_constant(0.1, 0.2) == doctest::Approx(0.229 * 0.2 * 1e-3).epsilon(2e-3).scale(0.0));
  CHECK(geometry::torsion_constant(1.0, 0.1) == doctest::Approx(0.312 * 1e-3).epsilon(2e-3).scale(0.0));
}

TEST_CASE("torsion of joints: a column is a bar, on the base, too") {
  for (const geometry::JointTorsion& j : torsion_of({box(0, 0.4, 0, 0.1, 0, 0.2), box(0, 0.4, 0, 0.1, 0.2, 0.4)}, 0.0)) {
    CHECK(j.solid == doctest::Approx(geometry::torsion_constant(0.4, 0.1)).epsilon(1e-12).scale(0.0));
    CHECK(j.polar == doctest::Approx(0.4 * 0.1 * (0.16 + 0.01) / 12.0).epsilon(1e-12).scale(0.0));
  }
}

TEST_CASE("torsion of joints: inside a plate half of a bar's, at its edge the mean, in the middle of a solid I_p") {
  std::vector<geometry::Polyhedron> plate;
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 3; ++i) plate.push_back(box(0.4 * i, 0.4 * (i + 1), 0.0, 0.1, 0.2 * k, 0.2 * (k + 1)));
  }
  const double bar = geometry::torsion_constant(0.4, 0.1), inside = 0.4 * 1e-3 / 6.0;
  int beds = 0;
  for (const geometry::JointTorsion& j : torsion_of(plate, 0.0)) {
    if (j.polar < 0.4 * 0.1 * 0.16 / 12.0) continue;  // a head joint
    const bool is_inside = j.solid == doctest::Approx(inside).epsilon(1e-9).scale(0.0),
               at_edge = j.solid == doctest::Approx(0.5 * (bar + inside)).epsilon(1e-9).scale(0.0);
    CHECK((is_inside || at_edge));
    beds += is_inside ? 1 : 10;
  }
  CHECK(beds == 2 + 4 * 10);
  std::vector<geometry::Polyhedron> thick = plate;  // a second leaf: no edge of its bed joints' length is free on both sides
  for (const geometry::Polyhedron& p : plate) thick.push_back(geometry::moved(p, {0.0, 0.1, 0.0}));
  int plane = 0;
  for (const geometry::JointTorsion& j : torsion_of(thick, 0.0)) plane += j.solid == j.polar;
  CHECK(plane >= 12);
}

TEST_CASE("torsion of joints: a triangle has Saint-Venant's substitute") {
  const std::vector<std::array<double, 2>> triangle{{0.0, 0.0}, {0.2, 0.0}, {0.0, 0.2}};
  const geometry::Polyhedron prism = geometry::make_prism(triangle, 0.0, 0.1);
  const auto j = torsion_of({prism, geometry::moved(prism, {0.1, 0.0, 0.0})}, std::nullopt);
  REQUIRE(j.size() == 1);
  CHECK(j[0].solid == doctest::Approx(std::pow(0.02, 4) / (40.0 * j[0].polar)).epsilon(1e-9).scale(0.0));
  CHECK(j[0].solid < j[0].polar);
}

TEST_CASE("torsion of joints: columns of any section that nothing touches have Saint-Venant's substitute") {
  const std::vector<std::vector<std::array<double, 2>>> sections{
      {{0.002, 0.445},
       {0.789, 0.094},
       {0.433, 0.762},
       {0.028, 0.836}},                                   // some of it lies beside the lines along the axes through its centre
      {{0.0, 0.0}, {0.3, 0.0}, {0.4, 0.2}, {0.1, 0.2}}};  // as long and as high along these lines as a rectangle of its area
  for (const auto& section : sections) {
    const geometry::Polyhedron prism = geometry::make_prism(section, 0.0, 0.1);
    const auto j = torsion_of({prism, geometry::moved(prism, {0.1, 0.0, 0.0})}, std::nullopt);
    REQUIRE(j.size() == 1);
    geometry::Polygon outline;
    for (const auto& [y, z] : section) outline.push_back({y, z});
    CHECK(j[0].solid == doctest::Approx(std::pow(geometry::region(outline).area, 4) / (40.0 * j[0].polar)).epsilon(1e-9).scale(0.0));
    CHECK(j[0].solid < 0.9 * j[0].polar);
  }
}

TEST_CASE("torsion of joints: beside half of an edge a block leaves it free, wherever both stand") {
  const double bar = geometry::torsion_constant(0.4, 0.1);
  for (int i = 0; i < 25; ++i) {
    const double x = 0.1 * i, y = 0.0173 * i;
    std::vector<geometry::Polyhedron> shapes;
    for (int k = 0; k < 2; ++k) {
      shapes.push_back(box(x, x + 0.4, y, y + 0.1, 0.2 * k, 0.2 * k + 0.2));
      shapes.push_back(box(x + 0.4, x + 0.8, y, y + 0.05, 0.2 * k, 0.2 * k + 0.2));
    }
    const auto j = torsion_of(shapes, 0.0);
    CHECK(std::ranges::count_if(
              j, [&](const geometry::JointTorsion& t) { return t.solid == doctest::Approx(bar).epsilon(1e-9).scale(0.0); }) == 2);
  }
}
