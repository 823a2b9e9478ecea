// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>

#include "solver/bench/assembly_time.h"
#include "solver/bench/step_work.h"
#include "solver/run/simulation.h"
#include "solver/state/field_table.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

double part(const solver::Simulation& s, solver::ForcePart p) { return s.part_times()[static_cast<std::size_t>(p)]; }

/// A wall that has cracked, with blocks on the ground.
struct Ruin {
  Ruin() : ground(strong_shaking()), sim(value, model, ground, {}) {
    for (int i = 0; i < 2000; ++i) sim.step({});
  }
  cases::Case value = small_wall(4, 8);
  cases::Model model = cases::build_model(value);
  cases::GroundMotion ground;
  solver::Simulation sim;
};

}  // namespace

TEST_CASE("parts of the forces are timed when asked for, and looking at clocks and handing out zeros change no bit") {
  Ruin plain, timed;
  for (const double t : timed.sim.part_times()) CHECK(t == 0.0);
  timed.sim.time_parts(true);
  solver::JointTasks tasks(timed.sim.world());
  for (int i = 0; i < 100; ++i) {
    plain.sim.step({});
    timed.sim.step({});
    const solver::Elements& e = timed.sim.world().elements;
    const auto before = e.wrench, dashpots_before = e.dashpot;
    CHECK(solver::assembly_time(timed.sim.world(), tasks) > 0.0);
    CHECK(std::ranges::equal(e.wrench, before));
    CHECK(std::ranges::equal(e.dashpot, dashpots_before));
  }
  CHECK(solver::state_hash(plain.sim.world()) == solver::state_hash(timed.sim.world()));
  for (const solver::ForcePart p : {solver::ForcePart::damaged_joints, solver::ForcePart::contacts, solver::ForcePart::assembly}) {
    CHECK(part(timed.sim, p) > 0.0);
  }
  // No part is timed twice: the mean thread cannot have more than the stage has.
  double sum = 0.0;
  for (const double t : timed.sim.part_times()) sum += t;
  CHECK(sum <= timed.sim.stage_times()[static_cast<std::size_t>(solver::Stage::forces)]);
  timed.sim.time_parts(false);
  const solver::ForceTimes then = timed.sim.part_times();
  timed.sim.step({});
  CHECK(timed.sim.part_times() == then);
}

TEST_CASE("all time of whole joints goes to them") {
  const cases::Case c = small_wall(4, 8, 1000.0);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  sim.time_parts(true);
  for (int i = 0; i < 100; ++i) sim.step({});
  CHECK(part(sim, solver::ForcePart::whole_joints) > 0.0);
  CHECK(part(sim, solver::ForcePart::damaged_joints) == 0.0);
  CHECK(part(sim, solver::ForcePart::assembly) == 0.0);  // no contacts
}

TEST_CASE("an intact wall has whole joints and the update to do, twice the wall twice as much") {
  const auto work_of = [](int length) {
    const cases::Case c = small_wall(length, 8, 1000.0);
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, {}, {});
    sim.step({});
    const solver::StepWork w = solver::step_work(sim.world());
    CHECK(w.whole_sides == static_cast<double>(m.assembly.joints.size()));
    CHECK(w.damaged_sides == 0.0);
    CHECK(w.damaged_joints.operations == 0.0);
    CHECK(w.damaged_joints.bytes == 0.0);
    CHECK(w.contacts.bytes == 0.0);
    CHECK(w.assembly.bytes > 0.0);
    return w;
  };
  const solver::StepWork one = work_of(40), two = work_of(80);
  CHECK(two.whole_joints.operations / one.whole_joints.operations == doctest::Approx(2.0).epsilon(0.02));
  CHECK(two.update.operations / one.update.operations == doctest::Approx(2.0).epsilon(0.02));
  CHECK(two.update.bytes / one.update.bytes == doctest::Approx(2.0).epsilon(0.02));
  CHECK(two.assembly.bytes / one.assembly.bytes == doctest::Approx(2.0).epsilon(0.02));
}

TEST_CASE("in a ruin, contacts and damaged joints have work") {
  const Ruin ruin;
  const solver::StepWork w = solver::step_work(ruin.sim.world());
  CHECK(w.damaged_sides > 0.0);
  CHECK(w.damaged_joints.operations > 0.0);
  CHECK(w.contacts.operations > 0.0);
  CHECK(w.contacts.bytes > 0.0);
}
