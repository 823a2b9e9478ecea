// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/limit/limit.h"

// Dry walls of any plan ([[wall]]) under limit analysis.
namespace voussoir::testing {
namespace {

constexpr double kThickness = 0.3, kHeight = 1.5;

/// A dry wall along these points, turned about the origin.
cases::Case dry_wall(const std::vector<std::array<double, 2>>& points, double degrees, std::optional<cases::CellCounts> cells = {}) {
  cases::Case c;
  c.materials["stone"] = {2000.0, 5e9, 0.2};
  c.contact.friction = 35.0;
  c.segment_rule = geometry::SegmentRule::rim;
  c.base = cases::Base{};
  cases::WallSpec w;
  const double a = degrees * std::numbers::pi / 180.0;
  for (const auto& [x, y] : points) w.points.push_back({x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a)});
  w.name = "w", w.thickness = kThickness, w.height = kHeight, w.brick = {0.5, 0.3, 0.25}, w.bond = cases::WallBond::through;
  w.material = "stone";
  w.cells = cells;
  if (cells)
    c.joint_laws["brick"] = {.tension = 1e6, .cohesion = 2e6, .friction = 40.0, .compression = 1e7}, c.materials["stone"].inside = "brick";
  c.walls = {w};
  return c;
}

/// The multiplier of the weight, along a direction that turns with the wall.
double multiplier(const std::vector<std::array<double, 2>>& points, double degrees, double toward,
                  std::optional<cases::CellCounts> cells = {}) {
  const cases::Case c = dry_wall(points, degrees, cells);
  const double a = (degrees + toward) * std::numbers::pi / 180.0;
  solver::LimitOptions o;
  o.live.direction = {std::cos(a), std::sin(a), 0.0};
  const solver::LimitResult r = solver::limit_analysis(c, cases::build_model(c), o);
  CHECK(r.associated.proof.holds);
  return r.associated.multiplier;
}

}  // namespace

TEST_SUITE_BEGIN("limit analysis" * doctest::skip(!solver::has_linear_programmes()));

TEST_CASE("a free dry wall overturns at its slope, wherever it runs") {
  for (const double degrees : {0.0, 37.0, 90.0, 211.0}) {
    CAPTURE(degrees);
    CHECK(multiplier({{0.0, 0.0}, {3.0, 0.0}}, degrees, 90.0) == doctest::Approx(kThickness / kHeight).epsilon(1e-8));
  }
}

TEST_CASE("a wall whose bricks are in cells bears what it bears with whole bricks") {
  const std::vector<std::array<double, 2>> line{{0.0, 0.0}, {2.0, 0.0}};
  for (const double toward : {90.0, 0.0}) {  // over its face; along it, where stairs of bricks slide and turn
    CAPTURE(toward);
    CHECK(multiplier(line, 0.0, toward, cases::CellCounts{2, 1, 2}) == doctest::Approx(multiplier(line, 0.0, toward)).epsilon(2e-6));
  }
}

TEST_CASE("a wall that turns a corner bears more than a straight one, the same wherever it stands") {
  const std::vector<std::array<double, 2>> corner{{0.0, 0.0}, {1.6, 0.0}, {2.3, 1.2}};
  for (const double toward : {90.0, -90.0}) {
    const double here = multiplier(corner, 0.0, toward);
    CHECK(here > 1.5 * kThickness / kHeight);
    for (const double degrees : {90.0, 180.0}) CHECK(multiplier(corner, degrees, toward) == doctest::Approx(here).epsilon(1e-7));
  }
}

TEST_SUITE_END();

}  // namespace voussoir::testing
