// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "solver/run/simulation.h"
#include "tests/solver/small_wall.h"

// Long elements give way in their joint by more than whole bodies may overlap: the joint bears it, and hands it over when it comes apart.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr double kEdge = 0.4, kLength = 1.0, kPush = 80e3;               // m, m, N
constexpr double kYoung = 9.8e7 / (1.0 - 0.25 * 0.25);                   // Pa
constexpr double kShorter = kPush * kLength / (kYoung * kEdge * kEdge);  // m, of the two halves that a joint lies between

/// A block of 1 m that is pressed onto a fixed one by 80 kN, without gravity.
cases::Case pressed_blocks() {
  cases::Case c = small_wall(1, 2);
  c.base = std::nullopt;
  c.gravity.acceleration = {};
  c.damping.alpha = 60.0;
  c.contact.friction = 0.0;
  c.segment_rule = geometry::SegmentRule::rim;
  c.blocks[0].fixed = true;
  c.blocks.resize(2);
  for (int i = 0; i < 2; ++i)
    c.blocks[static_cast<std::size_t>(i)].box = {{Vec3{0.0, 0.0, kLength * i}, Vec3{kEdge, kEdge, kLength * (i + 1)}}};
  c.joint_laws["mortar"].compression = 1e8;
  cases::Load load;
  load.block = c.blocks[1].name, load.force = {0.0, 0.0, -kPush}, load.ramp = {0.0, 0.2};
  c.loads.push_back(load);
  return c;
}

}  // namespace

TEST_CASE("two blocks with a joint between them shorten as the joint does, beyond what whole bodies may overlap") {
  const cases::Case c = pressed_blocks();
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  while (sim.time() < 0.4) sim.step({false, sim.steps() % 20 == 0});
  const solver::World& w = sim.world();
  REQUIRE(kShorter > 3.0 * w.overlaps.allowed[1]);
  CHECK(w.overlaps.springs.empty());
  CHECK(-w.elements.uz[1] == doctest::Approx(kShorter).epsilon(1e-3));
  CHECK(sim.worst_residual() < 1e-6);
}

TEST_CASE("a joint that comes apart under pressure hands over what it bears: whole bodies do not push it back") {
  cases::Case c = pressed_blocks();
  c.joints.default_law = "dry";
  cases::Load aside;
  aside.block = c.blocks[1].name, aside.force = {200.0, 0.0, 0.0}, aside.ramp = {0.4, 0.41};
  c.loads.push_back(aside);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  double least = std::numeric_limits<double>::infinity(), lost = 0.0, gain = 0.0;
  while (sim.time() < 1.5) {
    sim.step({false, sim.steps() % 20 == 0});
    if (sim.time() > 0.4) least = std::min(least, -sim.world().elements.uz[1]);
    gain = std::max(gain, lost - sim.energy().dashpot), lost = sim.energy().dashpot;
  }
  REQUIRE(std::ranges::any_of(sim.world().sides.retired, [](auto r) { return r != 0; }));
  CHECK(least > 0.95 * kShorter);
  CHECK(gain < 1e-6 * kPush * kShorter);
  CHECK(sim.worst_residual() < 1e-4);
}

TEST_CASE("what has gone of an overlap that a joint bore comes back with a force of whole bodies") {
  cases::Case c = pressed_blocks();
  c.joints.default_law = "dry";
  cases::Load aside, less, again;
  aside.block = less.block = again.block = c.blocks[1].name;
  aside.force = {200.0, 0.0, 0.0}, aside.ramp = {0.4, 0.41};
  less.force = {0.0, 0.0, 0.5 * kPush}, less.ramp = {1.6, 1.7};
  again.force = {0.0, 0.0, -0.5 * kPush}, again.ramp = {1.9, 2.0};
  for (const cases::Load& load : {aside, less, again}) c.loads.push_back(load);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  const auto sunk = [&](double until) {
    while (sim.time() < until) sim.step({false, sim.steps() % 20 == 0});
    return -sim.world().elements.uz[1];
  };
  const double first = sunk(1.6);
  REQUIRE(sim.world().overlaps.springs.size() == 1);
  const double borne = sim.world().overlaps.springs.front().from;
  const double half = sunk(1.9);
  REQUIRE(sim.world().overlaps.springs.size() == 1);
  CHECK(sim.world().overlaps.springs.front().from < borne - 0.8 * (first - half));
  CHECK(half < 0.8 * first);
  CHECK(sunk(2.2) < 0.9 * first);
}
