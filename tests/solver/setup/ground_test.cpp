// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "solver/analysis/modes.h"
#include "solver/run/run.h"
#include "solver/setup/setup.h"
#include "tests/cases/paper_house.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;

// Parts of the base (cases/solids/ground.h) are the base at another height, and may move.
namespace {

constexpr double kLevel = 0.6;  // m

/// Two cubes of adobe, one upon the other, that stand at a height.
cases::Case cubes(double z) {
  cases::Case c = testing::paper_materials();
  c.base = cases::Base{};
  c.joints.default_law = "normal";
  for (int i = 0; i < 2; ++i) {
    cases::BlockSpec block;
    block.name = "cube " + std::to_string(i), block.material = "adobe";
    block.box = {Vec3{0.0, 0.0, z + 0.2 * i}, Vec3{0.2, 0.2, z + 0.2 * (i + 1)}};
    c.blocks.push_back(block);
  }
  return c;
}

cases::Case on_part(Vec3 velocity) {
  cases::Case c = cubes(kLevel);
  cases::BasePart& part = c.base->parts.emplace_back();
  part.x = {-0.5, 0.7}, part.y = {-0.3, 0.9}, part.level = kLevel;
  if (norm(velocity) > 0.0) part.motion.emplace().velocity = velocity;
  return c;
}

std::vector<solver::Mode> modes_of(const cases::Case& c) {
  const cases::Model model = cases::build_model(c);
  return solver::natural_modes(*solver::build_world(c, model, {}), 11, solver::DryJoints::open);
}

}  // namespace

TEST_CASE("joints with a part of the base are those with the base: mortar, stiffness, one side") {
  const std::vector<solver::Mode> base = modes_of(cubes(0.0)), part = modes_of(on_part({}));
  REQUIRE(base.size() == part.size());
  for (std::size_t i = 0; i < base.size(); ++i) CHECK(part[i].frequency == doctest::Approx(base[i].frequency).epsilon(1e-9));
}

TEST_CASE("what stands on a part of the base that sinks goes with it") {
  cases::Case c = on_part({0.0, 0.0, -0.01});
  c.gravity.settle = true;
  c.damping.alpha = 20.0;
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  const auto& e = sim.world().elements;
  for (int i = 0; sim.time() < 0.0 && i < 200000; ++i) sim.step({});
  sim.start_shaking();
  const auto height = [&] { return e.uz[1]; };
  const double from = height();
  while (sim.time() < 0.5) sim.step({});
  CHECK(height() - from == doctest::Approx(-0.005).epsilon(0.05));
  CHECK(e.bonds[0] > 0);
}
