// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/drive.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases/model.h"
#include "solver/analysis/modes.h"
#include "solver/setup/setup.h"
#include "tests/cases/paper_house.h"

// What an analysis chooses for its spring, against the formulas of THEORY.md, section 11.

using namespace voussoir;

namespace {

constexpr double kWide = 0.4, kThin = 0.1, kHigh = 0.2;  // m, of an element
constexpr double kGravity = 9.8;

/// A pier of so many blocks, weak along y.
cases::Case pier(int elements, cases::LoadPattern pattern) {
  cases::Case c = testing::stack_of_blocks(elements, {kWide, kThin, kHigh});
  c.gravity.acceleration = {0.0, 0.0, -kGravity};
  c.analysis.kind = cases::AnalysisKind::pushover, c.analysis.solver = cases::Solver::dynamics;
  c.analysis.pattern = pattern;
  c.analysis.direction = {1.0, 0.0};
  return c;
}

struct Chosen {
  solver::Drive drive;
  double dt = 0.0;  // s
};
Chosen chosen(const cases::Case& c) {
  const cases::Model model = cases::build_model(c);
  solver::Simulation sim(c, model, {}, {});
  solver::choose_drive(sim, c);
  return {sim.program().drive(), sim.world().dt};
}

cases::Load push(const std::string& block, Vec3 force, Vec3 moment = {}) {
  cases::Load load;
  load.block = block, load.force = force, load.moment = moment, load.grows = true;
  return load;
}

}  // namespace

TEST_CASE("drive: the compliance of a push by a mode is that of the mode whose shape it has, not of the lowest") {
  const cases::Case c = pier(5, cases::LoadPattern::mode);
  const cases::Model model = cases::build_model(c);
  const std::vector<solver::Mode> modes = solver::natural_modes(*solver::build_world(c, model, {}), 12, solver::DryJoints::closed);
  const solver::Mode& along = *std::ranges::max_element(modes, {}, [](const solver::Mode& m) { return m.mass_share.x; });
  REQUIRE(along.frequency > 2.0 * modes.front().frequency);
  // Blocks of one mass: shapes by their mean.
  double sum = 0.0, squares = 0.0;
  for (const Vec3& u : along.displacement) sum += u.x, squares += dot(u, u);
  const double n = static_cast<double>(along.displacement.size()), omega = 2.0 * std::numbers::pi * along.frequency;
  const solver::Drive d = chosen(c).drive;
  CHECK(d.frequency == doctest::Approx(modes.front().frequency));
  CHECK(d.compliance == doctest::Approx(kGravity * squares * n / (sum * sum) / (omega * omega)).epsilon(1e-6));
}

TEST_CASE("drive: the step bears the spring of loads with an arm and a moment, and of two on one block") {
  const double mass = 1800.0 * kWide * kThin * kHigh, about_x = mass * (kThin * kThin + kHigh * kHigh) / 12.0,
               about_y = mass * (kWide * kWide + kHigh * kHigh) / 12.0;
  cases::Case c = pier(2, cases::LoadPattern::given);
  c.analysis.share = 1e9;  // so stiff that the step decides
  c.loads = {push("block1", {30.0, 0.0, 0.0}, {7.0, 0.0, 0.0}), push("block1", {10.0, 0.0, 0.0})};
  c.loads[0].at = Vec3{0.5 * kWide, 0.5 * kThin, 2.0 * kHigh};
  const double square = 40.0 * 40.0 / mass + 7.0 * 7.0 / about_x + std::pow(30.0 * 0.5 * kHigh, 2) / about_y;
  const Chosen r = chosen(c);
  CHECK(r.drive.weight == doctest::Approx(40.0));
  CHECK(r.drive.stiffness * square / r.drive.weight == doctest::Approx(2e-3 * 4.0 / (r.dt * r.dt)).epsilon(1e-9));
}

TEST_CASE("drive: a moment that grows by itself counts as a force at the top with that moment about the foot") {
  cases::Case c = pier(5, cases::LoadPattern::given);
  c.loads = {push("block4", {}, {0.0, 30.0, 0.0})};
  const solver::Drive by_moment = chosen(c).drive;
  CHECK(by_moment.weight == doctest::Approx(30.0 / (5 * kHigh)).epsilon(1e-12));
  CHECK(std::isfinite(by_moment.stiffness));
  CHECK(by_moment.stiffness > 0.0);
  CHECK(by_moment.compliance > 0.0);
  CHECK(by_moment.first > 0.0);
  c.loads.push_back(push("block4", {7.0, 0.0, 0.0}));
  CHECK(chosen(c).drive.weight == doctest::Approx(30.0 / (5 * kHigh) + 7.0).epsilon(1e-12));
}

TEST_CASE("drive: the rotations of blocks that are kept level are no modes, however many there are") {
  const auto frequency = [](int piers) {
    cases::Case c = pier(3, cases::LoadPattern::given);
    c.analysis.level = true;
    const std::vector<cases::BlockSpec> one = c.blocks;
    c.loads = {push(one.back().name, {10.0, 0.0, 0.0})};
    for (int k = 1; k < piers; ++k) {
      for (cases::BlockSpec b : one) {
        b.name += " of " + std::to_string(k);
        for (Vec3& corner : *b.box) corner.x += 2.0 * k;
        c.blocks.push_back(b);
      }
      c.loads.push_back(push(c.blocks.back().name, {10.0, 0.0, 0.0}));
    }
    return chosen(c).drive.frequency;
  };
  const double one = frequency(1);
  CHECK(one != doctest::Approx(10.0));  // what is taken where there is no mode at all
  CHECK(frequency(6) == doctest::Approx(one).epsilon(1e-6));
}
