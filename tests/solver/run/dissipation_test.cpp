// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/segments/torsion.h"
#include "solver/analysis/drive.h"
#include "solver/contact/contact_forces.h"
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

TEST_CASE("what a bond gives back as its faces part is the work of its force, with the stiffness against a twist that it has") {
  constexpr double kTurn = 1e-5, kSpin = 0.3;  // rad, rad/s, about the normal
  for (const geometry::Torsion torsion : {geometry::Torsion::paper, geometry::Torsion::solid}) {
    CAPTURE(static_cast<int>(torsion));
    cases::Case c = small_wall(1, 1);
    c.segment_torsion = torsion, c.segment_rule = geometry::SegmentRule::rim;  // rim: exact second moments
    c.blocks.push_back(brick(1, 0, 0.0, 0.2));
    c.blocks.front().fixed = true;
    const cases::Model m = cases::build_model(c);
    const auto torn = [&](double spin) {  // J
      solver::Simulation sim(c, m, {}, {});
      solver::World& w = sim.world();
      const double rows[2][2] = {{std::cos(kTurn) - 1.0, -std::sin(kTurn)}, {std::sin(kTurn), std::cos(kTurn) - 1.0}};
      double* pose = w.elements.pose.data() + kernels::kPoseStride;
      pose[0] = rows[0][0], pose[1] = rows[0][1], pose[4] = rows[1][0], pose[5] = rows[1][1], pose[11] = 1e-9;  // a little apart
      w.elements.twist[kernels::kTwistStride + 5] = spin;
      std::int32_t side = 0;
      while (w.sides.joint[static_cast<std::size_t>(side)] < 0 || w.sides.side(side).on_base) ++side;
      const double stiffness = w.sides.side(side).k.ks;
      solver::retire_side(w, side);
      return w.sides.fracture[static_cast<std::size_t>(side)] / (sim.dt() * stiffness);
    };
    const auto joint = std::ranges::find_if(m.assembly.joints, [](const geometry::Joint& j) { return j.element_b != geometry::kBase; });
    const geometry::JointTorsion all = nth(geometry::joint_torsion(m.assembly), joint - m.assembly.joints.begin());
    const double constant = torsion == geometry::Torsion::solid ? all.solid : all.polar;
    CHECK((torn(kSpin) - torn(-kSpin)) / (constant * kTurn * kSpin) == doctest::Approx(1.0).epsilon(1e-4));
  }
}
