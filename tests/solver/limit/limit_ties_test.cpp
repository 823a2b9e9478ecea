// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/limit_ties.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/limit/kinematics/kinematic_curve.h"
#include "solver/limit/limit.h"
#include "solver/limit/programme/linear_programme.h"
#include "tests/solver/limit/masonry.h"

// Ties in limit analysis against closed forms. scripts/limit_check --ties compares random models with a programme written apart.
namespace voussoir::testing {
namespace {

constexpr double kWidth = 0.4, kDepth = 1.0, kHeight = 2.0, kDensity = 2000.0;  // m, kg/m3
constexpr double kWeight = kDensity * 9.8 * kWidth * kDepth * kHeight;            // N
constexpr double kYield = 4000.0, kTieHeight = 1.5;                              // N, m

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

cases::Tie rod(Vec3 from, Vec3 to, std::optional<double> yield) {
  cases::Tie tie;
  tie.name = "rod", tie.from = from, tie.to = to, tie.area = 1e-4;
  if (yield) tie.yield = *yield / tie.area;
  return tie;
}

/// A wall with a level rod to a fixed pillar on its left.
cases::Case tied_wall(double friction, std::optional<double> yield) {
  cases::Case c;
  c.materials["stone"] = {kDensity, 1e9, 0.2};
  c.base = cases::Base{};
  c.contact.friction = friction;
  c.segment_rule = geometry::SegmentRule::rim;
  for (const double x : {0.0, -2.4}) {
    cases::BlockSpec b;
    b.name = x < 0.0 ? "pillar" : "wall", b.material = "stone", b.fixed = x < 0.0;
    b.box = {{Vec3{x, 0, 0}, Vec3{x + kWidth, kDepth, kHeight}}};
    c.blocks.push_back(b);
  }
  c.ties.push_back(rod({-2.0, 0.5, kTieHeight}, {0.0, 0.5, kTieHeight}, yield));
  return c;
}

solver::LimitResult analysed(const cases::Case& c, double x = 1.0) {
  solver::LimitOptions o;
  o.live.direction = {x, 0, 0};
  return solver::limit_analysis(c, cases::build_model(c), o);
}

std::string refusal(const cases::Case& c) {
  try {
    analysed(c);
    return "none";
  } catch (const cases::InputError& e) {
    return e.what();
  }
}

/// A beam on a fixed pillar whose middle is 0.35 m beyond its edge; a rod holds its tail, 0.5 m behind that edge, down to the base.
cases::Case tied_beam(double yield) {
  cases::Case c = tied_wall(60.0, {});
  c.ties.clear();
  c.blocks[0].box = {{Vec3{-2.5, 0, 2.0}, Vec3{-0.8, 1.0, 2.4}}};
  c.ties.push_back(rod({-2.5, 0.5, 0.0}, {-2.5, 0.5, 2.2}, yield));
  return c;
}
const double kBeam = kDensity * 9.8 * 1.7 * 1.0 * 0.4;                   // N
const double kBeamNeeds = kBeam * (-1.65 + 2.0) / (-2.0 + 2.5);          // N in the rod under the beam's weight

}  // namespace

TEST_SUITE_BEGIN("limit analysis" * doctest::skip(!solver::has_linear_programmes()));

TEST_CASE("limit: a wall that turns pulls its rod to yield, and turns freely towards it") {
  const solver::LimitResult away = analysed(tied_wall(60.0, kYield)), towards = analysed(tied_wall(60.0, kYield), -1.0);
  const double free = kWidth / kHeight, tied = free + 2.0 * kYield * kTieHeight / (kWeight * kHeight);
  CHECK_FALSE(away.plane);
  for (const solver::LimitState* s : {&away.associated, &away.coulomb}) {
    CHECK(s->multiplier == doctest::Approx(tied).epsilon(1e-9));
    REQUIRE(s->ties.size() == 1);
    CHECK(s->ties[0] == doctest::Approx(kYield).epsilon(1e-9));
    CHECK(s->proof.holds);
  }
  for (const solver::LimitState* s : {&towards.associated, &towards.coulomb}) {
    CHECK(s->multiplier == doctest::Approx(free).epsilon(1e-9));
    CHECK(s->ties[0] == doctest::Approx(0.0).epsilon(1e-9));
    CHECK(s->proof.holds);
  }
}

TEST_CASE("limit: a strut bears in both directions") {
  cases::Case c = tied_wall(60.0, kYield);
  c.ties[0].compression = true;
  const double tied = kWidth / kHeight + 2.0 * kYield * kTieHeight / (kWeight * kHeight);
  CHECK(analysed(c).associated.multiplier == doctest::Approx(tied).epsilon(1e-9));
  const solver::LimitResult towards = analysed(c, -1.0);
  CHECK(towards.associated.multiplier == doctest::Approx(tied).epsilon(1e-9));
  CHECK(towards.associated.ties[0] == doctest::Approx(-kYield).epsilon(1e-9));
  CHECK(towards.coulomb_proven());
}

TEST_CASE("limit: a wall that slides pulls its rod to yield; an elastic rod lets it only turn about the rod's end") {
  const double friction = tangent(10.0);
  const solver::LimitResult slides = analysed(tied_wall(10.0, 500.0));
  CHECK(slides.coulomb.multiplier == doctest::Approx(friction + 500.0 / kWeight).epsilon(1e-9));
  CHECK(slides.coulomb_proven());
  // An elastic rod never yields: the foot slides outwards under it. Moments about the rod's end, with all of the base's force at the heel
  // on the left: friction × its height is less than that of the weight and of the live force, at the centre of the wall.
  const solver::LimitResult held = analysed(tied_wall(10.0, {}));
  CHECK(held.coulomb_proven());
  CHECK(held.coulomb.ties[0] > 500.0);
  CHECK(held.associated.proof.motion.stretch < 1e-9);
  const double below = kTieHeight - 0.5 * kHeight;
  CHECK(held.coulomb.multiplier == doctest::Approx((friction * kTieHeight + 0.5 * kWidth) / below).epsilon(1e-6));
}

TEST_CASE("limit: what stands by its rod alone stands if the rod is strong enough, and bears what is left of it") {
  CHECK(refusal(tied_beam(0.99 * kBeamNeeds)).find("does not stand under its dead loads alone, as dry blocks with the friction of their "
                                                    "contacts and its ties") != std::string::npos);
  const cases::Case c = tied_beam(1.5 * kBeamNeeds);
  solver::LimitOptions down;
  down.live.direction = {0, 0, -1};
  const solver::LimitResult r = solver::limit_analysis(c, cases::build_model(c), down);
  CHECK(r.associated.multiplier == doctest::Approx(0.5).epsilon(1e-9));
  CHECK(r.coulomb_proven());
  CHECK(refusal(tied_beam(0.0001)).find("does not stand") != std::string::npos);
}

TEST_CASE("limit: a rod that yields bears no live force of any size") {
  cases::Case c = tied_wall(60.0, kYield);
  solver::LimitOptions up;
  up.live.direction = {0, 0, -1};
  CHECK_THROWS_AS(solver::limit_analysis(c, cases::build_model(c), up), solver::NothingFalls);  // the base bears it
  c.ties[0] = rod({0.2, 0.5, 0.0}, {0.2, 0.5, 1.0}, kYield);
  up.live.direction = {0, 0, 1};
  CHECK(solver::limit_analysis(c, cases::build_model(c), up).associated.multiplier == doctest::Approx(1.0 + kYield / kWeight).epsilon(1e-9));
  c.ties[0].yield.reset();
  CHECK_THROWS_AS(solver::limit_analysis(c, cases::build_model(c), up), solver::NothingFalls);
}

TEST_CASE("limit: the interior-point method gives the multipliers of the simplex methods, with ties of any strength") {
  for (const double yield : {1e-3, 1e2, 1e3, 1e7}) {
    CAPTURE(yield);
    const Masonry wall = dry_wall(3, 4, 4000.0);
    cases::Case c = wall.as_case();
    const cases::Model bare = cases::build_model(c);
    const auto middle = [&](std::size_t element) { return bare.assembly.elements[element].mass.centroid; };
    for (std::size_t k = 0; k < 4; ++k) {
      c.ties.push_back(rod(middle(1 + k), middle(6 + 2 * k), yield * static_cast<double>(1 + k)));
      c.ties.back().name += std::to_string(k);
    }
    solver::LimitOptions o, inside;
    o.coulomb = inside.coulomb = false;
    inside.inside_from = 0;
    const cases::Model model = cases::build_model(c);
    const solver::LimitState by_simplex = solver::limit_analysis(c, model, o).associated;
    const solver::LimitState by_inside = solver::limit_analysis(c, model, inside).associated;
    CHECK(by_inside.multiplier == doctest::Approx(by_simplex.multiplier).epsilon(2e-6));
    CHECK(by_inside.proof.holds);
  }
}

TEST_CASE("kinematic: a wall that turns away from its rod has the curve of its weight and the rod's yield force, until the rod breaks") {
  cases::Case c = tied_wall(60.0, kYield);
  const auto curve = [&c] {
    const cases::Model model = cases::build_model(c);
    solver::LimitOptions o;
    o.coulomb = false;
    const solver::LimitResult r = solver::limit_analysis(c, model, o);
    return solver::kinematic_curve(c, model, r.contacts, r.associated, {1, 0, 0});
  };
  const solver::KinematicCurve k = curve();
  REQUIRE(k.none.empty());
  // The wall has turned by t about its toe at (kWidth, 0); the rod goes from (-2, kTieHeight) to the point that was at (0, kTieHeight).
  const auto multiplier = [](double t) {
    const double x = kWidth - kWidth * std::cos(t) + kTieHeight * std::sin(t), z = kTieHeight * std::cos(t) + kWidth * std::sin(t);
    const double length = std::hypot(x + 2.0, z - kTieHeight), along_x = (x + 2.0) / length, along_z = (z - kTieHeight) / length;
    const double of_rod = kYield * (along_x * z - along_z * (x - kWidth));  // moment about the toe, against the motion
    const double arm = 0.5 * (kWidth * std::cos(t) - kHeight * std::sin(t)), high = 0.5 * (kHeight * std::cos(t) + kWidth * std::sin(t));
    return (kWeight * arm + of_rod) / (kWeight * high);
  };
  const auto displacement = [](double t) { return 0.5 * (kWidth + kHeight * std::sin(t) - kWidth * std::cos(t)); };
  for (const double t : {0.0, 0.05, 0.1, 0.2}) CHECK(k.at(displacement(t)) == doctest::Approx(multiplier(t)).epsilon(2e-4));
  CHECK(k.zero > 0.5 * kWidth);  // that of the wall alone

  c.ties[0].elongation = 0.05;  // of 2 m: breaks when it is 2.1 m long
  const solver::KinematicCurve breaks = curve();
  REQUIRE(breaks.none.empty());
  CHECK(breaks.at(displacement(0.05)) == doctest::Approx(multiplier(0.05)).epsilon(2e-4));
  const double alone = std::tan(std::atan(kWidth / kHeight) - 0.1);
  CHECK(breaks.at(displacement(0.1)) == doctest::Approx(alone).epsilon(1e-3));
  CHECK(breaks.zero == doctest::Approx(0.5 * kWidth).epsilon(1e-3));
}

TEST_CASE("limit: ties whose ends are one body, or both fixed, do nothing") {
  cases::Case c = tied_wall(60.0, kYield);
  c.blocks[0].fixed = true;
  cases::BlockSpec free = c.blocks[0];
  free.name = "free", free.fixed = false, free.box = {{Vec3{3, 0, 0}, Vec3{3 + kWidth, kDepth, kHeight}}};
  c.blocks.push_back(free);
  const solver::LimitResult r = analysed(c);
  CHECK(r.contacts.ties.empty());
  CHECK(r.associated.multiplier == doctest::Approx(kWidth / kHeight).epsilon(1e-9));
}

TEST_SUITE_END();

}  // namespace voussoir::testing
