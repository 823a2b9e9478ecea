// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "solver/run/run.h"
#include "solver/run/simulation.h"
#include "solver/setup/setup.h"
#include "solver/world/errors.h"
#include "tests/solver/rods.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

// Energy that joints and contacts take, and give back no more of: the ledger closes whatever the sign of a loss, so signs are looked at
// too.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// A wall that cracks and falls; the bricks of one course are shorter, so their segments meet no others and their joints have two sides.
cases::Case uneven_wall() {
  cases::Case c = small_wall(4, 6);
  std::erase_if(c.blocks, [](const cases::BlockSpec& b) { return b.name.starts_with("c3_"); });
  for (int k = 0; k < 5; ++k) c.blocks.push_back(brick(3, k, 0.16 * k, 0.16 * (k + 1)));
  return c;
}

/// A loss of the ledger [J], and the least share of it that was lost between two rows.
struct Loss {
  double all = 0.0, least = 0.0;
};

/// Shakes a wall to 0.6 s.
Loss shake(solver::Simulation& sim, double solver::EnergyRow::*loss) {
  Loss r;
  while (sim.time() < 0.6) {
    sim.step({false, sim.steps() % 20 == 0});
    sim.cracks().clear();
    if ((sim.steps() - 1) % 20 != 0) continue;
    const double now = sim.energy().*loss;
    r.least = std::min(r.least, (now - r.all) / (now + 1e-300));
    r.all = now;
  }
  return r;
}

}  // namespace

TEST_CASE("a wall that is shaken, cracks and falls loses energy and gains none, whatever happens after a shear failure") {
  const cases::GroundMotion g = strong_shaking();
  for (const auto after : {cases::PostShear::plastic, cases::PostShear::brittle}) {
    for (const auto tension : {cases::ShearInTension::cohesion, cases::ShearInTension::none, cases::ShearInTension::coulomb}) {
      cases::Case c = uneven_wall();
      c.failure.post_shear = after;
      c.failure.shear_in_tension = tension;
      const cases::Model m = cases::build_model(c);
      REQUIRE(std::ranges::any_of(m.assembly.joints, [](const geometry::Joint& j) { return j.element_b >= 0 && !j.merged; }));
      solver::Simulation sim(c, m, g, {});
      solver::EnergyRow before{};
      double least = 0.0;  // of what is lost between two rows, over all that has been
      while (sim.time() < 0.6) {
        sim.step({false, sim.steps() % 20 == 0});
        sim.cracks().clear();
        if ((sim.steps() - 1) % 20 != 0) continue;
        const solver::EnergyRow& now = sim.energy();
        const double all = now.friction + now.fracture + now.dashpot + now.damping + 1e-300;
        for (const double gain :
             {before.friction - now.friction, before.fracture - now.fracture, before.dashpot - now.dashpot, before.damping - now.damping})
          least = std::min(least, -gain / all);
        before = now;
      }
      CAPTURE(least);
      CHECK(sim.damage().tension + sim.damage().shear > 500);
      CHECK(sim.worst_residual() < 1e-4);
      CHECK(least > -1e-6);
      CHECK(before.friction > 0.0);
      CHECK(before.fracture > 0.0);
    }
  }
}

TEST_CASE("dashpots without bounds keep the ledger of a wall that falls, and give nothing out") {
  cases::Case c = uneven_wall();
  c.contact.dashpots = cases::Dashpots::unbounded;
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, strong_shaking(), {});
  const Loss dashpots = shake(sim, &solver::EnergyRow::dashpot);
  CHECK(sim.damage().tension + sim.damage().shear > 500);
  CHECK(dashpots.all > 0.1);
  CHECK(sim.worst_residual() < 1e-4);
  CHECK(dashpots.least > -1e-6);
}

// Springs give back what they took, so a dashpot alone slows the rebound; one that may not pull lets go before the springs are long again.
TEST_CASE("a block rebounds more slowly where its dashpots may pull: upon a joint, upon a free patch, edge upon edge") {
  enum class Upon { joint, patch, edge };
  for (const Upon upon : {Upon::joint, Upon::patch, Upon::edge}) {
    const auto rebound = [&](cases::Dashpots dashpots) {
      cases::Case c = small_wall(1, 1);
      c.joints.default_law = "dry";
      c.gravity.acceleration = {};
      c.damping.alpha = 0.0;
      c.contact.dashpots = dashpots;
      c.time.step = 5e-6;  // at the step of Eq. 19 dashpots act over a third of a step before the faces part
      if (upon == Upon::patch) c.blocks[0].box = {{Vec3{0.0, 0.0, 1e-4}, Vec3{0.2, 0.1, 0.1001}}};
      if (upon == Upon::edge) {
        c.base = std::nullopt;
        c.blocks = {rod(true, 2.0 * kHalfDiagonal + 1e-4), rod(false, 0.0)};
        c.blocks[1].fixed = true;
      }
      c.blocks[0].free = upon != Upon::joint;
      c.blocks[0].velocity = {0.0, 0.0, upon == Upon::edge ? -1.0 : -0.2};
      const cases::Model m = cases::build_model(c);
      solver::Simulation sim(c, m, {}, {});
      while (sim.time() < (upon == Upon::edge ? 0.04 : 0.02)) sim.step({});
      return sim.world().elements.vz[0];
    };
    const double bounded = rebound(cases::Dashpots::bounded), unbounded = rebound(cases::Dashpots::unbounded);
    MESSAGE("rebound ", bounded, ", without bounds ", unbounded, " m/s");
    CHECK(unbounded > 0.0);
    CHECK(unbounded < 0.95 * bounded);
  }
}

TEST_CASE("mass damping in a frame at rest keeps the ledger of a wall that holds: the ground may work through it") {
  cases::Case c = small_wall(4, 6, 1e6);
  c.damping.alpha = 15.0;
  c.damping.inertial = true;
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, strong_shaking(), {});
  while (sim.time() < 0.4) sim.step({false, sim.steps() % 20 == 0});
  CHECK(std::abs(sim.energy().damping) > 0.1);
  CHECK(sim.worst_residual() < 1e-6);
}

// In a frame at rest nothing pushes a block that touches nothing: it stays where it is and the ground moves on under it. Relative to the
// ground mass damping drags it along: v' = −z̈ − α v.
TEST_CASE("mass damping brakes a floating block in the frame that it is said to: closed forms") {
  cases::Case c = small_wall(1, 1);
  c.blocks[0].box = {{Vec3{0.0, 0.0, 1.0}, Vec3{0.2, 0.1, 1.1}}};
  c.blocks[0].free = true;
  c.gravity.acceleration = {};
  c.damping.alpha = 4.0;
  cases::GroundMotion g;
  g.axis[0] = {"x", 1.0, {3.0, 3.0}};  // m/s2
  for (const bool inertial : {false, true}) {
    c.damping.inertial = inertial;
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, g, {});
    while (sim.time() < 0.5) sim.step({false, sim.steps() % 20 == 0});
    const double t = sim.time() - 0.5 * sim.world().dt, v = sim.world().elements.vx[0];
    CHECK(v == doctest::Approx(inertial ? -3.0 * t : -3.0 / 4.0 * (1.0 - std::exp(-4.0 * t))).epsilon(1e-3));
    CHECK(sim.worst_residual() < 1e-6);
  }
}

TEST_CASE("a wall whose bonds soften loses energy and gains none, and its ledger closes as that of a brittle one") {
  const cases::GroundMotion g = strong_shaking();
  for (const auto curve : {cases::SofteningCurve::exponential, cases::SofteningCurve::linear}) {
    cases::Case c = uneven_wall();
    cases::JointLaw& law = c.joint_laws["mortar"];
    law.fracture_energy_tension = 0.2, law.fracture_energy_shear = 0.4, law.softening = curve;
    law.residual_friction = 28.0, law.dilatancy = 12.0;
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, g, {});
    solver::EnergyRow before{};
    double least = 0.0;  // of what is lost between two rows, over all that has been
    std::size_t worn = 0;
    while (sim.time() < 0.6) {
      sim.step({false, sim.steps() % 20 == 0});
      sim.cracks().clear();
      if ((sim.steps() - 1) % 20 != 0) continue;
      const solver::EnergyRow& now = sim.energy();
      const double all = now.friction + now.fracture + now.dashpot + now.damping + 1e-300;
      least = std::min({least, (now.friction - before.friction) / all, (now.fracture - before.fracture) / all});
      before = now;
      const auto& wear = *sim.world().sides.state_of_law("segment_wear");
      worn =
          std::max(worn, static_cast<std::size_t>(std::count_if(wear.data(), wear.data() + wear.size(), [](double x) { return x > 0.0; })));
    }
    CAPTURE(least);
    MESSAGE("residual ", sim.worst_residual(), ", ", worn, " segments worn at once");
    CHECK(worn > 200);
    CHECK(sim.damage().tension + sim.damage().shear > 500);
    CHECK(sim.worst_residual() < 1e-4);
    CHECK(least > -1e-6);
  }
}

TEST_CASE("a wall whose contacts crush loses energy by it and gains none, and its ledger closes") {
  const cases::GroundMotion g = strong_shaking();
  for (const double energy : {0.0, 4.0}) {
    cases::Case c = uneven_wall();
    c.contact.compression = 3e4, c.contact.crushing_energy = energy, c.contact.residual_compression = energy > 0.0 ? 5e3 : 0.0;
    c.contact.crushing_depth = 3e-3;
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, g, {});
    const Loss fracture = shake(sim, &solver::EnergyRow::fracture);
    double by_patches = 0.0;  // J
    const solver::World& w = sim.world();
    for (const solver::FreePatch& p : w.patches.patch) by_patches += p.fracture;
    MESSAGE("residual ", sim.worst_residual(), ", lost by breaking ", fracture.all, " J, by crushing of free patches ", by_patches, " J");
    CHECK(by_patches > 1e-4);
    CHECK(std::ranges::max(*w.sides.state_of_law("segment_crushed")) > 1e-5);
    CHECK(sim.worst_residual() < 1e-4);
    CHECK(fracture.least > -1e-6);
  }
}

TEST_CASE("a run in which energy comes from nowhere stops, and says how much, when and what to try") {
  cases::Case c = small_wall(3, 4, 1e9);
  c.output.ledger_interval = 0.005;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  for (const double push : {0.0, 0.05}) {  // m/s
    solver::Simulation sim(c, m, g, {});
    solver::RunState plan;
    RowHash rows;
    const auto tick = [&](const solver::RunStatus& status) {
      if (status.time < 0.1 && status.time + 0.05 > 0.1) sim.world().elements.vy[4] += push;
      return true;
    };
    const auto run = [&] { solver::run(sim, plan, c, 0.2, rows, tick); };
    if (push == 0.0) {
      run();
      CHECK(sim.worst_residual() < 1e-4);
    } else {
      std::string said;
      try {
        run();
      } catch (const solver::NumericalError& e) {
        said = e.what();
      }
      for (const char* part :
           {"the energy ledger is off by 0.", "of the energy in play at t = 0.", "allowed: 0.01", "fastest is ", "try --dt "})
        CHECK_MESSAGE(said.find(part) != std::string::npos, said);
      CHECK(sim.energy().residual > solver::kResidualLimit);
      CHECK(sim.time() < 0.2);
    }
  }
}

// A block on the base is a mass on a spring and a dashpot: M A = m in (20), so c = 2 h sqrt(k m)/(1 + 2 beta dt) is h/(1 + 2 beta dt) of
// critical.
TEST_CASE("the dashpots of a joint damp a block that bounces on the base as (20) says") {
  for (const double h : {0.02, 0.05}) {
    cases::Case c = small_wall(1, 1, 1e6);
    c.damping = {};
    c.contact.damping = h;
    c.joints.default_law = "dry";
    c.time.step = 2e-6;
    c.gravity.acceleration = {0.0, 0.0, -9.81};
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, {}, {});
    const solver::Elements& e = sim.world().elements;
    // Let go above its rest, at the height of no force: it swings about the rest and never parts from the base.
    std::vector<double> turns;  // m, where it comes to a halt, above and below in turn
    double v = 0.0;
    while (turns.size() < 12) {
      sim.step({});
      if (e.vz[0] * v < 0.0) turns.push_back(e.uz[0]);
      v = e.vz[0];
    }
    const double decrement = std::log((turns[1] - turns[0]) / (turns[11] - turns[10])) / 5.0;  // of a whole swing
    const double ratio = decrement / std::sqrt(4.0 * std::numbers::pi * std::numbers::pi + decrement * decrement);
    const double beta = e.body[0].beta;
    CHECK(ratio == doctest::Approx(h / (1.0 + 2.0 * beta * sim.dt())).epsilon(0.01));
  }
}

// (5) by hand: halves of the bricks without half the mortar, and the mortar, in series; plane strain across, shear along the joint.
TEST_CASE("a joint is as stiff as its two bricks and its mortar in series, each with moduli and thickness of its own") {
  cases::Case c = small_wall(1, 0);
  c.materials["wood"] = {700.0, 6.3e8, 0.3};
  c.joint_laws["mortar"].thickness = 0.012, c.joint_laws["mortar"].young = 3.0e8, c.joint_laws["mortar"].poisson = 0.15;
  c.blocks = {brick(0, 0, 0.0, 0.2), brick(1, 0, 0.0, 0.2)};
  c.blocks[1].material = "wood";
  (*c.blocks[1].box)[1].z = 0.16;
  const cases::Model m = cases::build_model(c);
  const auto w = solver::build_world(c, m, {});
  bool found = false;
  for (std::size_t id = 0; id < w->sides.joint.size(); ++id) {
    const std::int32_t j = w->sides.joint[id];
    if (j < 0 || m.assembly.joints[static_cast<std::size_t>(j)].element_b < 0) continue;
    const double lower = 0.05 - 0.006, upper = 0.03 - 0.006;
    const double cn = lower * (1 - 0.25 * 0.25) / 9.8e7 + upper * (1 - 0.3 * 0.3) / 6.3e8 + 0.012 * (1 - 0.15 * 0.15) / 3.0e8;
    const double cs = lower * 2 * (1 + 0.25) / 9.8e7 + upper * 2 * (1 + 0.3) / 6.3e8 + 0.012 * 2 * (1 + 0.15) / 3.0e8;
    const kernels::Side s = w->sides.side(static_cast<std::int64_t>(id));
    CHECK(s.k.kn == doctest::Approx(1.0 / cn).epsilon(1e-9));
    CHECK(s.k.ks == doctest::Approx(1.0 / cs).epsilon(1e-9));
    found = true;
  }
  CHECK(found);
}
