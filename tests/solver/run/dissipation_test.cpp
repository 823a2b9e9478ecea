// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "solver/analysis/drive.h"
#include "solver/run/run.h"
#include "tests/solver/no_rows.h"
#include "tests/solver/small_wall.h"

// What is lost stays lost, in every kind of run: no loss of the ledger ever grows smaller, and none hides what a force gives out.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

class Losses final : public testing::NoRows {
 public:
  void cracks(std::span<const solver::CrackRow> rows) override { broken += rows.size(); }
  void assessment(const solver::AssessmentRow&) override {}
  void energy(const solver::EnergyRow& row) override {
    if (row.time < 0.0) return;
    worst = std::max(worst, row.residual);
    scale = std::max({scale, std::abs(row.input), row.strain + row.contact, row.kinetic});
    for (const auto loss :
         {&solver::EnergyRow::friction, &solver::EnergyRow::fracture, &solver::EnergyRow::dashpot, &solver::EnergyRow::damping})
      gained = std::max(gained, last.*loss - row.*loss);
    last = row;
  }

  solver::EnergyRow last{};
  double scale = 0.0, gained = 0.0, worst = 0.0;  // J, of what is in play; the most by which a loss fell between two rows; residual
  std::size_t broken = 0;
};

/// What a run loses up to this time [s] under this motion.
Losses losses_of(const cases::Case& c, const cases::GroundMotion& motion = {}) {
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, motion, {});
  solver::choose_drive(sim, c);
  solver::RunState plan;
  Losses out;
  solver::run(sim, plan, c, c.end(), out, [](const solver::RunStatus&) { return true; });
  return out;
}

void check(const Losses& found) {
  CHECK(found.broken > 0);
  CHECK(found.last.friction + found.last.fracture > 0.0);
  CHECK(found.gained < 1e-6 * found.scale);  // contacts that open inside a step, THEORY (28)
  CHECK(found.worst < 1e-3);
}

cases::Case slowly(cases::Case c, cases::AnalysisKind kind, double longest) {
  c.gravity.settle = true, c.gravity.ramp = 0.1, c.gravity.settle_limit = 0.1;
  c.output.ledger_interval = 0.001;
  c.analysis.kind = kind;
  c.analysis.direction = {0.0, 1.0};
  c.analysis.pace = 0.3;
  c.analysis.longest = longest;
  c.analysis.drop = 0.9;
  return c;
}

cases::Case shaken(cases::Case c) {
  c.output.ledger_interval = 0.001;
  c.time.duration = 0.4;
  return c;
}

void tie(cases::Case& c) {
  c.ties.push_back({.name = "rod", .from = {0.0, 0.05, 0.35}, .to = {0.6, 0.05, 0.35}, .area = 1e-5, .young = 2e11});
  c.ties.back().pretension = 100.0;
}

}  // namespace

TEST_CASE("no loss of the ledger ever falls: pushed, tilted, cycled, settled, shaken, with ties and at several rates") {
  using enum cases::AnalysisKind;
  SUBCASE("pushed, with a rod") {
    cases::Case c = slowly(small_wall(3, 4), pushover, 0.8);
    tie(c);
    check(losses_of(c));
  }
  SUBCASE("pushed, with points on the rims") {
    cases::Case c = slowly(small_wall(3, 4), pushover, 0.8);
    c.segment_rule = geometry::SegmentRule::rim;
    check(losses_of(c));
  }
  SUBCASE("tilted") { check(losses_of(slowly(small_wall(3, 4), tilt, 0.8))); }
  SUBCASE("cycled") {
    cases::Case c = slowly(small_wall(3, 4), cyclic, 0.6);
    c.analysis.amplitudes = {2e-4, 5e-4};
    cases::Load load;
    load.block = "c3_1", load.force = {100.0, 0.0, 0.0}, load.grows = true;
    c.loads.push_back(load);
    check(losses_of(c));
  }
  SUBCASE("settled") {
    cases::Case c = slowly(small_wall(3, 4), settlement, 0.6);
    c.base->z = -0.1;
    for (int i = 0; i < 2; ++i) {
      cases::BasePart& part = c.base->parts.emplace_back();
      part.x = {0.3 * i, 0.3 * (i + 1)}, part.y = {-0.1, 0.2}, part.level = 0.1;
      if (i == 1) part.motion.emplace().velocity = Vec3{0.0, 0.0, -0.01};
    }
    check(losses_of(c));
  }
  SUBCASE("shaken, at several rates") {
    cases::Case c = shaken(mixed_wall(3, 5));
    c.time.multirate = 4;
    check(losses_of(c, strong_shaking()));
  }
}
