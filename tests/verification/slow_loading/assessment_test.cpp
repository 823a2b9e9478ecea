// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/slow_loading/assessment.h"

#include <string>

#include "tests/verification/limit_analysis.h"
#include "tests/verification/structures/arch.h"

// V15: quasi-static analyses against closed forms and limit analysis of the same blocks and contact points.
namespace voussoir::testing {
namespace {

using cases::AnalysisKind;

constexpr double kWithin = 1e-2;
constexpr double kShortestPace = 2.0;  // s

cases::Case analysed(cases::Case c, AnalysisKind kind, double x, double y) {
  c.analysis.kind = kind, c.analysis.solver = cases::Solver::dynamics;
  c.analysis.direction = {x, y};
  c.motion.reset();
  if (c.base) c.base->tilt = {0.0, 0.0};
  c.gravity.acceleration = {0.0, 0.0, -kGravity};
  return c;
}

const char* word(AnalysisKind kind) { return kind == AnalysisKind::tilt ? "tilt" : "pushover"; }

std::string label_of(const std::string& what, const cases::Case& c) { return "V15 " + std::string(word(c.analysis.kind)) + " of " + what; }

/// The multiplier.
double compare_once(const std::string& what, const cases::Case& c, double expected) {
  const io::Capacity got = assess(c);
  expect_near(label_of(what, c) + ": multiplier", got.multiplier_at_rest, expected, kWithin);
  expect_below(label_of(what, c) + ": share of the work that went into motion", std::abs(got.motion_share), kWithin);
  return got.multiplier_at_rest;
}

/// The multiplier, and that at half the rate, of structures whose pace is the shortest.
void compare(const std::string& what, cases::Case c, double expected) {
  const double whole = compare_once(what, c, expected);
  c.analysis.pace = 2.0 * kShortestPace;
  expect_near(label_of(what, c) + ": multiplier at half the rate, over that at the whole", assess(c).multiplier_at_rest / whole, 1.0,
              kWithin);
}

/// Until the peak is sure, and no longer.
cases::Case short_of(cases::Case c) {
  c.analysis.drop = 0.05;
  return c;
}

constexpr double kBlock = 0.25;  // b / h

}  // namespace

TEST_CASE("V15: a stiff block tilts and is pushed until it topples") {
  for (const AnalysisKind kind : {AnalysisKind::tilt, AnalysisKind::pushover}) {
    const cases::Case c = short_of(analysed(load("tilt").value, kind, 1.0, 0.0));
    compare("a block, n = 8", c, kBlock * (1.0 - 1.0 / 8.0));
  }
}

TEST_CASE("V15: a stiff block, points to the rim" * doctest::skip()) {
  cases::Case c = short_of(analysed(load("tilt").value, AnalysisKind::tilt, 1.0, 0.0));
  c.segment_rule = geometry::SegmentRule::rim;
  compare("a block, rim", c, kBlock);
}

namespace {

cases::Case parapet(AnalysisKind kind) {
  cases::Case c = short_of(analysed(load("parapet").value, kind, 0.0, 1.0));
  for (auto& [name, m] : c.materials) m.young *= 100.0;  // rigid blocks have no second order
  for (auto& [name, l] : c.joint_laws) l.young *= 100.0;
  return c;
}
constexpr double kParapet = 0.1 / 0.6 * (1.0 - 1.0 / 4.0);  // t (1 - 1/n) / h

}  // namespace

TEST_CASE("V15: a parapet is pushed") { compare_once("a parapet, n = 4", parapet(AnalysisKind::pushover), kParapet); }

TEST_CASE("V15: a parapet, and at half the rate" * doctest::skip()) {
  for (const AnalysisKind kind : {AnalysisKind::tilt, AnalysisKind::pushover}) compare("a parapet, n = 4", parapet(kind), kParapet);
}

TEST_CASE("V15: a dry wall over an opening with an arch and no lintel tilts in its plane") {
  const cases::Case c = short_of(analysed(load("arched_wall").value, AnalysisKind::tilt, 1.0, 0.0));
  compare_once("a wall over an arch", c, collapse_factors(c, c.contact.friction, {1.0, 0.0, 0.0}).coulomb);
}

TEST_CASE("V15: an arch" * doctest::skip()) {
  const Arch arch{.thickness = 0.15 / (1.0 - 1.0 / 4.0) * 1.5};
  cases::Case c = load("arch_stands").value;
  arch.shape(c);
  const double expected = collapse_factors(c, 60.0, {0.0, 1.0, 0.0}).associated;
  for (const AnalysisKind kind : {AnalysisKind::tilt, AnalysisKind::pushover})
    compare("an arch", short_of(analysed(c, kind, 0.0, 1.0)), expected);
}

namespace {

/// A dry façade of two storeys with an opening in each: two piers of three blocks, 0.4 m wide and 1.2 m high, under a lintel of stone over
/// the whole length. The lower storey sways: all its piers rock, so the multiplier is 0.4 (1 - 1/4) / 1.2.
cases::Case facade() {
  cases::Case c = load("tilt").value;
  c.blocks.clear();
  c.base->tilt = {0.0, 0.0};
  c.segment_size = 0.1;
  const auto add = [&](double x0, double x1, double z0, double z1) {
    cases::BlockSpec b;
    b.name = "b" + std::to_string(c.blocks.size());
    b.material = "stone";
    b.box = {{Vec3{x0, 0.0, z0}, Vec3{x1, 0.2, z1}}};
    c.blocks.push_back(b);
  };
  for (const double z : {0.0, 1.6}) {
    for (const double course : {0.0, 0.4, 0.8}) {
      add(0.0, 0.4, z + course, z + course + 0.4);
      add(1.6, 2.0, z + course, z + course + 0.4);
    }
    add(0.0, 2.0, z + 1.2, z + 1.6);
  }
  return c;
}

}  // namespace

TEST_CASE("V15: a façade of two storeys" * doctest::skip()) {
  const cases::Case c = facade();
  const double expected = collapse_factors(c, 60.0, {1.0, 0.0, 0.0}).associated;
  for (const AnalysisKind kind : {AnalysisKind::tilt, AnalysisKind::pushover})
    compare("a façade of two storeys", short_of(analysed(c, kind, 1.0, 0.0)), expected);
}

namespace {

/// A barrel vault on two buttresses of four blocks each, in the plane (y, z); the buttresses are wider than the vault is thick.
cases::Case buttressed_vault() {
  const Arch vault{.radius = 1.5, .thickness = 0.3, .voussoirs = 13, .points = 4};
  constexpr double kCourse = 0.4, kWidth = 0.75;  // ten segments, four of them under the vault
  constexpr int kCourses = 4;
  cases::Case c = load("tilt").value;
  c.blocks.clear();
  c.base->tilt = {0.0, 0.0};
  c.segment_size = vault.thickness / vault.points;
  const auto add = [&] {
    cases::BlockSpec b;
    b.name = "b" + std::to_string(c.blocks.size());
    b.material = "stone";
    return b;
  };
  for (const double side : {-1.0, 1.0}) {
    const double inside = side * (vault.radius - 0.5 * vault.thickness), outside = inside + side * kWidth;
    for (int i = 0; i < kCourses; ++i) {
      cases::BlockSpec b = add();
      b.box = {{Vec3{0.0, std::min(inside, outside), kCourse * i}, Vec3{0.2, std::max(inside, outside), kCourse * (i + 1)}}};
      c.blocks.push_back(b);
    }
  }
  for (int i = 0; i < vault.voussoirs; ++i) {
    cases::BlockSpec b = add();
    for (const Point p : vault.section(i)) b.polygon.push_back({p.y, p.z + kCourses * kCourse});
    b.extrude = {0.0, 0.2};
    c.blocks.push_back(b);
  }
  return c;
}

}  // namespace

TEST_CASE("V15: a buttressed vault" * doctest::skip()) {
  cases::Case c = buttressed_vault();
  c.materials.at("stone").young *= 10.0;  // rigid blocks have no second order
  const double expected = collapse_factors(c, 60.0, {0.0, 1.0, 0.0}).associated;
  for (const AnalysisKind kind : {AnalysisKind::tilt, AnalysisKind::pushover})
    compare("a buttressed vault", short_of(analysed(c, kind, 0.0, 1.0)), expected);
}

TEST_CASE("V15: supports of an arch part slowly until it falls" * doctest::skip()) {
  cases::Case c = load("arch_spreads").value;
  c.analysis.kind = AnalysisKind::settlement, c.analysis.solver = cases::Solver::dynamics;
  c.damping = {};
  const std::string label = "V15 settlement of an arch: movement of a support at which it falls";
  const double movement = assess(c).collapse_movement;
  // Each support moves by half of the spread; the expected one is that of spreading_arch_test.cpp.
  expect_near(label + " [m]", movement, 0.5 * 0.403656, kWithin);
  c.analysis.pace = 2.0 * kShortestPace;
  expect_near(label + ", at half the rate over that at the whole", assess(c).collapse_movement / movement, 1.0, kWithin);
}

namespace {

constexpr double kHalfWidth = 0.2, kThickness = 0.1;  // m

/// A slab on its dry foot, drawn to and fro by a force at its centre.
cases::Case drawn_slab() {
  cases::Case c = analysed(load("tilt").value, AnalysisKind::cyclic, 1.0, 0.0);
  c.materials.at("stone").young /= 100.0;
  c.contact.friction = 32.0;
  c.blocks.at(0).box = {{{-kHalfWidth, -kHalfWidth, 0.0}, {kHalfWidth, kHalfWidth, kThickness}}};
  cases::Load actuator;
  actuator.block = c.blocks.at(0).name, actuator.force = {100.0, 0.0, 0.0}, actuator.grows = true;
  c.loads.push_back(actuator);
  c.analysis.amplitudes = {2e-4}, c.analysis.cycles = 2;
  c.output.ledger_interval = 0.001;
  return c;
}

}  // namespace

// The second loop begins and ends as the same state slides: all that its force puts in is lost.
TEST_CASE("V15: the closed loop of a slab that slides to and fro") {
  const cases::Case c = drawn_slab();
  AssessmentRows rows;
  const io::Capacity got = assess(c, &rows);
  REQUIRE(got.loops.size() == 2);
  const io::Loop& loop = got.loops[1];
  // What the foot's springs let the centre of the slab move by, m/N: in shear, and turning about the foot; (2) and (3) of THEORY.md.
  constexpr double kSide = 2.0 * kHalfWidth, kArm = 0.5 * kThickness, kArea = kSide * kSide, kPoints = 16.0;
  constexpr double kInertia = kArea * kArea / 12.0 * (1.0 - 1.0 / (kPoints * kPoints));
  const double elastic = kArm / (Adobe::shear * kArea) + kArm * kArm * kArm / (Adobe::plane * kInertia);
  const double unit = norm(c.loads[0].force), mass = Adobe::density * kArea * kThickness;
  expect_near("V15 slab to and fro: compliance by the modes [m/N]", rows.chosen.compliance / unit, elastic, 1e-3);
  // It slides at a steady speed, against friction and what little mass damping bears.
  const double speed = c.analysis.amplitudes[0] / (0.5 * rows.chosen.pace);
  const double force = mass * (std::tan(radians(32.0)) * kGravity + rows.chosen.damping * speed);
  const double area = 4.0 * force * (0.5 * (loop.most - loop.least) - elastic * force);
  expect_near("V15 slab to and fro: area of the closed loop [J]", loop.area, area, 1e-3);
  expect_near("V15 slab to and fro: what the ledger lost over that area", loop.dissipated / loop.area, 1.0, 1e-3);
  expect_below("V15 slab to and fro: stored over the loop, over its area", std::abs(loop.stored) / loop.area, 1e-3);
}

namespace {

/// Work of the case's dead load over the path of its block, from time zero [J].
double jack_work(const cases::Case& c, const std::vector<Vec3>& path) { return dot(c.loads.at(0).force, path.back() - path.front()); }

}  // namespace

TEST_CASE("V15: loops of a wall in shear and compression" * doctest::skip()) {
  for (const bool level : {false, true}) {
    for (const bool slowly : {false, true}) {
      cases::Case c = load("shear_test").value;
      if (slowly) c.analysis.solver = cases::Solver::dynamics;
      c.analysis.level = level;
      c.analysis.amplitudes = {0.001}, c.analysis.cycles = 3;
      AssessmentRows rows;
      const io::Capacity got = assess(c, &rows);
      const std::string label = std::string("V15 shear test, ") + (level ? "top held level" : "top free") + (slowly ? ", slowly" : "");
      // The jack is dead: what it gains as the beam sinks is neither lost nor in the stores. Where bonds break on the way from one state of
      // rest to the next, loads do more work than below the line between the two, and relaxation takes it away.
      const double lost_and_stored = got.dissipated + got.stored - jack_work(c, rows.path);
      const double taken = slowly ? 0.0 : got.curve.damping.back() - got.curve.damping.front();
      expect_near(
          label + ": work of the actuator over losses and stores, the jack's too" + (slowly ? "" : ", but for what relaxation takes"),
          got.loop_area / (lost_and_stored - taken), 1.0, slowly ? 1e-3 : 2e-3);
      REQUIRE(got.loops.size() == 3);
      for (const io::Loop& l : got.loops) {
        const double balance = (l.dissipated + l.stored - l.other_work) / l.area;
        expect_near(label + ": losses and stores of a loop, the jack's too, over its area", balance, 1.0, 1e-3);
      }
      CHECK(got.dissipated > 0.5 * got.loop_area);
      CHECK(got.least_factor < 0.0);
    }
  }
}

}  // namespace voussoir::testing
