// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

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

/// A brick by itself over the ground.
cases::Case brick_over(cases::Case ground, Vec3 velocity, double angle) {
  cases::BlockSpec& b = ground.blocks.emplace_back();
  b.name = "brick", b.material = "adobe", b.free = true, b.velocity = velocity;
  b.box = {Vec3{0.0, 0.0, kLevel + 0.1}, Vec3{0.2, 0.1, kLevel + 0.2}};
  b.rotate = cases::Rotation{{1.0, 2.0, 0.5}, angle, {0.1, 0.05, kLevel + 0.15}};
  return ground;
}

cases::Case bare_ground(bool part) {
  cases::Case c = testing::paper_materials();
  c.base = cases::Base{};
  c.joints.default_law = "dry";
  c.gravity.settle = false;
  if (!part) {
    c.base->z = kLevel;
    return c;
  }
  cases::BasePart& p = c.base->parts.emplace_back();
  p.x = {-9.5, 10.7}, p.y = {-10.3, 9.9}, p.level = kLevel;
  return c;
}

/// Centroid of the first block at times from zero on, every 5 ms [m].
std::vector<Vec3> path_of(const cases::Case& c, double end) {
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  const auto& e = sim.world().elements;
  std::vector<Vec3> path;
  sim.start_shaking();
  for (double next = 0.0; sim.time() < end; sim.step({})) {
    if (sim.time() < next) continue;
    path.push_back({e.ux[0], e.uy[0], e.uz[0]});
    next += 5e-3;
  }
  return path;
}

/// The same on a part of the base as on the base itself, to rounding. \return  the lowest that the block goes [m]
double same_path(const cases::Case& on_base, const cases::Case& on_part, double end) {
  const std::vector<Vec3> base = path_of(on_base, end), part = path_of(on_part, end);
  REQUIRE(base.size() == part.size());
  double lowest = 0.0, most = 0.0;
  for (std::size_t i = 0; i < base.size(); ++i) lowest = std::min(lowest, base[i].z), most = std::max(most, norm(part[i] - base[i]));
  CAPTURE(lowest);
  CHECK(most < 1e-7);
  return lowest;
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

TEST_CASE("a brick that falls on a part of the base rebounds as from the base, and goes as deep") {
  const auto falls = [](Vec3 velocity, double angle) {
    return same_path(brick_over(bare_ground(false), velocity, angle), brick_over(bare_ground(true), velocity, angle), 0.12);
  };
  CHECK(falls({0.0, 0.0, -1.0}, 0.0) < -0.09);   // flat: points of a face
  CHECK(falls({0.3, 0.0, -1.0}, 0.0) < -0.09);   // and slides
  CHECK(falls({0.0, 0.0, -3.0}, 40.0) < -0.05);  // on a corner: whole bodies
}

TEST_CASE("what a broken joint with a part of the base becomes is what it becomes on the base") {
  const auto torn = [](bool part) {
    cases::Case c = bare_ground(part);
    c.joints.default_law = "normal";
    cases::BlockSpec& b = c.blocks.emplace_back();
    b.name = "brick", b.material = "adobe", b.velocity = {2.0, 0.0, 0.5};
    b.box = {Vec3{0.0, 0.0, kLevel}, Vec3{0.2, 0.1, kLevel + 0.1}};
    return c;
  };
  const std::vector<Vec3> path = path_of(torn(false), 0.3);
  CHECK(path.back().x > 0.05);  // m: the mortar has failed, and it has slid
  same_path(torn(false), torn(true), 0.3);
}
