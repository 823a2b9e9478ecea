// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/capacity.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/output/measures/capacity/capacity_file.h"
#include "tests/io/results_fixture.h"

// Figures of capacity curves that can be worked out by hand.

using namespace voussoir;
using namespace voussoir::io;

namespace {

constexpr double kWeight = 1e5;  // N
constexpr double kPace = 2.0;    // s

/// Elastic up to 1 mm and 10 kN, level up to 5 mm, then falling by 3 kN a millimetre; a millimetre a second. A tenth of the work is lost by
/// damping, and the kinetic energy is a thousandth of it.
CapacityCurve trilinear(double until) {
  CapacityCurve c;
  double work = 0.0, before = 0.0;
  for (int i = 0; i <= std::lround(until * 1e5); ++i) {
    const double d = 1e-5 * i, mm = 1e3 * d;
    const double force = 1e4 * (mm < 1.0 ? mm : mm < 5.0 ? 1.0 : 1.0 - 0.3 * (mm - 5.0));
    if (i > 0) work += 0.5e-5 * (force + before);
    before = force;
    c.time.push_back(mm), c.displacement.push_back(d), c.moved.push_back(d), c.drift.push_back(d / 2.0);
    c.base_shear.push_back(force), c.factor.push_back(force / kWeight + (i == 300 ? 1e-6 : 0.0));
    c.support_moved.push_back(0.0), c.over.push_back(0.0);
    c.input.push_back(5.0 + work), c.damping.push_back(0.1 * work), c.kinetic.push_back(1e-3 * work);
    c.losses.push_back(0.1 * work), c.stored.push_back(0.9 * work);
  }
  return c;
}

}  // namespace

TEST_CASE("capacity: a curve that is elastic, level, and falls") {
  const Capacity c = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, trilinear(7e-3));
  CHECK(c.peak_shear == doctest::Approx(1e4));
  CHECK(c.first_stiffness == doctest::Approx(1e7));
  const double ultimate = 5e-3 + 0.2 / 0.3 * 1e-3;
  CHECK(c.ultimate_displacement == doctest::Approx(ultimate));
  CHECK(c.ultimate_drift == doctest::Approx(ultimate / 2.0));
  CHECK(c.ec8.force == doctest::Approx(1e4));
  CHECK(c.ec8.yield == doctest::Approx(1e-3));
  CHECK(c.ec8.ductility == doctest::Approx(ultimate / 1e-3));
  const double below = 0.5 * 1e4 * 1e-3 + 1e4 * 4e-3 + 0.5 * (1e4 + 0.8e4) * (ultimate - 5e-3);
  CHECK(c.ntc.stiffness == doctest::Approx(1e7));
  CHECK(c.ntc.force * ultimate - 0.5 * c.ntc.force * c.ntc.force / 1e7 == doctest::Approx(below));
  CHECK(c.ntc.yield == doctest::Approx(c.ntc.force / 1e7));
  CHECK(c.ntc.force < 1e4);
}

TEST_CASE("capacity: the peak of a level stretch is where it begins, whatever round-off makes of it") {
  CapacityCurve c = trilinear(7e-3);
  const Capacity level = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, c);
  CHECK(level.peak_displacement == doctest::Approx(1e-3));
  for (std::size_t i = 100; i <= 500; ++i) c.base_shear[i] *= 1.0 + 1e-9 * std::sin(7.0 * static_cast<double>(i));
  const Capacity got = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, c);
  CHECK(got.peak_displacement == level.peak_displacement);
  CHECK(got.peak_time == level.peak_time);
  CHECK(got.ec8.yield == doctest::Approx(level.ec8.yield));
}

TEST_CASE("capacity: the elastic branch of NTC goes through the curve at 0.7 of its peak, that of EC 8 has the area up to the peak") {
  CapacityCurve c = trilinear(7e-3);
  for (std::size_t i = 0; i < c.time.size(); ++i) {  // a parabola to its top at 5 mm
    const double x = c.displacement[i] / 5e-3;
    c.base_shear[i] = 1e4 * x * (2.0 - x);
  }
  const Capacity got = capacity_of(cases::AnalysisKind::pushover, 0.1, kPace, kWeight, 0.0, c);
  CHECK(got.peak_displacement == doctest::Approx(5e-3));
  CHECK(got.ntc.stiffness == doctest::Approx(0.7e4 / (5e-3 * (1.0 - std::sqrt(0.3)))).epsilon(1e-4));
  CHECK(got.ec8.yield == doctest::Approx(2.0 * (5e-3 - 5e-3 * 2.0 / 3.0)).epsilon(1e-4));
  CHECK(got.ec8.force == doctest::Approx(1e4));
}

TEST_CASE("capacity: of states of rest nothing is borne by motion, and the worst of them is told") {
  CapacityCurve c = trilinear(7e-3);
  CHECK(std::isnan(capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, c).unbalanced));
  c.unbalanced.assign(c.time.size(), 1e-5), c.unbalanced[40] = 9e-5;
  const Capacity got = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, c);
  CHECK(got.multiplier_at_rest == got.multiplier);
  CHECK(got.multiplier == 0.1 + 1e-6);
  CHECK(got.motion_share == 0.0);
  CHECK(got.kinetic_share == 0.0);
  CHECK(got.unbalanced == 9e-5);
}

TEST_CASE("capacity: a curve that turns back before its yield displacement has no ductility") {
  CapacityCurve c = trilinear(7e-3);
  const std::size_t turn = 500, rows = c.time.size();
  for (std::size_t i = turn; i < rows; ++i) {
    const double t = static_cast<double>(i - turn) / static_cast<double>(rows - 1 - turn);
    c.displacement[i] = 5e-3 - 4.9e-3 * t, c.base_shear[i] = 1e4 * (1.0 - 0.21 * t);
  }
  const Capacity got = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, c);
  REQUIRE(got.ultimate_displacement < got.ec8.yield);
  CHECK(std::isnan(got.ec8.ductility));
  CHECK(capacity_text(got).find("ductility none, the curve turns back") != std::string::npos);
}

TEST_CASE("capacity: figures of displacement are not proven where the control point has moved back") {
  CapacityCurve c = trilinear(7e-3);
  const Capacity on = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, c);
  CHECK(on.ultimate_displacement > on.peak_displacement);
  CHECK(not_proven(on).empty());
  const std::size_t turn = 500, rows = c.time.size();
  for (std::size_t i = turn; i < rows; ++i) {
    const double t = static_cast<double>(i - turn) / static_cast<double>(rows - 1 - turn);
    c.displacement[i] = 5e-3 - 4.4e-3 * t, c.base_shear[i] = 1e4 * (1.0 - 0.21 * t);
  }
  const Capacity got = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, c);
  REQUIRE(got.ultimate_displacement < got.peak_displacement);
  REQUIRE(not_proven(got).size() == 1);
  CHECK(capacity_text(got).find("not proven           the control point moves back after the peak") != std::string::npos);
  CHECK(capacity_text(got).find("set analysis.control to a part named in the mechanism\n") != std::string::npos);
}

TEST_CASE("capacity: parts that stay in place are counted, those that move are named") {
  Capacity c = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, trilinear(7e-3));
  c.mechanism = {"building, stays in place (elements: 9)", "front wall, turns out (elements: 3)",
                 "rear wall, stays in place (elements: 2)"};
  c.mechanism_at_end = {"building, stays in place (elements: 14)"};
  CHECK(capacity_text(c).find("mechanism            front wall, turns out (elements: 3); 2 parts stay in place\n") != std::string::npos);
  CHECK(
      capacity_text(c).find("mechanism at the end none: no part with 1 % of the building's mass or more has moved by 5 mm on average\n") !=
      std::string::npos);
}

TEST_CASE("capacity: of what fell before the load began the text says so") {
  Capacity c = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, trilinear(7e-3));
  CHECK(capacity_text(c).find("while gravity was put on") == std::string::npos);
  c.fallen_before = 0.505;
  CHECK(capacity_text(c).find("50.5 % of the mass fell while gravity was put on: these figures are of the state after the fall") !=
        std::string::npos);
}

TEST_CASE("capacity: what is not reached is none") {
  const Capacity c = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, trilinear(4e-3));
  CHECK(std::isnan(c.ultimate_displacement));
  CHECK(std::isnan(c.ntc.force));
  CHECK(std::isnan(c.ec8.ductility));
  const auto json = nlohmann::json::parse(capacity_json(c, false));
  CHECK(json["ultimate_displacement"].is_null());
  CHECK(json["kind"] == "pushover");
}

TEST_CASE("capacity: what motion bears is taken off the multiplier, and too much of it is said") {
  const Capacity c = capacity_of(cases::AnalysisKind::tilt, 0.2, kPace, kWeight, 0.0, trilinear(7e-3));
  CHECK(c.multiplier == doctest::Approx(0.1).epsilon(1e-4));
  CHECK(c.multiplier_displacement >= 3e-3);  // in the tenth of a pace that sees the small bump there
  CHECK(c.multiplier_displacement <= 3.21e-3);
  CHECK(c.motion_share == doctest::Approx(0.101));
  CHECK(c.multiplier_at_rest == doctest::Approx(0.1 * 0.899).epsilon(1e-4));
  CHECK(c.kinetic_share == doctest::Approx(1e-3));
  CHECK(nlohmann::json::parse(capacity_json(c, false))["slow"] == 0);
  CHECK(capacity_text(c).find("the result depends on the rate") != std::string::npos);
}

TEST_CASE("capacity: a jolt of the load factor is no strength, nor is motion that dies down") {
  CapacityCurve jolted = trilinear(7e-3);
  jolted.factor[250] += 0.02;
  for (std::size_t i = 250; i < jolted.time.size(); ++i) jolted.kinetic[i] -= 0.5 * jolted.kinetic[250];
  const Capacity c = capacity_of(cases::AnalysisKind::pushover, 0.2, kPace, kWeight, 0.0, jolted);
  CHECK(c.multiplier == doctest::Approx(0.12));
  CHECK(c.multiplier_at_rest == doctest::Approx(0.1 * 0.899).epsilon(0.015));
}

namespace {

/// What bears 9 kN however it moves, and 1 kN more by damping, swings by 0.3 mm while it is pushed on by 1 mm/s: to and fro, with the
/// energy balance of a mass of 1e6 kg.
CapacityCurve swinging() {
  constexpr double kMass = 1e6, kSwing = 3e-4, kOmega = 6.0, kBears = 9e3, kDrag = 1e3;  // kg, m, 1/s, N, N
  CapacityCurve c;
  double work = 0.0, lost = 0.0;
  for (int i = 0; i <= 6000; ++i) {
    const double t = 1e-3 * i, q = 1e-3 * t + kSwing * (1.0 - std::cos(kOmega * t));
    const double speed = 1e-3 + kSwing * kOmega * std::sin(kOmega * t), inertia = kMass * kSwing * kOmega * kOmega * std::cos(kOmega * t);
    const double force = kBears + std::copysign(kDrag, speed) + inertia;
    if (i > 0) {
      const double on = q - c.moved.back();
      lost += kDrag * std::abs(on), work += 0.5 * on * (force + kWeight * c.factor.back());
    }
    c.time.push_back(t), c.displacement.push_back(q), c.moved.push_back(q), c.drift.push_back(q), c.support_moved.push_back(0.0);
    c.base_shear.push_back(kBears), c.factor.push_back(force / kWeight), c.over.push_back(0.0);
    c.input.push_back(work), c.damping.push_back(lost), c.kinetic.push_back(0.5 * kMass * speed * speed), c.losses.push_back(lost);
    c.stored.push_back(work - lost);
  }
  return c;
}

}  // namespace

TEST_CASE("capacity: a swing to and fro adds no strength") {
  const Capacity c = capacity_of(cases::AnalysisKind::tilt, 0.2, kPace, kWeight, 0.0, swinging());
  CHECK(c.multiplier > 0.2);
  CHECK(c.multiplier_at_rest == doctest::Approx(0.09).epsilon(1e-3));
  CHECK(nlohmann::json::parse(capacity_json(c, false))["slow"] == 0);
}

TEST_CASE("capacity: a loop's area is the work of its forces") {
  CapacityCurve c = trilinear(5e-3);
  const Capacity got = capacity_of(cases::AnalysisKind::cyclic, 0.2, kPace, kWeight, 0.0, c);
  CHECK(got.loop_area == doctest::Approx(got.dissipated + got.stored).epsilon(1e-3));
}

TEST_CASE("capacity: loops are whole cycles between upward crossings of zero, and what other loads put in is told apart") {
  CapacityCurve c;
  double work = 0.0;
  for (int i = 0; i <= 5300; ++i) {  // two cycles of 1 mm, and a third of 0.5 mm that is not whole; force ahead of the displacement by 30°
    const double angle = std::acos(-1.0) * i / 1000.0, size = i < 4000 ? 1e-3 : 5e-4;
    c.time.push_back(1e-3 * i), c.moved.push_back(size * std::sin(angle) + (i % 2 == 0 ? 1e-8 : -1e-8));
    c.factor.push_back(0.1 * std::sin(angle + std::acos(-1.0) / 6.0));
    if (i > 0)
      work +=
          0.5 * kWeight * (c.factor[c.factor.size() - 1] + c.factor[c.factor.size() - 2]) * (c.moved.back() - c.moved[c.moved.size() - 2]);
    c.displacement.push_back(0.0), c.drift.push_back(0.0), c.base_shear.push_back(0.0), c.support_moved.push_back(0.0),
        c.over.push_back(0.0);
    c.input.push_back(work + 0.25e-3 * i), c.damping.push_back(0.0), c.kinetic.push_back(0.0), c.losses.push_back(work),
        c.stored.push_back(0.25e-3 * i);
  }
  const Capacity got = capacity_of(cases::AnalysisKind::cyclic, 0.2, kPace, kWeight, 0.0, c);
  REQUIRE(got.loops.size() == 2);
  const double pi = std::acos(-1.0), area = pi * 0.1 * kWeight * 1e-3 * std::sin(pi / 6.0);  // of the ellipse
  for (const Loop& l : got.loops) {
    CHECK(l.area == doctest::Approx(area).epsilon(1e-3));
    CHECK(l.dissipated == doctest::Approx(area).epsilon(1e-3));
    CHECK(l.other_work == doctest::Approx(0.5).epsilon(2e-3));
    CHECK(l.stored == doctest::Approx(0.5).epsilon(2e-3));
    CHECK(l.most == doctest::Approx(1e-3).epsilon(1e-3));
    CHECK(l.least == doctest::Approx(-1e-3).epsilon(1e-3));
    CHECK(l.viscous_damping == doctest::Approx(0.5 * std::sin(pi / 6.0)).epsilon(2e-3));  // area / (2π F A)
    CHECK(l.last_factor == doctest::Approx(0.05).epsilon(0.02));
  }
  const auto json = nlohmann::json::parse(capacity_json(got, false));
  CHECK(json["loops"].size() == 2);
  CHECK(json["loops"][1]["viscous_damping"].get<double>() == got.loops[1].viscous_damping);
  CHECK(capacity_text(got).find("loop 2") != std::string::npos);
}

TEST_CASE("capacity: an arch falls when it moves faster than it follows its supports, for good") {
  CapacityCurve c = trilinear(1e-3);
  for (std::size_t i = 0; i < c.time.size(); ++i) {
    c.support_moved[i] = 0.01 * c.time[i];
    c.kinetic[i] = i == 20 || i > 80 ? 1.0 : 1e-6;  // once it swings
  }
  const Capacity got = capacity_of(cases::AnalysisKind::settlement, 0.2, kPace, kWeight, 1e-3, c);
  CHECK(got.collapse_movement == doctest::Approx(0.01 * c.time[80]));
  CHECK(std::isnan(capacity_of(cases::AnalysisKind::settlement, 0.2, kPace, kWeight, 10.0, c).collapse_movement));
}

namespace {

/// The capacity that is read of a pushover by states of rest, of at most 3 s, from its run.h5.
/// \param rows  a row every 0.1 s \param end  s, that the run has reached \param lost_residual  of the ledger at the last row, which is no
/// state of rest then \param failed  the program ended the run itself
Capacity read_back(int rows, double end, std::optional<double> lost_residual, bool failed) {
  const test::TempFolder folder;
  ResultsWriter writer(folder.path(), test::two_cubes(), std::string(test::kCase) + "\n[analysis]\nkind = \"pushover\"\nlongest = 3.0\n",
                       test::kNames, {}, test::by_hand());
  solver::Drive drive;
  drive.frequency = 10.0, drive.pace = 2.0, drive.weight = kWeight;
  writer.drive(drive);
  for (int i = 0; i < rows; ++i) {
    const bool lost = lost_residual && i + 1 == rows;
    solver::EnergyRow energy;
    energy.time = 0.1 * i, energy.residual = lost ? *lost_residual : 1e-9;
    writer.energy(energy);
    writer.forces({0.1 * i, {-1.0 * i, 0.0, 0.0}, {}});
    solver::AssessmentRow row{0.1 * i, 0.01 * i, 0.001 * i, 0.002 * i, 0.001 * i, 1.0 * i, 0.0, lost ? 2.0 : 0.0};
    row.unbalanced = lost ? 9.0 : 1e-5;
    writer.assessment(row);
  }
  solver::Summary summary;
  summary.end_time = end;
  writer.summary(summary);
  if (failed) writer.failure("as a test");
  writer.finish();
  return *capacity_of(Hdf5File::open(folder.file("run.h5")));
}

bool says(const Capacity& c, const std::string& words) { return capacity_text(c).find(words) != std::string::npos; }

}  // namespace

TEST_CASE("capacity: states of rest that stop short of the longest time have come to it once the run has") {
  const Capacity longest = read_back(29, 3.0, {}, false), stopped = read_back(29, 2.8, {}, false), failed = read_back(29, 2.8, {}, true);
  CHECK(longest.ended == "longest");
  CHECK(says(longest, "ended by: longest\n"));
  CHECK(stopped.ended == "not yet");
  CHECK(says(stopped, "not at its end: figures so far"));
  CHECK(failed.ended == "numerical failure");
  CHECK(says(failed, "ended by: numerical failure; figures up to there"));
}

TEST_CASE("capacity: a path without a further state of rest is told as one, however its last iterations kept their energy") {
  for (const double residual : {1e-6, 35.0}) {
    CAPTURE(residual);
    const Capacity got = read_back(11, 1.0, residual, false);
    CHECK(got.ended == "no further state of rest");
    CHECK(got.curve.time.size() == 10);
    CHECK(got.multiplier == doctest::Approx(0.09));
    CHECK(got.unbalanced == 1e-5);
    CHECK(got.lost_residual == residual);
    CHECK(not_proven(got).size() == (residual > 1.0 ? 1U : 0U));
    CHECK(says(got, "a state of rest may have been missed") == (residual > 1.0));
    CHECK(nlohmann::json::parse(capacity_json(got, false)).at("not_proven") == nlohmann::json(not_proven(got)));
  }
}
