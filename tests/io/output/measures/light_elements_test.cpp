// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/light_elements.h"

#include <doctest/doctest.h>

#include "solver/run/simulation.h"
#include "tests/solver/small_wall.h"

// Elements that are too light for the tolerance of states of rest.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// Of a wall of 3 × 4 bricks with a cube of this edge [m] on it.
std::string warning(double edge, double tolerance, cases::Solver solver = cases::Solver::equilibrium, double gravity = 9.8) {
  cases::Case c = small_wall(3, 4);
  cases::BlockSpec pebble = brick(4, 0, 0.0, edge);
  pebble.name = "pebble";
  pebble.box = {{Vec3{0.1, 0.03, 0.4}, Vec3{0.1 + edge, 0.03 + edge, 0.4 + edge}}};
  c.blocks.push_back(pebble);
  c.gravity.acceleration = {0.0, 0.0, -gravity};
  c.analysis.kind = cases::AnalysisKind::pushover, c.analysis.solver = solver, c.analysis.tolerance = tolerance;
  if (gravity == 0.0) {  // rest is measured by the load then
    c.analysis.pattern = cases::LoadPattern::given;
    cases::Load load;
    load.block = "c3_1", load.force = {100.0, 0.0, 0.0}, load.grows = true;
    c.loads.push_back(load);
  }
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion none;
  return io::light_elements_warning(solver::Simulation(c, m, none, {}).world(), c);
}

}  // namespace

TEST_CASE("light elements: those whose fall would pass for a state of rest are named, with the tolerance that shows it") {
  const std::string text = warning(0.005, 1e-4);  // 1.25e-7 m3 of a mean of 1.7e-3 m3
  CHECK(text.starts_with("analysis.tolerance = 0.0001: 1 element weighs less than this share of the mean weight"));
  INFO(text);
  CHECK(text.find("block \"pebble\" (element 14), has 7.8e-05 of the mean: 8e-07 would show it within 1 %") != std::string::npos);
  CHECK(warning(0.005, 8e-7).empty());
  CHECK(warning(0.05, 1e-4).empty());
  CHECK(warning(0.005, 1e-4, cases::Solver::dynamics).empty());
  CHECK(warning(0.005, 1e-4, cases::Solver::equilibrium, 0.0).empty());
}
