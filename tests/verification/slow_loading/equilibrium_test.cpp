// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/verification/limit_analysis.h"
#include "tests/verification/slow_loading/assessment.h"
#include "tests/verification/slow_loading/settings.h"
#include "tests/verification/structures/arch.h"

// V15 at rest: states of rest (analysis.solver = "equilibrium") against closed forms and limit analysis of the same blocks and contact
// points.
namespace voussoir::testing {
namespace {

using cases::AnalysisKind;

constexpr double kWithin = 5e-3, kEnergy = 1e-3, kChange = 1e-2;

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

/// The closed form at other settings of the search, and what they change: of the peak, and of what is borne from it down to 85 % of it.
void compare_settings(const std::string& what, cases::Case c, double expected) {
  c.analysis.drop = 0.2;
  AssessmentRows plain;
  const double peak = assess(c, &plain).multiplier_at_rest;
  for (const RestSetting& s : kRestSettings) {
    cases::Case other = c;
    other.analysis.tolerance *= s.tolerance, other.analysis.path_step *= s.path_step;
    AssessmentRows rows;
    const double got = assess(other, &rows).multiplier_at_rest;
    const std::string label = label_of(what, c) + ", " + s.words;
    const Change behind = change_behind_peak(plain.curve, rows.curve, 0.85);
    expect_near(label + ": multiplier", got, expected, kWithin);
    expect_below(label + ": change of the peak", relative_error(got, peak), kChange);
    CHECK(behind.points >= 5);
    expect_below(label + ": largest change of the force behind the peak, over the peak", behind.most, kChange);
  }
}

void compare(const std::string& what, const cases::Case& c, double expected, AssessmentRows* rows = nullptr) {
  AssessmentRows all;
  const io::Capacity got = assess(c, &all);
  expect_near(label_of(what, c) + ": multiplier", got.multiplier_at_rest, expected, kWithin);
  expect_below(label_of(what, c) + ": largest unbalanced force over the mean weight", got.unbalanced, c.analysis.tolerance);
  const io::CapacityCurve& r = all.curve;
  double off = 0.0, most = 0.0;
  for (std::size_t i = 0; i < r.input.size(); ++i) {
    const double work = r.input[i] - r.input[0], kept = r.stored[i] - r.stored[0], lost = r.losses[i] - r.losses[0];
    off = std::max(off, std::abs(work - kept - lost)), most = std::max(most, std::abs(work));
  }
  expect_below(label_of(what, c) + ": work less what is stored and lost, over the work", off / most, kEnergy);
  if (rows != nullptr) *rows = all;
}

constexpr double kHeight = 0.8, kWidth = 0.2 * (1.0 - 1.0 / 8.0);  // m, of the block of tilt.toml; between its outer points

}  // namespace

TEST_CASE("V15 at rest: a stiff block tilts and is pushed until it topples") {
  for (const AnalysisKind kind : {AnalysisKind::tilt, AnalysisKind::pushover}) {
    const cases::Case c = at_rest(load("tilt").value, kind, 1.0, 0.0);
    compare("a block, n = 8", c, kWidth / kHeight);
    compare_settings("a block, n = 8", c, kWidth / kHeight);
  }
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
  REQUIRE(r.factor.back() < 0.02 * got.multiplier_at_rest);
  const std::size_t n = r.factor.size();
  const double share = r.factor[n - 2] / (r.factor[n - 2] - r.factor[n - 1]);
  const double zero = r.displacement[n - 2] + share * (r.displacement[n - 1] - r.displacement[n - 2]);
  expect_near(label + ": displacement of the centroid at which the force is zero [m]", zero, 0.5 * kWidth, kWithin);
}

TEST_CASE("V15 at rest: a column on a soft foot that bears no tension, to its peak and beyond") {
  cases::Case c = at_rest(load("tilt").value, AnalysisKind::pushover, 1.0, 0.0);
  cases::Material& m = c.materials.at("stone");
  m.young = 8e7, m.poisson = 0.0;
  c.blocks[0].box = {{{-0.1, -0.01, 0.0}, {0.1, 0.01, 0.8}}};
  c.segment_size = 0.0025;
  c.analysis.drop = 0.3;
  const double width = 0.2, height = 0.8, depth = 0.02, stiffness = m.young / (0.5 * height), shear = 0.5 * m.young / (0.5 * height);
  const double weight = m.density * kGravity * width * height * depth, strip = std::sqrt(2.0 * weight / (stiffness * depth));
  // Turned by θ it stands on a strip of the width √(2 N/(k d θ)), with N at a third of it.
  const auto factor = [&](double turned) {
    const double lever = 0.5 * width - strip / (3.0 * std::sqrt(turned)), slope = std::tan(turned);
    return (lever - 0.5 * height * slope) / (0.5 * height + lever * slope);
  };
  double peak = 0.0, at_peak = 0.0;
  for (double turned = 0.005; turned < 0.05; turned += 1e-5) {
    if (factor(turned) > peak) peak = factor(turned), at_peak = turned;
  }
  AssessmentRows rows;
  compare("a column on a soft foot", c, peak, &rows);
  compare_settings("a column on a soft foot", c, peak);
  const io::CapacityCurve& r = rows.curve;
  double off = 0.0, farthest = 0.0;
  for (std::size_t i = 0; i < r.time.size(); ++i) {
    const double turned = (r.displacement[i] - r.factor[i] * weight / (shear * width * depth)) / (0.5 * height);
    if (turned < 0.5 * at_peak || turned > 3.0 * at_peak) continue;  // before, shear is of a strip; later bodies push, not points
    farthest = std::max(farthest, turned / at_peak), off = std::max(off, std::abs(r.factor[i] - factor(turned)));
  }
  CHECK(farthest > 2.0);
  expect_below(label_of("a column on a soft foot", c) + ": largest distance from the closed line, over the peak", off / peak, kWithin);
}

TEST_CASE("V15 at rest: a wall with a buttress turns about the foot of the buttress") {
  cases::Case c = at_rest(load("tilt").value, AnalysisKind::pushover, 1.0, 0.0);
  c.blocks[0].box = {{{0.0, 0.0, 0.0}, {0.6, 0.4, 1.0}}};
  c.blocks.push_back(c.blocks[0]);
  c.blocks[1].name = "wall", c.blocks[1].box = {{{0.0, 0.0, 1.0}, {0.4, 0.4, 1.8}}};
  c.segment_rule = geometry::SegmentRule::rim, c.segment_size.reset();
  const double expected = (0.6 * 1.0 * 0.3 + 0.4 * 0.8 * 0.4) / (0.6 * 1.0 * 0.5 + 0.4 * 0.8 * 1.4);
  compare("a wall with a buttress", c, expected);
  compare_settings("a wall with a buttress", c, expected);
}

TEST_CASE("V15 at rest: a wall that is tied back overturns once its tie yields") {
  const cases::Case c = at_rest(load("tie_wall").value, AnalysisKind::pushover, 1.0, 0.0);
  const double width = 0.3, height = 1.2, weight = 2000.0 * width * 0.6 * height * kGravity, yield = 1e8 * 1e-5;
  const double turned = yield / (2e11 * 1e-5 / 2.3), s = std::sin(turned),
               co = std::cos(turned);  // at yield; the tie is 1 m above the foot
  const double expected = (0.5 * (width * co - height * s) * weight + yield * co) / (0.5 * (height * co + width * s) * weight);
  compare("a tied wall", c, expected);
  compare_settings("a tied wall", c, expected);
}

TEST_CASE("V15 at rest: a boulder on three small stones slides at the tangent of its angle of friction") {
  // Its first loads are less than what rest leaves open: they may fall, and the analysis goes on.
  cases::Case c = at_rest(load("tilt").value, AnalysisKind::pushover, -1.0, 0.0);
  cases::Material& m = c.materials.at("stone");
  m.density = 2300.0, m.young = 5e11, m.poisson = 0.2;
  c.contact.friction = 12.24;
  c.segment_rule = geometry::SegmentRule::rim, c.segment_size.reset();
  c.blocks[0].box = {{{-1.15255, -0.17877, 0.00396}, {-0.68545, 0.25277, 0.30655}}};
  const std::array<std::array<Vec3, 2>, 3> stones{{{{{-1.06881, 0.14382, 0.0}, {-1.0606, 0.15004, 0.00396}}},
                                                   {{{-0.73504, -0.11816, 0.0}, {-0.72488, -0.1083, 0.00396}}},
                                                   {{{-1.10626, -0.08298, 0.0}, {-1.09611, -0.07131, 0.00396}}}}};
  for (const auto& box : stones) {
    cases::BlockSpec stone = c.blocks[0];
    stone.name = "stone " + std::to_string(c.blocks.size()), stone.box = box;
    c.blocks.push_back(stone);
  }
  compare("a boulder on three stones", c, std::tan(radians(12.24)));
}

TEST_CASE("V15 at rest: a parapet is pushed") {
  cases::Case c = at_rest(load("parapet").value, AnalysisKind::pushover, 0.0, 1.0);
  for (auto& [name, m] : c.materials) m.young *= 100.0;  // rigid blocks have no second order
  for (auto& [name, l] : c.joint_laws) l.young *= 100.0;
  compare("a parapet, n = 4", c, 0.1 / 0.6 * (1.0 - 1.0 / 4.0));
  compare_settings("a parapet, n = 4", c, 0.1 / 0.6 * (1.0 - 1.0 / 4.0));
}

TEST_CASE("V15 at rest: a parapet is pushed by masses times heights") {
  cases::Case c = at_rest(load("parapet").value, AnalysisKind::pushover, 0.0, 1.0);
  for (auto& [name, m] : c.materials) m.young *= 100.0;
  for (auto& [name, l] : c.joint_laws) l.young *= 100.0;
  c.analysis.pattern = cases::LoadPattern::triangular;
  double first = 0.0, second = 0.0;  // m, m2, of the heights of six equal courses
  for (int i = 0; i < 6; ++i) first += 0.05 + 0.1 * i, second += std::pow(0.05 + 0.1 * i, 2);
  compare("a parapet by a triangle, n = 4", c, 0.5 * 0.1 * (1.0 - 1.0 / 4.0) * first / second);
}

TEST_CASE("V15 at rest: of three blocks in a row the one on the side of the eccentric push topples first") {
  cases::Case c = at_rest(load("tilt").value, AnalysisKind::pushover, 1.0, 0.0);
  const cases::BlockSpec block = c.blocks.at(0);
  const Vec3 low = block.box->at(0), high = block.box->at(1);
  for (int i = 1; i < 3; ++i) {
    cases::BlockSpec next = block;
    next.name += std::to_string(i);
    next.box = {{low + Vec3{0.0, 1.0 * i, 0.0}, high + Vec3{0.0, 1.0 * i, 0.0}}};
    c.blocks.push_back(next);
  }
  // Three equal forces a metre apart: the outermost has 1 + e L/(2/3 m2) · 1 m of the mean.
  const double width = 2.0 + high.y - low.y;
  for (const double side : {0.05, -0.05}) {
    c.analysis.eccentricity = side;
    compare(side > 0.0 ? "three blocks, to the left" : "three blocks, to the right", c, kWidth / kHeight / (1.0 + 0.05 * width * 1.5));
  }
}

TEST_CASE("V15 at rest: an arch") {
  const Arch arch{.thickness = 0.15 / (1.0 - 1.0 / 4.0) * 1.5};
  cases::Case c = load("arch_stands").value;
  arch.shape(c);
  const double expected = collapse_factors(c, 60.0, {0.0, 1.0, 0.0}).associated;
  compare("an arch", at_rest(c, AnalysisKind::pushover, 0.0, 1.0), expected);
  compare_settings("an arch", at_rest(c, AnalysisKind::pushover, 0.0, 1.0), expected);
}

TEST_CASE("V15 at rest: a dry wall over an opening with an arch and no lintel tilts in its plane") {
  cases::Case c = at_rest(load("arched_wall").value, AnalysisKind::tilt, 1.0, 0.0);
  for (auto& [name, m] : c.materials) m.young *= 10.0;  // limit analysis is of rigid blocks
  compare("a wall over an arch", c, collapse_factors(c, c.contact.friction, {1.0, 0.0, 0.0}).coulomb);
}

}  // namespace voussoir::testing
