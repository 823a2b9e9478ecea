// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "cases/model.h"
#include "solver/analysis/drive.h"
#include "solver/run/run.h"
#include "solver/run/simulation.h"
#include "solver/state/saved_state.h"
#include "tests/solver/no_rows.h"

// analysis.kind = "rest": THEORY.md, sections 11 and 13.

using namespace voussoir;

namespace {

constexpr double kFriction = 30.0;  // degrees

/// A box on a fixed one.
cases::Case two_boxes() {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e8, 0.2};
  c.contact.friction = kFriction;
  c.analysis.kind = cases::AnalysisKind::rest;
  const Vec3 boxes[][2] = {{{0.0, 0.0, -0.2}, {1.0, 0.4, 0.0}}, {{0.3, 0.1, 0.0}, {0.6, 0.3, 0.1}}};
  for (int i = 0; i < 2; ++i) {
    cases::BlockSpec b;
    b.name = std::to_string(i), b.material = "stone", b.box = {{boxes[i][0], boxes[i][1]}}, b.fixed = i == 0;
    c.blocks.push_back(b);
  }
  return c;
}

double weight(const cases::Case& c) { return 0.3 * 0.2 * 0.1 * 2000.0 * norm(c.gravity.acceleration); }

struct Outcome {
  std::vector<double> factor, over, moved;
};

class RestRows final : public testing::NoRows {
 public:
  void assessment(const solver::AssessmentRow& r) override {
    if (r.over == 2.0) return;
    out.factor.push_back(r.factor), out.over.push_back(r.over), out.moved.push_back(r.support_moved);
  }
  Outcome out;
};

/// \param stops  steps at which the run is saved, and gone on with in a new simulation
Outcome outcome(const cases::Case& c, std::vector<std::int64_t> stops = {}) {
  const cases::Model m = cases::build_model(c);
  RestRows rows;
  solver::SavedState saved;
  for (int leg = 0;; ++leg) {
    solver::Simulation sim(c, m, {}, {});
    solver::RunState plan;
    leg == 0 ? solver::choose_drive(sim, c) : solver::restore(sim, plan, saved);
    const auto go_on = [&](const solver::RunStatus& s) {
      if (stops.empty() || s.step < stops.front()) return true;
      stops.erase(stops.begin());
      return false;
    };
    const solver::RunResult r = solver::run(sim, plan, c, c.end(), rows, go_on);
    saved = solver::save(sim, plan);
    if (!r.stopped) break;
  }
  REQUIRE(!rows.out.factor.empty());
  return rows.out;
}

cases::Load push(Vec3 force) {
  cases::Load load;
  load.block = "1", load.force = force, load.at = Vec3{0.45, 0.2, 0.005}, load.grows = true;
  return load;
}

}  // namespace

TEST_CASE("rest: under weights alone there is one state") {
  const Outcome o = outcome(two_boxes());
  CHECK(o.factor == std::vector<double>{0.0});
  CHECK(o.over == std::vector<double>{1.0});
  CHECK(outcome(two_boxes(), {200}).factor == o.factor);  // all of its state is finite
}

TEST_CASE("rest: loads that friction holds are all on at the end, and of others so much as it holds") {
  cases::Case c = two_boxes();
  const double most = std::tan(kFriction * std::numbers::pi / 180.0) * weight(c);
  c.loads = {push({0.9 * most, 0.0, 0.0})};
  const Outcome stands = outcome(c);
  CHECK(stands.factor.back() == doctest::Approx(1.0).epsilon(1e-12));
  CHECK(stands.over.back() == 1.0);
  c.loads = {push({0.0, 1.6 * most, 0.0})};
  const Outcome slides = outcome(c);
  CHECK(slides.factor.back() < 1.0 / 1.6 + 1e-3);
  CHECK(slides.factor.back() > 0.97 / 1.6);
  CHECK(slides.over.back() == 0.0);
}

TEST_CASE("rest: loads and ways of supports go on in proportion") {
  cases::Case c = two_boxes();
  c.loads = {push({0.3 * weight(c), 0.0, 0.0})};
  c.blocks[0].motion = cases::SupportMotion{.to = Vec3{0.0, 0.0, -0.02}};
  const Outcome o = outcome(c);
  CHECK(o.over.back() == 1.0);
  const Outcome stopped = outcome(c, {200, 1500, 4000});
  CHECK(stopped.factor == o.factor);
  CHECK(stopped.moved == o.moved);
  for (std::size_t i = 0; i < o.factor.size(); ++i) CHECK(o.moved[i] == doctest::Approx(0.02 * o.factor[i]).epsilon(1e-6));
}

TEST_CASE("rest: what has come to full rest can be saved and gone on with") {
  cases::Case c = two_boxes();
  c.analysis.tolerance = 1e-15;  // never reached, so that it relaxes on and on
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  solver::choose_drive(sim, c);
  for (int i = 0; i < 20000; ++i) sim.step({});
  solver::RunState plan;
  const solver::SavedState saved = solver::save(sim, plan);
  solver::Simulation other(c, m, {}, {});
  CHECK_NOTHROW(solver::restore(other, plan, saved));
}
