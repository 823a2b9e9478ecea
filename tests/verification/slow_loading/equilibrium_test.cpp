// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/limit_analysis.h"
#include "tests/verification/slow_loading/assessment.h"
#include "tests/verification/structures/arch.h"

// V15 at rest: states of rest (analysis.solver = "equilibrium") against closed forms and limit analysis of the same blocks and contact points.
namespace voussoir::testing {
namespace {

using cases::AnalysisKind;

constexpr double kWithin = 5e-3;

cases::Case at_rest(cases::Case c, AnalysisKind kind, double x, double y) {
  c.analysis.kind = kind, c.analysis.solver = cases::Solver::equilibrium;
  c.analysis.direction = {x, y};
  c.analysis.drop = 0.05;  // until the peak is sure, and no longer
  c.motion.reset();
  if (c.base) c.base->tilt = {0.0, 0.0};
  c.gravity.acceleration = {0.0, 0.0, -kGravity};
  return c;
}

std::string label_of(const std::string& what, const cases::Case& c) {
  return "V15 at rest: " + std::string(c.analysis.kind == AnalysisKind::tilt ? "tilt" : "pushover") + " of " + what;
}

void compare(const std::string& what, const cases::Case& c, double expected) {
  const io::Capacity got = assess(c);
  expect_near(label_of(what, c) + ": multiplier", got.multiplier_at_rest, expected, kWithin);
  expect_below(label_of(what, c) + ": largest unbalanced force over the mean weight", got.unbalanced, c.analysis.tolerance);
}

constexpr double kHeight = 0.8, kWidth = 0.2 * (1.0 - 1.0 / 8.0);  // m, of the block of tilt.toml; between its outer points

}  // namespace

TEST_CASE("V15 at rest: a stiff block tilts and is pushed until it topples") {
  for (const AnalysisKind kind : {AnalysisKind::tilt, AnalysisKind::pushover})
    compare("a block, n = 8", at_rest(load("tilt").value, kind, 1.0, 0.0), kWidth / kHeight);
}

TEST_CASE("V15 at rest: a block slides at the tangent of its angle of friction") {
  cases::Case c = at_rest(load("tilt").value, AnalysisKind::pushover, 1.0, 0.0);
  c.contact.friction = 10.0;
  c.analysis.largest_drift = 0.01;
  compare("a block that slides", c, std::tan(radians(10.0)));
}

TEST_CASE("V15 at rest: a rocking block bears less and less, and nothing once its centroid is above its edge") {
  cases::Case c = at_rest(load("tilt").value, AnalysisKind::pushover, 1.0, 0.0);
  c.analysis.drop = 0.98, c.analysis.largest_drift = 0.3;
  AssessmentRows rows;
  const io::Capacity got = assess(c, &rows);
  const io::CapacityCurve& r = rows.curve;
  // About its outer points: tan(a − θ), with the centroid b/2 (1 − cos θ) + h/2 sin θ to the side.
  const double slope = std::atan(kWidth / kHeight), radius = 0.5 * std::hypot(kWidth, kHeight);
  double off = 0.0;
  for (std::size_t i = 0; i < r.time.size(); ++i) {
    if (r.displacement[i] < 0.02 * kWidth) continue;
    const double turned = slope - std::asin((0.5 * kWidth - r.displacement[i]) / radius);
    off = std::max(off, std::abs(r.factor[i] - std::tan(slope - turned)));
  }
  const std::string label = label_of("a rocking block", c);
  expect_below(label + ": largest distance from the post-peak line, over the peak", off / got.multiplier_at_rest, kWithin);
  REQUIRE(r.factor.back() < 0.0);
  const std::size_t n = r.factor.size();
  const double share = r.factor[n - 2] / (r.factor[n - 2] - r.factor[n - 1]);
  const double zero = r.displacement[n - 2] + share * (r.displacement[n - 1] - r.displacement[n - 2]);
  expect_near(label + ": displacement of the centroid at which the force is zero [m]", zero, 0.5 * kWidth, kWithin);
}

TEST_CASE("V15 at rest: a parapet is pushed") {
  cases::Case c = at_rest(load("parapet").value, AnalysisKind::pushover, 0.0, 1.0);
  for (auto& [name, m] : c.materials) m.young *= 100.0;  // rigid blocks have no second order
  for (auto& [name, l] : c.joint_laws) l.young *= 100.0;
  compare("a parapet, n = 4", c, 0.1 / 0.6 * (1.0 - 1.0 / 4.0));
}

TEST_CASE("V15 at rest: an arch") {
  const Arch arch{.thickness = 0.15 / (1.0 - 1.0 / 4.0) * 1.5};
  cases::Case c = load("arch_stands").value;
  arch.shape(c);
  compare("an arch", at_rest(c, AnalysisKind::pushover, 0.0, 1.0), collapse_factors(c, 60.0, {0.0, 1.0, 0.0}).associated);
}

TEST_CASE("V15 at rest: a dry wall over an opening with an arch and no lintel tilts in its plane") {
  const cases::Case c = at_rest(load("arched_wall").value, AnalysisKind::tilt, 1.0, 0.0);
  compare("a wall over an arch", c, collapse_factors(c, c.contact.friction, {1.0, 0.0, 0.0}).coulomb);
}

}  // namespace voussoir::testing
