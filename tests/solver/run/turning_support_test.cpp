// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "solver/analysis/drive.h"
#include "solver/run/run.h"
#include "solver/run/simulation.h"
#include "solver/state/saved_state.h"
#include "solver/supports/supports.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

// Supports that turn: THEORY.md, section 8. The paper has none.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A fixed box and a free one on top of it.
cases::Case box_on_box() {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e8, 0.2};
  c.joint_laws["glue"] = {1e9, 1e9, 35.0, 1e12};
  const Vec3 boxes[][2] = {{{0.0, 0.0, -0.2}, {1.0, 0.4, 0.0}}, {{0.2, 0.1, 0.0}, {0.5, 0.3, 0.2}}};
  for (int i = 0; i < 2; ++i) {
    cases::BlockSpec b;
    b.name = std::to_string(i), b.material = "stone", b.box = {{boxes[i][0], boxes[i][1]}}, b.fixed = i == 0;
    c.blocks.push_back(b);
  }
  return c;
}

/// The model with a history for the fixed box.
cases::Model turned_by(const cases::Case& c, cases::SupportHistory history) {
  cases::Model m = cases::build_model(c);
  m.support_motions.push_back(std::move(history));
  m.blocks[0].support_motion = 0;
  return m;
}

double angle_of(const solver::Elements& e, std::size_t i) { return 2.0 * std::asin(norm(Vec3{e.qx[i], e.qy[i], e.qz[i]})); }

/// Rocks and slides under a free box.
cases::SupportHistory rocking() {
  cases::SupportHistory h;
  for (int i = 0; i <= 400; ++i) {
    const double t = 5e-4 * i, phase = 2.0 * std::numbers::pi * 10.0 * t;
    h.time.push_back(t), h.displacement.push_back({1e-4 * std::sin(phase), 0.0, 0.0});
    h.rotation.push_back({2e-4 * (1.0 - std::cos(phase)), 3e-4 * std::sin(phase), 1e-3 * std::sin(phase)});
  }
  h.about = Vec3{0.2, 0.2, 0.0};
  return h;
}

}  // namespace

TEST_CASE("what is glued to a support that turns about a point turns with it, as far as it likes") {
  cases::Case c = box_on_box();
  c.gravity.acceleration = {}, c.gravity.settle = false;
  c.joints.default_law = "glue";
  c.damping.alpha = 50.0;
  const Vec3 turn = 200.0 * kDegree / norm(Vec3{1.0, 2.0, 0.5}) * Vec3{1.0, 2.0, 0.5}, about{-0.3, 0.1, 0.4};
  const cases::SupportHistory h{{0.0, 1.0, 2.0}, {{}, {0.1, 0.0, 0.05}, {0.1, 0.0, 0.05}}, false, "", "", {{}, turn, turn}, about};
  const cases::Model m = turned_by(c, h);
  solver::Simulation sim(c, m, {}, {});
  while (sim.time() < 1.5) sim.step({});
  const solver::Elements& e = sim.world().elements;
  for (std::size_t i = 0; i < 2; ++i) {
    CAPTURE(i);
    const cases::SupportPose wanted = pose_at(h, e.body[i].ref, 2.0);
    CHECK(norm(Vec3{e.ux[i], e.uy[i], e.uz[i]} - wanted.displacement) < 1e-4);  // what its sudden stop has left swings on
    CHECK(std::abs(e.qw[i] * wanted.orientation.w + e.qx[i] * wanted.orientation.x + e.qy[i] * wanted.orientation.y +
                   e.qz[i] * wanted.orientation.z) == doctest::Approx(1.0).epsilon(1e-7));
  }
  CHECK(norm(Vec3{e.wx[0], e.wy[0], e.wz[0]}) == 0.0);  // it stands still again
  CHECK(solver::moved(sim.world(), sim.world().supports[0]) > 0.5);
}

TEST_CASE(
    "the ledger closes, the better the smaller the step, where a support that turns works against the dashpots of what stands on it") {
  cases::Case c = box_on_box();
  c.joints.default_law = "dry";
  const auto residual = [&](double step) {
    c.time.step = step;
    const cases::Model m = turned_by(c, rocking());
    solver::Simulation sim(c, m, {}, {});
    while (!sim.at_rest() && sim.time() < 3.0) sim.step({false, true});
    sim.start_shaking();
    while (sim.time() < 0.2) sim.step({false, true});
    CHECK(sim.energy().dashpot > 1e-3);
    CHECK(std::abs(sim.energy().input) > 1e-3);
    MESSAGE("step " << step << " s: residual " << sim.worst_residual() << ", input " << sim.energy().input << " J, dashpots "
                    << sim.energy().dashpot << " J");
    return sim.worst_residual();
  };
  const double coarse = residual(1e-4), fine = residual(2.5e-5);
  CHECK(coarse < 1e-5);
  CHECK(fine < coarse / 3.0);
}

TEST_CASE("a run with a support that turns has the same bits when it is saved and gone on with") {
  cases::Case c = box_on_box();
  c.joints.default_law = "dry";
  c.gravity.ramp = 0.05, c.gravity.settle_limit = 0.05;
  c.output.history = {{"top", {0.3, 0.2, 0.1}}};
  const cases::Model m = turned_by(c, rocking());
  const auto run = [&](std::vector<std::int64_t> stops) {
    RowHash out;
    solver::SavedState saved;
    for (int leg = 0;; ++leg) {
      solver::Simulation sim(c, m, {}, {});
      solver::RunState plan;
      if (leg > 0) solver::restore(sim, plan, saved);
      const auto go_on = [&](const solver::RunStatus& s) {
        if (stops.empty() || s.step < stops.front()) return true;
        stops.erase(stops.begin());
        return false;
      };
      const solver::RunResult r = solver::run(sim, plan, c, 0.15, out, go_on);
      saved = solver::save(sim, plan);
      if (!r.stopped) return out.values();
    }
  };
  CHECK(run({}) == run({3, 150, 151, 700, 1200}));
}

TEST_CASE("equilibrium: a box slides off a support that turns at the angle of friction") {
  cases::Case c = box_on_box();
  c.joints.default_law = "dry";
  c.contact.friction = 20.0;
  c.analysis.kind = cases::AnalysisKind::settlement, c.analysis.solver = cases::Solver::equilibrium, c.analysis.path_step = 0.005;
  const cases::Model m = turned_by(c, {{0.0, 30.0}, {{}, {}}, false, "", "", {{}, {0.0, 30.0 * kDegree, 0.0}}, Vec3{1.0, 0.2, 0.0}});
  solver::Simulation sim(c, m, {}, {});
  solver::choose_drive(sim, c);
  solver::RunState plan;
  RowHash out;
  (void)solver::run(sim, plan, c, c.end(), out, [](const solver::RunStatus&) { return true; });
  const double angle = angle_of(sim.world().elements, 0) / kDegree;
  MESSAGE("found no rest at " << angle << " degrees; friction is 20");
  CHECK(angle > 19.9);
  CHECK(angle < 20.3);
}
