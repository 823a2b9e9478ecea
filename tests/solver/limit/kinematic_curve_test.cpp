// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/kinematics/kinematic_curve.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/limit/programme/linear_programme.h"

// The multiplier of mechanisms at finite displacements against closed forms: a rocking wall, one with a load on top, two pillars with a
// lintel.
namespace voussoir::testing {
namespace {

/// Relative to the value itself, however small it is.
doctest::Approx about(double value) { return doctest::Approx(value).scale(0.0).epsilon(2e-6); }

constexpr double kThick = 0.4, kHigh = 1.0, kDeep = 0.3;  // m
constexpr double kWeight = 2000.0 * 9.8 * kThick * kHigh * kDeep;

cases::Case stones(double friction = 70.0) {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e9, 0.2};
  c.base = cases::Base{};
  c.contact.friction = friction;
  c.gravity.acceleration = {0.0, 0.0, -9.8};
  c.segment_rule = geometry::SegmentRule::rim;
  return c;
}

void add(cases::Case& c, const std::string& name, Vec3 low, Vec3 high) {
  cases::BlockSpec b;
  b.name = name, b.material = "stone", b.box = {{low, high}};
  c.blocks.push_back(b);
}

cases::Case wall() {
  cases::Case c = stones();
  add(c, "wall", {0, 0, 0}, {kThick, kDeep, kHigh});
  return c;
}

solver::KinematicCurve curve_of(const cases::Case& c, Vec3 live = {1, 0, 0}) {
  const cases::Model model = cases::build_model(c);
  solver::LimitOptions o;
  o.live.direction = live, o.coulomb = false;
  const solver::LimitResult r = solver::limit_analysis(c, model, o);
  return solver::kinematic_curve(c, model, r.contacts, r.associated, live);
}

const bool kNone = !solver::has_linear_programmes();

}  // namespace

// Forces of such a tie are in balance by themselves, so a programme may find any.
TEST_CASE("kinematic: a tie within a part that moves changes nothing, whatever it bears" * doctest::skip(kNone)) {
  cases::Case c = stones();
  add(c, "lower", {0, 0, 0}, {kThick, kDeep, 0.5 * kHigh});
  add(c, "upper", {0, 0, 0.5 * kHigh}, {kThick, kDeep, kHigh});
  cases::Tie rod;
  rod.name = "rod", rod.from = {0.1, 0.1, 0.25}, rod.to = {0.2, 0.1, 0.75}, rod.area = 1e-4;
  c.ties.push_back(rod);
  const cases::Model model = cases::build_model(c);
  solver::LimitOptions o;
  o.live.direction = {1, 0, 0}, o.coulomb = false;
  solver::LimitResult r = solver::limit_analysis(c, model, o);
  REQUIRE(r.associated.ties.size() == 1);
  for (const double force : {0.0, 1e3, 1e5}) {
    r.associated.ties[0] = force;
    const solver::KinematicCurve k = solver::kinematic_curve(c, model, r.contacts, r.associated, {1, 0, 0});
    CHECK(k.none.empty());
    CHECK(k.zero == about(0.5 * kThick));
  }
}

TEST_CASE("kinematic: a rocking wall begins at thickness over height and bears nothing at half its thickness" * doctest::skip(kNone)) {
  const solver::KinematicCurve k = curve_of(wall());
  REQUIRE(k.none.empty());
  CHECK(k.parts == 1);
  CHECK(k.freedoms == 1);
  CHECK(k.sliding == 0);
  CHECK(k.points.front().multiplier == about(kThick / kHigh));
  CHECK(k.zero == about(0.5 * kThick).epsilon(1e-5));
  CHECK(k.participation == about(1.0));
  CHECK(k.spectral == about(1.0));
  CHECK(k.weight == about(kWeight));
  const double radius = 0.5 * std::hypot(kThick, kHigh);
  for (const double d : {0.02, 0.08, 0.12, 0.19}) CHECK(k.at(d) == about(std::tan(std::asin((0.5 * kThick - d) / radius))).epsilon(1e-4));
}

TEST_CASE("kinematic: mirrored, turned and scaled walls have the same curve, of their size" * doctest::skip(kNone)) {
  const solver::KinematicCurve k = curve_of(wall()), back = curve_of(wall(), {-1, 0, 0});
  CHECK(back.zero == about(k.zero).epsilon(1e-9));
  CHECK(back.at(0.1) == about(k.at(0.1)).epsilon(1e-9));
  cases::Case turned = stones();
  add(turned, "wall", {0, 0, 0}, {kDeep, kThick, kHigh});
  CHECK(curve_of(turned, {0, 1, 0}).at(0.1) == about(k.at(0.1)).epsilon(1e-9));
  cases::Case large = stones();
  add(large, "wall", {0, 0, 0}, {3.0 * kThick, 3.0 * kDeep, 3.0 * kHigh});
  CHECK(curve_of(large).zero == about(3.0 * k.zero).epsilon(1e-6));
  CHECK(curve_of(large).at(0.3) == about(k.at(0.1)).epsilon(1e-4));
}

TEST_CASE("kinematic: a load on top holds the wall at first and topples it later" * doctest::skip(kNone)) {
  cases::Case c = wall();
  cases::Load load;
  load.block = "wall", load.force = {0.0, 0.0, -kWeight}, load.at = Vec3{0.1, 0.5 * kDeep, kHigh};
  c.loads.push_back(load);
  const solver::KinematicCurve k = curve_of(c);
  const double arm = kThick - 0.1;  // of the load from the hinge
  CHECK(k.points.front().multiplier == about((kWeight * 0.5 * kThick + kWeight * arm) / (kWeight * 0.5 * kHigh)));
  // The moment of both about the hinge is zero at this angle.
  const double angle = std::atan((0.5 * kThick + arm) / (0.5 * kHigh + kHigh));
  const double radius = 0.5 * std::hypot(kThick, kHigh), first = std::atan(kThick / kHigh);
  CHECK(k.zero == about(0.5 * kThick - radius * std::sin(first - angle)).epsilon(1e-4));
  CHECK(k.participation == about(1.0));  // the load's mass is not shaken
}

TEST_CASE("kinematic: two pillars that carry a lintel lean as one linkage" * doctest::skip(kNone)) {
  cases::Case c = stones();
  add(c, "left", {0, 0, 0}, {0.4, 0.3, 1.0});
  add(c, "right", {2.0, 0, 0}, {2.4, 0.3, 1.0});
  add(c, "lintel", {0, 0, 1.0}, {2.4, 0.3, 1.3});
  const solver::KinematicCurve k = curve_of(c);
  REQUIRE(k.none.empty());
  CHECK(k.parts == 3);
  CHECK(k.freedoms == 1);
  CHECK(k.points.front().multiplier == about(0.4).epsilon(1e-6));
  CHECK(k.zero == about(0.4).epsilon(1e-4));  // of the lintel: it has gone by the thickness of the pillars
  const double pillars = 2 * 0.4 * 0.3 * 1.0, lintel = 2.4 * 0.3 * 0.3;
  const double first = 0.5 * pillars + lintel, second = 0.25 * pillars + lintel;
  CHECK(k.participation == about(first * first / ((pillars + lintel) * second)).epsilon(1e-6));
  CHECK(k.spectral == about(second / first).epsilon(1e-6));
  const double radius = std::hypot(0.4, 1.0);
  CHECK(k.at(0.15) == about(std::tan(std::asin((0.4 - 0.15) / radius))).epsilon(1e-4));
}

TEST_CASE("kinematic: forty pillars below one beam lean as one linkage, as two do" * doctest::skip(kNone)) {
  constexpr int kPillars = 40;
  cases::Case c = stones();
  for (int i = 0; i < kPillars; ++i) add(c, "pillar " + std::to_string(i), {1.0 * i, 0, 0}, {1.0 * i + 0.2, 0.3, 1.0});
  add(c, "beam", {0, 0, 1.0}, {kPillars - 0.8, 0.3, 1.2});
  const solver::KinematicCurve k = curve_of(c);
  CHECK(k.parts == kPillars + 1);
  CHECK(k.freedoms == 1);
  CHECK(k.points.front().multiplier == about(0.2).epsilon(1e-6));
  CHECK(k.zero == about(0.2).epsilon(1e-4));
  const double radius = std::hypot(0.2, 1.0);
  CHECK(k.at(0.08) == about(std::tan(std::asin((0.2 - 0.08) / radius))).epsilon(1e-4));
}

TEST_CASE("kinematic: what slides has no displacement at which it bears nothing, and that is said" * doctest::skip(kNone)) {
  cases::Case c = stones(10.0);
  add(c, "slab", {0, 0, 0}, {1.0, 1.0, 0.2});
  const solver::KinematicCurve k = curve_of(c);
  CHECK(k.points.front().multiplier == about(std::tan(10.0 * 3.14159265358979 / 180.0)));
  CHECK(std::isnan(k.zero));
  CHECK(k.none.find("as of one that slides") != std::string::npos);
  CHECK(k.sliding == 1);
}

}  // namespace voussoir::testing
