// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "solver/run/run.h"
#include "solver/state/saved_state.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

// From gravity to the first moment of the shaking.

using namespace voussoir;
using namespace voussoir::testing;

TEST_CASE("what comes loose while a structure settles keeps the damping that brings it to rest, until it shakes") {
  cases::Case c = small_wall(1, 1, 1e-3);
  c.gravity.settle = true;
  c.damping.debris = false;
  c.blocks.push_back(brick(1, 0, 0.11, 0.31));  // its centroid is beyond the edge of the one below
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  const auto& e = sim.world().elements;
  REQUIRE(e.bonds[1] > 0);
  for (int i = 0; e.bonds[1] > 0 && i < 200000; ++i) sim.step({});
  REQUIRE(e.bonds[1] == 0);
  REQUIRE(sim.time() < 0.0);
  CHECK(e.alpha[1] == e.alpha[0]);
  CHECK(e.alpha[1] > 10.0);
  sim.start_shaking();
  CHECK(e.alpha[0] == 1.5);
  CHECK(e.alpha[1] == 0.0);
}

TEST_CASE("without a ramp of gravity and without a frequency a structure settles as with the usual ramp") {
  const auto damping = [](std::optional<double> ramp) {
    cases::Case c = small_wall(1, 1);
    c.gravity.settle = true;
    c.gravity.ramp = ramp;
    c.damping.alpha = {};
    const cases::Model m = cases::build_model(c);
    return solver::Simulation(c, m, {}, {}).world().elements.alpha[0];
  };
  CHECK(damping(0.0) == damping({}));
  CHECK(damping(0.5) == doctest::Approx(2.0 * damping({})));
  CHECK(damping(1e-9) == doctest::Approx(20.0 * damping({})));
}

TEST_CASE("a block that begins with a velocity has it when the shaking begins, and rests while the structure settles") {
  cases::Case c = small_wall(1, 1);
  c.gravity.settle = true;
  c.blocks.push_back(brick(50, 0, 2.0, 2.2));
  c.blocks[1].free = true;
  c.blocks[1].velocity = {3.0, 0.0, 0.0}, c.blocks[1].angular_velocity = {0.0, 0.0, 5.0};
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  const auto& e = sim.world().elements;
  for (int i = 0; i < 50; ++i) sim.step({});
  CHECK(e.vx[1] == 0.0);
  CHECK(e.wz[1] == 0.0);
  sim.start_shaking();
  CHECK(e.vx[1] == 3.0);
  CHECK(e.wz[1] == 5.0);
  CHECK(e.lz[1] == doctest::Approx(5.0 / e.izz[1]));
  CHECK(e.vx[0] == 0.0);
  sim.step({});
  CHECK(e.ux[1] == doctest::Approx(3.0 * sim.dt()).epsilon(1e-3).scale(0.0));
}

TEST_CASE("how often energies are written does not decide when the shaking begins; a run stopped before it has not settled") {
  const auto settled = [](double interval, bool stop) {
    cases::Case c = small_wall(2, 2);
    c.gravity.settle = true;
    c.gravity.ramp = 0.05;
    c.output.ledger_interval = interval;
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, {}, {});
    solver::RunState plan;
    RowHash out;
    const solver::RunResult r = solver::run(sim, plan, c, 0.01, out, [&](const solver::RunStatus& s) { return !stop || s.step < 40; });
    CHECK(r.summary.settled == !stop);
    return plan.steps;
  };
  const std::int64_t steps = settled(0.01, false);
  CHECK(settled(4.0, false) == steps);
  CHECK(settled(0.003, false) == steps);
  CHECK(settled(0.01, true) == 40);
}

TEST_CASE("what a structure's own weight breaks is counted apart from what the shaking breaks, also by a run that is gone on with") {
  cases::Case c = small_wall(1, 1, 1e-3);
  c.gravity.settle = true;
  c.gravity.ramp = 0.05;
  c.gravity.settle_limit = 0.1;
  c.blocks.push_back(brick(1, 0, 0.11, 0.31));  // its centroid is beyond the edge of the one below
  c.blocks.push_back(brick(0, 9, 0.6, 0.8));    // stands by itself, and is shaken off the base
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion motion = strong_shaking();
  solver::Simulation sim(c, m, motion, {});
  solver::RunState plan;
  RowHash out;
  solver::Summary while_settling;
  bool shaking = false;
  const auto watch = [&](const solver::RunStatus& s) {
    if (s.settling) while_settling = solver::summarise(sim, plan);
    shaking = shaking || !s.settling;
    return s.settling || s.time < 0.1;
  };
  const solver::RunResult r = solver::run(sim, plan, c, 0.3, out, watch);
  REQUIRE(r.stopped);
  REQUIRE(shaking);
  const solver::SettlingDamage& own = r.summary.settling;
  CHECK(own.opened() > 0);
  CHECK(own.first_crack_time < 0.0);
  CHECK(own.first_crack_time == plan.settling_crack);
  CHECK(while_settling.settling.opened() > 0);
  CHECK(while_settling.settling.opened() <= own.opened());
  CHECK(r.summary.tension + r.summary.shear + r.summary.compression > own.opened());
  CHECK(r.summary.first_crack_time >= 0.0);

  const solver::SavedState state = solver::save(sim, plan);
  solver::Simulation again(c, m, motion, {});
  solver::RunState back;
  solver::restore(again, back, state);
  const solver::SettlingDamage& restored = solver::summarise(again, back).settling;
  CHECK(restored.tension == own.tension);
  CHECK(restored.shear == own.shear);
  CHECK(restored.slipped == own.slipped);
  CHECK(restored.first_crack_time == own.first_crack_time);
}
