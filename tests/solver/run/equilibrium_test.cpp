// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "solver/equilibrium/path.h"
#include "solver/world/errors.h"
#include "tests/solver/interrupted_analysis.h"
#include "tests/solver/no_rows.h"
#include "tests/solver/small_wall.h"

// States of rest of a small wall: same bits in any way to run them, a curve that depends on no tolerance, nothing that depends on a rate.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

class Rows final : public testing::NoRows {
 public:
  void energy(const solver::EnergyRow& row) override { energies.push_back(row); }
  void damage(const solver::DamageRow& row) override { broken = row.tension + row.shear + row.compression; }
  void frame(const solver::FrameView& f) override { frames.push_back(f.time); }
  void assessment(const solver::AssessmentRow& row) override { rows.push_back(row); }

  [[nodiscard]] double peak() const { return std::ranges::max_element(rows, {}, &solver::AssessmentRow::factor)->factor; }

  std::vector<solver::EnergyRow> energies;
  std::vector<solver::AssessmentRow> rows;
  std::vector<double> frames;
  std::int64_t broken = 0;
};

cases::Case pushed_wall(cases::AnalysisKind kind) {
  cases::Case c = small_wall(3, 4);
  c.gravity.settle = true;
  c.analysis.kind = kind, c.analysis.solver = cases::Solver::equilibrium;
  c.analysis.direction = {0.0, 1.0};
  return c;
}

Outcome<Rows> run(const cases::Case& c, std::set<std::int64_t> stops = {}, const std::vector<int>& threads = {1}) {
  return run_in_legs<Rows>(c, std::move(stops), threads);
}

}  // namespace

TEST_CASE("equilibrium: the same bits with any number of threads and any stops; each row is a state of rest with a frame") {
  for (const auto kind : {cases::AnalysisKind::pushover, cases::AnalysisKind::tilt}) {
    const cases::Case c = pushed_wall(kind);
    const Outcome<Rows> straight = run(c);
    CHECK(straight.out.broken > 0);
    REQUIRE(straight.out.rows.size() > 30);
    CHECK(straight.out.rows.back().over == 1.0);
    for (const solver::AssessmentRow& r : straight.out.rows) {
      CHECK(r.unbalanced <= c.analysis.tolerance);
      CHECK(std::ranges::binary_search(straight.out.frames, r.time));
    }
    for (const solver::EnergyRow& e : straight.out.energies) CHECK(e.residual < 1e-6);
    const Outcome<Rows> stopped = run(c, {900, 5000, 20000}, {2, 1});
    CHECK(difference(straight.state, stopped.state) == "");
    CHECK(straight.out.rows.size() == stopped.out.rows.size());
  }
}

TEST_CASE("equilibrium: the peak depends neither on the tolerance nor on the step of the path") {
  cases::Case c = pushed_wall(cases::AnalysisKind::pushover);
  const double peak = run(c).out.peak();
  c.analysis.tolerance *= 10.0;
  CHECK(run(c).out.peak() == doctest::Approx(peak).epsilon(0.01));
  c.analysis.tolerance /= 10.0, c.analysis.path_step /= 2.0;
  CHECK(run(c).out.peak() == doctest::Approx(peak).epsilon(0.01));
}

TEST_CASE("equilibrium: while nothing breaks, the next state of rest is foreseen and found in few iterations") {
  cases::Case c = pushed_wall(cases::AnalysisKind::pushover);
  c.analysis.largest_factor = 0.1;
  const Outcome<Rows> o = run(c);
  REQUIRE(o.out.rows.size() > 5);
  const cases::Model m = cases::build_model(c);
  const double dt = solver::Simulation(c, m, {}, {}).dt();
  CHECK((o.out.rows[1].time - o.out.rows[0].time) / dt < 5000.0);  // the first ramp is long only where inertia asks for it
  for (std::size_t i = 4; i < o.out.rows.size(); ++i) CHECK((o.out.rows[i].time - o.out.rows[i - 1].time) / dt < 400.0);
}

TEST_CASE("equilibrium: ties have the stiffness of the case, since masses follow from it") {
  cases::Case c = pushed_wall(cases::AnalysisKind::pushover);
  cases::Tie rod;
  rod.name = "rod", rod.from = {0.0, 0.05, 0.05}, rod.to = {0.0, 0.05, 0.25};
  rod.area = 0.01, rod.young = 2e11;
  c.ties.push_back(rod);
  const cases::Model m = cases::build_model(c);
  const auto left = [&](const cases::Case& of) {
    const solver::Simulation sim(of, m, {}, {});
    const solver::Ties& ties = sim.world().ties;
    REQUIRE(ties.tie.size() == 1);
    return ties.tie[0].law.stiffness / ties.tie[0].wanted;
  };
  CHECK(left(c) == 1.0);
  c.analysis.solver = cases::Solver::dynamics;
  CHECK(left(c) < 0.9);
}

TEST_CASE("equilibrium: dashpots, restitution and mass damping of the case change no bit") {
  cases::Case c = pushed_wall(cases::AnalysisKind::pushover);
  c.analysis.largest_factor = 0.1;
  const Outcome<Rows> plain = run(c);
  c.contact.damping = 0.1, c.damping.alpha = 30.0;
  CHECK(difference(plain.state, run(c).state) == "");
}

TEST_CASE("equilibrium: numbers that are none are a numerical failure, not a fall") {
  const cases::Case c = pushed_wall(cases::AnalysisKind::pushover);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  solver::choose_drive(sim, c);
  sim.start_shaking();
  sim.step({.ledger = true});  // the first row is that to which others compare
  sim.world().elements.vx[0] = 300.0;
  sim.check_speeds();
  CHECK(sim.path().is_lost());
  const double worst = sim.worst_residual();
  sim.step({.ledger = true});
  CHECK(sim.energy().residual > 1e-3);
  CHECK(sim.worst_residual() == worst);  // a motion that finds no rest is no result
  sim.world().elements.vx[0] = std::nan("");
  CHECK_THROWS_WITH_AS(sim.check_speeds(), doctest::Contains("moves at nan m/s"), solver::NumericalError);
}

TEST_CASE("equilibrium: what falls while gravity is put on has no state of rest, and the message says so") {
  cases::Case c = pushed_wall(cases::AnalysisKind::pushover);
  c.joints.default_law = "dry";
  cases::BlockSpec foot, slab;
  foot.name = "foot", slab.name = "slab", foot.material = slab.material = c.materials.begin()->first;
  foot.box = {{{3.0, 0.0, 0.0}, {3.2, 0.2, 0.2}}}, slab.box = {{{3.15, 0.0, 0.2}, {3.55, 0.2, 0.3}}};
  foot.fixed = true;
  c.base.reset(), c.blocks = {foot, slab};
  CHECK_THROWS_WITH_AS(run(c), doctest::Contains("finds no rest while gravity is put on"), solver::NumericalError);
}

TEST_CASE("equilibrium: where blocks slide on several beds at once, the load drives them and not the motion that is predicted") {
  cases::Case c;
  c.materials["stone"] = {2000.0, 5e9, 0.2};
  c.contact.friction = 35.0;
  c.base = cases::Base{};
  c.segment_size = 0.1;
  c.analysis.kind = cases::AnalysisKind::pushover;
  c.analysis.direction = {0.9, 0.3};
  for (int i = 0; i < 5; ++i) {
    const double half = 0.45 - 0.075 * i, low = 0.25 * i;
    cases::BlockSpec b;
    b.name = "b" + std::to_string(i), b.material = "stone";
    b.box = {{Vec3{-half, -half, low}, Vec3{half, half, low + 0.25}}};
    c.blocks.push_back(b);
  }
  const Outcome<Rows> o = run(c);
  CHECK(o.out.peak() == doctest::Approx(std::tan(35.0 * std::numbers::pi / 180.0)).epsilon(2e-3));
  CHECK(o.out.rows.back().displacement > 0.1);
  for (const solver::EnergyRow& e : o.out.energies)
    if (e.input > 0.01) CHECK(e.damping > -0.02 * e.input);  // J; less: what is predicted has worked
}

TEST_CASE("equilibrium: where a soft joint comes apart on the way, masses change and the ledger closes; stops change no bit") {
  cases::Case c;
  c.materials["stone"] = {2000.0, 5e9, 0.2};
  cases::JointLaw& bed = c.joint_laws["bed"];
  bed.tension = bed.cohesion = 1.0, bed.friction = 20.0, bed.compression = 1e9;
  bed.normal_stiffness = 1e9, bed.shear_stiffness = 4e8;  // blocks: 40 GPa/m
  c.joints.default_law = "bed";
  c.contact.friction = 20.0;
  c.base = cases::Base{};
  c.segment_size = 0.05;
  c.analysis.kind = cases::AnalysisKind::tilt, c.analysis.solver = cases::Solver::equilibrium;
  c.analysis.direction = {1.0, 0.0}, c.analysis.largest_drift = 0.3;
  for (int i = 0; i < 2; ++i) {
    cases::BlockSpec b;
    b.name = std::to_string(i), b.material = "stone", b.box = {{Vec3{0.0, 0.0, 0.2 * i}, Vec3{0.5, 0.2, 0.2 * (i + 1)}}};
    c.blocks.push_back(b);
  }
  const Outcome<Rows> straight = run(c);
  CHECK(straight.out.rows.back().displacement > 0.05);
  for (const solver::EnergyRow& e : straight.out.energies) CHECK(e.residual < 1e-6);
  std::set<std::int64_t> stops;
  for (std::int64_t k = 1; k < 50; ++k) stops.insert(2000 * k);
  const Outcome<Rows> stopped = run(c, stops);
  CHECK(difference(straight.state, stopped.state) == "");
}

TEST_CASE("equilibrium: a settlement ends where its history does, whatever round-off leaves of the sum of its increments") {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e8, 0.2};
  c.analysis.kind = cases::AnalysisKind::settlement, c.analysis.solver = cases::Solver::equilibrium, c.analysis.path_step = 0.2;
  c.analysis.longest = 2.0;
  const Vec3 boxes[][2] = {{{0.0, 0.0, -0.2}, {0.4, 0.4, 0.0}}, {{0.6, 0.0, -0.2}, {1.0, 0.4, 0.0}}, {{0.0, 0.0, 0.0}, {1.0, 0.4, 0.2}}};
  for (int i = 0; i < 3; ++i) {
    cases::BlockSpec b;
    b.name = std::to_string(i), b.material = "stone", b.box = {{boxes[i][0], boxes[i][1]}}, b.fixed = i < 2;
    if (i == 0) b.motion.emplace().file = "sink.csv";
    c.blocks.push_back(b);
  }
  for (const double end : {6.1, 8.9, 10.3, 11.1}) {
    cases::Model m = cases::build_model(c);
    m.support_motions[0].time = {0.0, end}, m.support_motions[0].displacement = {{}, {0.0, 0.0, -0.03}};
    solver::Simulation sim(c, m, {}, {});
    solver::choose_drive(sim, c);
    solver::RunState plan;
    Rows out;
    (void)solver::run(sim, plan, c, c.end(), out, [](const solver::RunStatus&) { return true; });
    CAPTURE(end);
    REQUIRE(!out.rows.empty());
    CHECK(out.rows.back().support_moved == doctest::Approx(0.03));
    CHECK(out.rows.back().over == 1.0);
    CHECK(std::ranges::count_if(out.rows, [](const solver::AssessmentRow& r) { return r.support_moved > 0.03 - 1e-9; }) == 1);
  }
}

TEST_CASE("path: small loads ask for a smaller tolerance, and after 20,000 iterations less and less so") {
  cases::Analysis a;
  a.tolerance = 1e-4;
  solver::Path path(a);
  path.set(1e-3, 0.0);
  path.accept({.factor = 0.0, .bonds = 10}, 100.0, 1.0);
  path.accept({.factor = 0.02, .done = 1e-3, .bonds = 10}, 100.0, 1.0);
  const auto iterate_to = [&](std::int64_t end) {
    while (path.iterations() < end) path.iterated(0.02);
  };
  iterate_to(10'000);
  REQUIRE(path.pull() == 0.0);
  CHECK(path.rests(0.99e-5));  // 2.5 times the load factor, but no less than a tenth
  CHECK_FALSE(path.rests(1.01e-5));
  iterate_to(20'000);
  CHECK_FALSE(path.rests(1.01e-5));
  iterate_to(40'000);
  CHECK(path.rests(1.99e-5));
  CHECK_FALSE(path.rests(2.01e-5));
  iterate_to(100'000);
  CHECK_FALSE(path.is_lost());
  CHECK_FALSE(path.rests(1.01e-4));
}
