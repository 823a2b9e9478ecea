// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/drive.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
  cases::Case c = testing::paper_materials();
  c.base = cases::Base{};
  for (int i = 0; i < elements; ++i) {
    cases::BlockSpec block;
    block.name = "block" + std::to_string(i), block.material = "adobe";
    block.box = {Vec3{0.0, 0.0, i * kHigh}, Vec3{kWide, kThin, (i + 1) * kHigh}};
    c.blocks.push_back(block);
  }
  c.gravity.acceleration = {0.0, 0.0, -kGravity};
  c.analysis.kind = cases::AnalysisKind::pushover;
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
