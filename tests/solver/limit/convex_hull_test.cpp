// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/convex_hull.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace voussoir::testing {
namespace {

using geometry::Point2;

std::vector<Point2> placed(std::vector<Point2> points, double angle, Point2 by) {
  for (Point2& p : points) p = {std::cos(angle) * p.s - std::sin(angle) * p.t + by.s, std::sin(angle) * p.s + std::cos(angle) * p.t + by.t};
  return points;
}

}  // namespace

TEST_CASE("convex hull: points on a line give its two ends, however the line is turned or moved") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Point2> line;
    // Upright, but for round-off of the first coordinate, by which points are sorted.
    for (int k = 0; k < 6; ++k) line.push_back({trial % 4 == 0 ? 1e-16 * any(random) : 0.0, 0.1 * k});
    const double angle = trial % 4 == 0 ? 0.0 : 3.2 * any(random),
                 far = trial % 4 == 0 || trial % 3 == 0 ? 0.0 : std::pow(10.0, 3.0 * any(random));
    line = placed(line, angle, {far, -far});
    std::ranges::shuffle(line, random);
    const std::vector<std::size_t> ends = solver::hull_corners(line);
    REQUIRE(ends.size() == 2);
    CHECK(std::hypot(line[ends[0]].s - line[ends[1]].s, line[ends[0]].t - line[ends[1]].t) == doctest::Approx(0.5).epsilon(1e-9));
  }
}

TEST_CASE("convex hull: a grid has four corners, counter-clockwise, in any place; what repeats counts once") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Point2> grid;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j) grid.insert(grid.end(), 2, Point2{0.1 * i, 0.2 * j});
    grid = placed(grid, 3.2 * any(random), {100.0 * any(random), 100.0 * any(random)});
    std::ranges::shuffle(grid, random);
    const std::vector<std::size_t> hull = solver::hull_corners(grid);
    REQUIRE(hull.size() == 4);
    double twice_area = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point2 a = grid[hull[k]], b = grid[hull[(k + 1) % 4]], o = grid[hull[0]];
      twice_area += (a.s - o.s) * (b.t - o.t) - (a.t - o.t) * (b.s - o.s);
    }
    CHECK(twice_area == doctest::Approx(2.0 * 0.3 * 0.4).epsilon(1e-9));
  }
}

TEST_CASE("convex hull: nothing, one point, two") {
  CHECK(solver::hull_corners({}).empty());
  CHECK(solver::hull_corners({{1, 2}, {1, 2}}).size() == 1);
  CHECK(solver::hull_corners({{1, 2}, {1, 3}, {1, 2}}).size() == 2);
}

}  // namespace voussoir::testing
