// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

#include "cases/model.h"
#include "solver/limit/limit.h"
#include "solver/limit/limit_proof.h"
#include "tests/solver/limit/masonry.h"

// Limit analysis of arches and walls: published and bracketed multipliers, the same answer in every place, and checks that see faults.
namespace voussoir::testing {
namespace {

Vec3 along(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle), 0.0};
}

solver::LimitResult analysed(const Masonry& m, Vec3 direction = {1, 0, 0}, bool coulomb = true) {
  const cases::Case c = m.as_case();
  solver::LimitOptions o;
  o.live.direction = direction, o.coulomb = coulomb;
  return solver::limit_analysis(c, cases::build_model(c), o);
}

std::string refusal(const Masonry& m) {
  try {
    analysed(m);
    return "none";
  } catch (const cases::InputError& e) {
    return e.what();
  }
}

}  // namespace

TEST_SUITE_BEGIN("limit analysis" * doctest::skip(!solver::has_linear_programmes()));

TEST_CASE("limit: an arch has one multiplier, wherever it stands, however it is turned, mirrored, scaled and ordered") {
  std::mt19937 random(63);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (const int voussoirs : {9, 24, 31}) {
    const Masonry arch = dry_arch(voussoirs, 1.8, 2.2, 0.5);
    const solver::LimitResult first = analysed(arch);
    const double expected = first.associated.multiplier;
    INFO(voussoirs << " voussoirs, multiplier " << expected);
    CHECK(first.plane);
    CHECK(expected > 0.05);
    CHECK(first.coulomb_proven());
    CHECK(first.coulomb.multiplier <= expected);
    for (const double far : {1.0, 10.0, 100.0, 1000.0, 1e5}) {
      INFO("moved by " << far);
      CHECK(analysed(arch.moved({far, 0.3 * far, 0.1 * far}), {1, 0, 0}, false).associated.multiplier ==
            doctest::Approx(expected).epsilon(1e-8));
    }
    for (int trial = 0; trial < 4; ++trial) {
      const double angle = 360.0 * any(random), by = std::pow(10.0, 4.0 * any(random) - 2.0);
      INFO("turned by " << angle << ", scaled by " << by);
      const Masonry other = arch.shuffled(random).turned(angle).scaled(by);
      CHECK(analysed(other, along(angle), false).associated.multiplier == doctest::Approx(expected).epsilon(1e-8));
      CHECK(analysed(other.mirrored(), along(180.0 - angle), false).associated.multiplier == doctest::Approx(expected).epsilon(1e-8));
    }
    // A hair out of the plane it is analysed in space.
    const solver::LimitResult space = analysed(arch, along(0.01));
    CHECK_FALSE(space.plane);
    CHECK(space.associated.multiplier == doctest::Approx(expected).epsilon(1e-4));
  }
}

TEST_CASE("limit: thin arches fall, thick ones stand: least t/R between 0.1 and 0.115 where nothing slides") {
  // Milankovitch 1907: 0.1075 for a continuous semicircle; voussoirs part at fewer places, so that of 60 is a little less.
  const auto arch = [](double ratio) {
    Masonry m = dry_arch(60, 1.0 - 0.5 * ratio, 1.0 + 0.5 * ratio, 0.3, -180.0 / 58.0);  // 58 voussoirs from springing to springing
    m.friction = 75.0;
    return m;
  };
  CHECK(analysed(arch(0.115)).associated.multiplier > 0.0);
  CHECK(refusal(arch(0.1)).starts_with("does not stand under its dead loads alone"));
  CHECK(refusal(arch(0.1)).find("a mechanism was found and checked in which stone \"v") != std::string::npos);
}

TEST_CASE("limit: a heavy beam on a wall: multipliers change little by little with its weight") {
  double last = 0.0;
  for (const double density : {6000.0, 8000.0, 10000.0, 12000.0, 14000.0}) {
    const solver::LimitResult r = analysed(dry_wall(8, 5, density));
    INFO("density of the beam " << density);
    CHECK(r.associated.multiplier > 0.38);
    if (last > 0.0) CHECK(std::abs(r.associated.multiplier - last) < 0.03);
    last = r.associated.multiplier;
    CHECK(r.coulomb_proven());
    CHECK(r.coulomb.multiplier <= r.associated.multiplier);
    CHECK(r.coulomb.proof.lower <= r.coulomb.multiplier * (1.0 + 1e-9));
    CHECK(r.coulomb.proof.upper >= r.coulomb.multiplier * (1.0 - 1e-9));
  }
}

TEST_CASE("limit: what falls by itself is refused, also where the live force would hold it up") {
  Masonry slope;  // 30 degrees, friction of 20
  slope.friction = 20.0;
  const auto tilt = [](const geometry::Polyhedron& p) { return geometry::rotated(p, {0, 1, 0}, std::numbers::pi / 6.0, {}); };
  slope.stones.push_back({"ground", tilt(geometry::make_box({-2, -2, -1}, {2, 2, 0})), true});
  slope.stones.push_back({"block", tilt(geometry::make_box({-0.5, -0.5, 0}, {0.5, 0.5, 0.2}))});
  for (const double direction : {0.0, 90.0, 180.0, 33.0}) {
    std::string said = "none";
    try {
      analysed(slope, along(direction));
    } catch (const cases::InputError& e) {
      said = e.what();
    }
    INFO(direction);
    CHECK(said.starts_with("does not stand under its dead loads alone"));
  }
}

TEST_CASE("limit: a pebble on a block topples at its own width over its height, however small it is beside the block") {
  std::mt19937 random(287);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (const double size : {0.3, 0.03, 0.003}) {
    for (int trial = 0; trial < 10; ++trial) {
      Masonry m;
      m.friction = 60.0;
      m.stones.push_back({"ground", geometry::make_box({-2, -2, -1}, {2, 2, 0}), true});
      m.stones.push_back({"block", geometry::make_box({-0.5, -0.5, 0}, {0.5, 0.5, 0.4}), false, true});
      m.stones.push_back({"pebble", geometry::make_box({0.1, 0.1, 0.4}, {0.1 + size, 0.1 + 0.7 * size, 0.4 + 2.0 * size})});
      const double angle = 360.0 * any(random);
      const Vec3 to{20.0 * any(random), 20.0 * any(random), any(random)};
      INFO("pebble of " << size << " m, turned by " << angle << ", moved to " << to.x << " " << to.y << " " << to.z);
      const solver::LimitResult r = analysed(m.turned(angle).moved(to), along(angle), false);
      CHECK(r.associated.multiplier == doctest::Approx(0.5).epsilon(1e-8));
      CHECK(r.associated.proof.upper == doctest::Approx(0.5).epsilon(1e-8));
    }
  }
}

TEST_CASE("limit: a pebble that overhangs a block falls, however small it is beside the block") {
  for (const double size : {0.3, 0.03, 0.003}) {
    Masonry m;
    m.friction = 60.0;
    m.stones.push_back({"ground", geometry::make_box({-2, -2, -1}, {2, 2, 0}), true});
    m.stones.push_back({"block", geometry::make_box({-0.5, -0.5, 0}, {0.5, 0.5, 0.4}), false, true});
    m.stones.push_back({"pebble", geometry::make_box({0.5 - 0.3 * size, 0.0, 0.4}, {0.5 + 0.7 * size, size, 0.4 + size})});
    INFO("pebble of " << size << " m");
    CHECK(refusal(m.turned(33.0).moved({7, 3, 1})).find("in which stone \"pebble\" (element 2) moves fastest") != std::string::npos);
  }
}

TEST_CASE("limit: the pieces of a stone are one body") {
  Masonry whole;
  whole.friction = 60.0;
  whole.stones.push_back({"ground", geometry::make_box({-2, -2, -1}, {2, 2, 0}), true});
  cases::Case c = whole.as_case();
  cases::StonesSpec set;
  set.file = "none.obj", set.material = "stone";
  set.stones.push_back({"notched",
                        {},
                        false,
                        {{geometry::make_box({0, 0, 0}, {0.4, 0.3, 0.5}), {}}, {geometry::make_box({0.4, 0, 0.3}, {1, 0.3, 0.5}), {}}},
                        ""});
  c.stones.push_back(set);
  solver::LimitOptions o;
  o.live.direction = {-1, 0, 0};
  const solver::LimitResult r = solver::limit_analysis(c, cases::build_model(c), o);
  REQUIRE(r.contacts.bodies.size() == 1);
  const double stem = 0.4 * 0.5, arm = 0.6 * 0.2, centre = (0.2 * stem + 0.7 * arm) / (stem + arm),
               high = (0.25 * stem + 0.4 * arm) / (stem + arm);
  CHECK(r.associated.multiplier == doctest::Approx(centre / high).epsilon(1e-9));
}

TEST_CASE("limit: each check sees a fault of its own kind") {
  const Masonry wall = dry_wall(2, 2, 4000.0);
  const cases::Case c = wall.as_case();
  const cases::Model model = cases::build_model(c);
  const solver::LimitContacts contacts = solver::limit_contacts(model, {1, 0, 0});
  const solver::LimitForces forces = solver::limit_forces(c, model, contacts, {});
  const solver::FrictionCone cone(8, false);
  const solver::LimitModel checks(model, contacts, forces, cone, {1, 0, 0});
  const double unit = forces.weight / static_cast<double>(contacts.bodies.size());
  std::vector<Vec3> none(contacts.points.size());
  CHECK(checks.check_forces({none, {}}, 1.0, 0.0).unbalanced >= 1.0);
  CHECK(checks.check_forces({none, {}}, 0.0, 0.0).worst() == doctest::Approx(0.0).epsilon(1e-12));
  std::vector<Vec3> pulled = none;
  pulled[0] = 0.1 * unit * contacts.points[0].normal;
  CHECK(checks.check_forces({pulled, {}}, 0.0, 0.0).tension == doctest::Approx(0.1));
  std::vector<Vec3> sheared = none;
  sheared[0] = unit * (contacts.points[0].first - contacts.points[0].normal);
  CHECK(checks.check_forces({sheared, {}}, 0.0, 0.0).over_friction == doctest::Approx(1.0 - std::tan(31.7989 * std::numbers::pi / 180.0)));
  solver::LimitContacts apart = contacts;
  apart.points[0].at += Vec3{0.0, 0.0, 0.01};
  CHECK(solver::LimitModel(model, apart, forces, cone, {1, 0, 0}).check_forces({none, {}}, 0.0, 0.0).off_joint ==
        doctest::Approx(0.01 / forces.length));

  std::vector<kernels::Twist> motion(contacts.bodies.size());
  motion.back().v = {0, 0, -1};  // the beam goes down into the wall
  CHECK(checks.check_motion(motion).overlap == doctest::Approx(1.0));
  motion.back().v = {1, 0, 0};  // it slides, which opens nothing
  CHECK(checks.check_motion(motion).overlap == doctest::Approx(0.0).epsilon(1e-12));
  CHECK(checks.check_motion(motion).off_normal == doctest::Approx(std::tan(31.7989 * std::numbers::pi / 180.0)));
  CHECK(checks.check_motion(motion).live_power == doctest::Approx(contacts.bodies.back().mass * 9.8));
  // Without friction its slip takes nothing of the power that is due.
  std::vector<Vec3> pressed = none;
  for (std::size_t i = 0; i < contacts.points.size(); ++i) pressed[i] = -unit * contacts.points[i].normal;
  CHECK(checks.lost_power({pressed, {}}, motion) > 0.1);
}

TEST_SUITE_END();

}  // namespace voussoir::testing
