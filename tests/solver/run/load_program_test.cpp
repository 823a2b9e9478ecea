// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "tests/solver/interrupted_analysis.h"
#include "tests/solver/no_rows.h"
#include "tests/solver/small_wall.h"

// Quasi-static analyses of a small wall: same bits in any way to run them, work in the ledger, no swing of the spring's own.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

class Rows final : public testing::NoRows {
 public:
  void energy(const solver::EnergyRow& row) override { energies.push_back(row); }
  void cracks(std::span<const solver::CrackRow> some) override { broken += some.size(); }
  void drive(const solver::Drive& d) override { chosen = d; }
  void assessment(const solver::AssessmentRow& row) override { rows.push_back(row); }

  std::vector<solver::EnergyRow> energies;
  std::vector<solver::AssessmentRow> rows;
  solver::Drive chosen;
  std::size_t broken = 0;
};

cases::Case pushed_wall(cases::AnalysisKind kind) {
  cases::Case c = small_wall(3, 4);
  c.gravity.settle = true, c.gravity.ramp = 0.1, c.gravity.settle_limit = 0.1;
  c.output.ledger_interval = 0.001;
  c.analysis.kind = kind;
  c.analysis.direction = {0.0, 1.0};
  c.analysis.pace = 0.3;
  c.analysis.longest = 1.5;
  return c;
}

Outcome<Rows> run(const cases::Case& c, std::set<std::int64_t> stops = {}, const std::vector<int>& threads = {1}) {
  return run_in_legs<Rows>(c, std::move(stops), threads);
}

/// Work of the forces along the curve, and what the ledger says was put in, from the first row at time zero [J].
void check_work(const Rows& out) {
  const auto first = std::ranges::find_if(out.energies, [](const auto& e) { return e.time >= 0.0; });
  REQUIRE(static_cast<std::size_t>(out.energies.end() - first) == out.rows.size());
  double work = 0.0, most = 0.0, off = 0.0;
  for (std::size_t i = 1; i < out.rows.size(); ++i) {
    work += 0.5 * out.chosen.weight * (out.rows[i].factor + out.rows[i - 1].factor) * (out.rows[i].moved - out.rows[i - 1].moved);
    const double booked = first[static_cast<std::ptrdiff_t>(i)].input - first->input;
    most = std::max(most, std::abs(work)), off = std::max(off, std::abs(work - booked));
  }
  REQUIRE(most > 0.0);
  CHECK(off < 1e-3 * most);
}

}  // namespace

TEST_CASE("a pushover has the same bits with any number of threads and any stops, and its work is in the ledger") {
  const cases::Case c = pushed_wall(cases::AnalysisKind::pushover);
  const Outcome<Rows> straight = run(c);
  CHECK(straight.out.broken > 0);
  CHECK(straight.out.rows.size() > 100);
  check_work(straight.out);
  for (const solver::EnergyRow& e : straight.out.energies) CHECK(e.residual < 1e-3);
  const Outcome<Rows> stopped = run(c, {900, 5000, 9000}, {2, 1});
  CHECK(difference(straight.state, stopped.state) == "");
  CHECK(straight.out.rows.size() == stopped.out.rows.size());
}

TEST_CASE("a tilt and a pushover by the first mode have the same bits across stops, and their work is in the ledger") {
  for (const auto kind : {cases::AnalysisKind::tilt, cases::AnalysisKind::pushover}) {
    cases::Case c = pushed_wall(kind);
    c.analysis.longest = 0.4;
    if (kind == cases::AnalysisKind::pushover) c.analysis.pattern = cases::LoadPattern::mode;
    const Outcome<Rows> straight = run(c);
    if (kind == cases::AnalysisKind::pushover) check_work(straight.out);
    CHECK(difference(straight.state, run(c, {6000}, {2}).state) == "");
  }
}

TEST_CASE("without a base the drift of an analysis counts from the lowest corner, wherever the model stands") {
  cases::Case c = pushed_wall(cases::AnalysisKind::tilt);
  c.analysis.longest = 0.2;
  c.base.reset();
  for (cases::BlockSpec& b : c.blocks) b.fixed = b.box->at(0).z < 0.05;
  const auto drifts = [](const Outcome<Rows>& r) {
    std::vector<double> all;
    for (const solver::AssessmentRow& row : r.out.rows) all.push_back(row.drift);
    return all;
  };
  const std::vector<double> here = drifts(run(c));
  REQUIRE(here.size() > 100);
  for (cases::BlockSpec& b : c.blocks)
    for (Vec3& corner : *b.box) corner.z -= 64.0;
  const std::vector<double> below = drifts(run(c));
  REQUIRE(below.size() == here.size());
  for (std::size_t i = 0; i < here.size(); ++i) CHECK(below[i] == doctest::Approx(here[i]).epsilon(1e-6));
}

TEST_CASE("an analysis ends once the base shear has dropped, not at its longest") {
  cases::Case c = pushed_wall(cases::AnalysisKind::pushover);
  c.analysis.longest = 20.0;
  const Outcome<Rows> r = run(c);
  CHECK(r.out.rows.back().over == 1.0);
  CHECK(r.out.rows.back().time < 19.0);
  CHECK(r.out.rows.back().time == r.out.energies.back().time);
}

TEST_CASE("a load with a history is the force that its file holds, up and down") {
  cases::Case steady = small_wall(3, 4), over_time = steady;
  cases::Load load;
  load.block = "c3_1", load.force = {0.0, 20.0, 0.0};
  steady.loads.push_back(load);
  load.force = {}, load.history = "push.csv";
  over_time.loads.push_back(load);
  const auto end_of = [](const cases::Case& c, const std::vector<double>& time, const std::vector<Vec3>& force) {
    cases::Model m = cases::build_model(c);
    if (!m.support_motions.empty()) m.support_motions[0].time = time, m.support_motions[0].displacement = force;
    solver::Simulation sim(c, m, {}, {});
    sim.start_shaking();
    for (int i = 0; i < 400; ++i) sim.step({.sample = false, .ledger = i % 100 == 0});
    CHECK(sim.worst_residual() < 1e-3);
    return solver::state_hash(sim.world());
  };
  const std::uint64_t as_steady = end_of(steady, {}, {});
  CHECK(end_of(over_time, {-1.0, 100.0}, {{0.0, 20.0, 0.0}, {0.0, 20.0, 0.0}}) == as_steady);
  CHECK(end_of(over_time, {0.0, 0.01, 0.02}, {{}, {0.0, 40.0, 0.0}, {0.0, -40.0, 0.0}}) != as_steady);
}

TEST_CASE("a load that moves acts where its path is: one that stands still as a steady load there, one that goes on elsewhere") {
  cases::Case steady = small_wall(3, 4), moving = steady;
  cases::Load load;
  load.force = {0.0, 0.0, -200.0}, load.at = {0.35, 0.05, 1.0};
  steady.loads.push_back(load);
  load.at.reset(), load.path = "way.csv";
  moving.loads.push_back(load);
  const auto end_of = [](const cases::Case& c, Vec3 from, Vec3 to) {
    cases::Model m = cases::build_model(c);
    if (!m.support_motions.empty()) m.support_motions[0].time = {0.0, 0.02}, m.support_motions[0].displacement = {from, to};
    solver::Simulation sim(c, m, {}, {});
    sim.start_shaking();
    while (sim.time() < 0.02) sim.step({.sample = false, .ledger = sim.steps() % 100 == 0});
    CHECK(sim.worst_residual() < 1e-3);
    return sim.world().elements.uz;
  };
  const Vec3 at = *steady.loads[0].at;
  const auto there = end_of(steady, {}, {}), still = end_of(moving, at, at), elsewhere = end_of(moving, {0.05, 0.05, 1.0}, at);
  double most = 0.0, apart = 0.0, far = 0.0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    most = std::max(most, std::abs(there[i])), apart = std::max(apart, std::abs(still[i] - there[i]));
    far = std::max(far, std::abs(elsewhere[i] - there[i]));
  }
  CHECK(apart < 1e-9 * most);
  CHECK(far > 1e-3 * most);
}

TEST_CASE("a dead load keeps its direction, a follower turns with its block") {
  for (const bool follows : {false, true}) {
    cases::Case c = small_wall(1, 1);
    c.base.reset();
    c.gravity.acceleration = {};
    c.damping = {};
    c.blocks.resize(1);
    c.blocks[0].free = true;
    c.blocks[0].angular_velocity = {0.0, 0.0, 10.0};
    cases::Load load;
    load.block = c.blocks[0].name, load.force = {100.0, 0.0, 0.0}, load.follows = follows;
    c.loads.push_back(load);
    const cases::Model m = cases::build_model(c);
    solver::Options o;
    o.step = 1e-4;
    solver::Simulation sim(c, m, {}, o);
    sim.start_shaking();
    for (int i = 0; i < 1000; ++i) sim.step({});
    // A force that turns at 10 rad/s: v_y = F/(m ω) (1 − cos ωt).
    const double mass = sim.world().elements.mass[0], expected = follows ? 100.0 / (mass * 10.0) * (1.0 - std::cos(1.0)) : 0.0;
    CHECK(sim.world().elements.vy[0] == doctest::Approx(expected).epsilon(2e-3));
  }
}

TEST_CASE("the spring through which the forces act makes no swing grow, however stiff it is") {
  for (const double share : {0.1, 1.0, 20.0}) {
    cases::Case c = small_wall(3, 4, 1e6);  // nothing breaks
    c.gravity.settle = true, c.gravity.ramp = 0.1, c.gravity.settle_limit = 0.1;
    c.output.ledger_interval = 0.001;
    c.analysis.kind = cases::AnalysisKind::pushover;
    c.analysis.direction = {0.0, 1.0};
    c.analysis.share = share;
    c.analysis.pace = 2.0;
    c.analysis.damping = 0.0;
    c.analysis.longest = 0.5;
    const Rows out = run(c).out;
    // The elastic wall's answer: the compliance that the modes have foretold, with vibrations about it that stay as the start made them.
    double early = 0.0, late = 0.0;
    for (const solver::AssessmentRow& r : out.rows) {
      const double off = std::abs(r.moved - out.chosen.compliance * r.factor);
      (r.time < 0.25 ? early : late) = std::max(r.time < 0.25 ? early : late, off);
    }
    const double end = out.rows.back().moved;
    CHECK(early < 0.2 * end);
    CHECK(late < 0.2 * end);
  }
}
