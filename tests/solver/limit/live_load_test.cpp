// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/live_load.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "cases/model.h"
#include "solver/limit/load_path.h"
#include "tests/solver/limit/masonry.h"

// Live loads of limit analysis: weights of some blocks, point loads, growing loads, loads that move.
namespace voussoir::testing {
namespace {

constexpr double kGravity = 9.8;

/// A block of 0.4 x 0.3 x 1 m on a fixed slab, and another beside it.
Masonry blocks() {
  Masonry m;
  m.friction = 70.0;
  m.stones.push_back({"slab", geometry::make_box({-2, -2, -0.2}, {4, 2, 0}), true});
  m.stones.push_back({"one", geometry::make_box({0, 0, 0}, {0.4, 0.3, 1.0})});
  m.stones.push_back({"other", geometry::make_box({2, 0, 0}, {2.4, 0.3, 1.0})});
  return m;
}
constexpr double kWeight = 2000.0 * kGravity * 0.4 * 0.3 * 1.0;

double multiplier(const cases::Case& c, const solver::LiveLoad& live) {
  solver::LimitOptions o;
  o.live = live;
  const solver::LimitResult r = solver::limit_analysis(c, cases::build_model(c), o);
  CHECK(r.associated.proof.holds);
  CHECK(r.coulomb_proven());
  CHECK(r.coulomb.multiplier <= r.associated.multiplier);
  return r.associated.multiplier;
}

std::string refusal(const cases::Case& c, const solver::LiveLoad& live) {
  try {
    multiplier(c, live);
    return "none";
  } catch (const cases::InputError& e) {
    return e.what();
  }
}

solver::LiveLoad weight(Vec3 direction, std::vector<std::string> on) {
  return {solver::LiveLoad::Kind::weight, direction, std::move(on), 0.0, {}};
}

solver::LiveLoad force(double newtons, Vec3 direction, std::vector<std::string> on, std::optional<Vec3> at = {}) {
  return {solver::LiveLoad::Kind::force, direction, std::move(on), newtons, at};
}

}  // namespace

TEST_SUITE_BEGIN("limit analysis" * doctest::skip(!solver::has_linear_programmes()));

TEST_CASE("live load: the weight of one block, in any direction") {
  const cases::Case c = blocks().as_case();
  CHECK(multiplier(c, weight({1, 0, 0}, {"one"})) == doctest::Approx(0.4).epsilon(1e-9));
  CHECK(multiplier(c, weight({0, 0, 1}, {"one"})) == doctest::Approx(1.0).epsilon(1e-9));  // lifted
  // Pushed up and along: about the edge, a (h/2 cos + b/2 sin) = b/2.
  const double s = std::sqrt(0.5);
  CHECK(multiplier(c, weight({s, 0, s}, {"other"})) == doctest::Approx(0.2 / (s * 0.5 + s * 0.2)).epsilon(1e-9));
  CHECK(refusal(c, weight({0, 0, -1}, {})).starts_with("has no collapse multiplier in this direction"));
  CHECK(refusal(c, weight({1, 0, 0}, {"none of all"})) == "--on: \"none of all\" is the name of no block, stone or group");
  CHECK(refusal(c, weight({1, 0, 0}, {"othr"})).ends_with("; did you mean \"other\"?"));
  CHECK(refusal(c, weight({1, 0, 0}, {"slab"})) == "--on: \"slab\" is fixed, a load cannot move it");
}

TEST_CASE("live load: a force on a block, at its centroid or at a point") {
  const cases::Case c = blocks().as_case();
  CHECK(multiplier(c, force(100.0, {1, 0, 0}, {"one"})) == doctest::Approx(0.4 * kWeight / 100.0).epsilon(1e-9));
  const double at_top = 0.2 * kWeight / 100.0;
  CHECK(multiplier(c, force(100.0, {1, 0, 0}, {"one"}, Vec3{0.0, 0.15, 1.0})) == doctest::Approx(at_top).epsilon(1e-9));
  CHECK(multiplier(c, force(100.0, {1, 0, 0}, {}, Vec3{-0.5, 0.15, 1.0})) == doctest::Approx(at_top).epsilon(1e-9));  // on its way to "one"
  CHECK(refusal(c, force(100.0, {0, 0, -1}, {}, Vec3{1.0, 0.15, 2.0})).starts_with("--at: no block that can move lies there"));
}

TEST_CASE("live load: loads of the case that grow are the live load, the others are dead") {
  cases::Case c = blocks().as_case();
  cases::Load push;
  push.block = "one", push.force = {50.0, 0, 0}, push.grows = true;
  c.loads.push_back(push);
  cases::Load hold = push;
  hold.force = {-0.1 * kWeight, 0, 0}, hold.grows = false;
  c.loads.push_back(hold);
  solver::LiveLoad growing;
  growing.kind = solver::LiveLoad::Kind::loads;
  CHECK(multiplier(c, growing) == doctest::Approx(0.5 * kWeight / 50.0).epsilon(1e-9));
  CHECK(refusal(c, {}).starts_with("load[0].grows: = true makes this load the live one"));
  c.loads[0].force = {}, c.loads[0].moment = {0, 50.0, 0};  // a moment alone
  CHECK(multiplier(c, growing) == doctest::Approx((0.2 * kWeight + 0.05 * kWeight) / 50.0).epsilon(1e-9));
  c.loads[0].moment = {};
  CHECK(refusal(c, growing) == "has growing loads without a force or moment");
}

TEST_CASE("live load: a point load is weakest at the haunch of an arch, and the path finds it") {
  Masonry arch = dry_arch(24, 1.8, 2.1, 0.5);
  arch.friction = 60.0;
  const cases::Case c = arch.as_case();
  const cases::Model model = cases::build_model(c);
  solver::LimitOptions o;
  o.live.direction = {0, 0, -1};
  o.coulomb = false;
  const std::array<Vec3, 2> line{Vec3{-1.9, 0.25, 3.0}, Vec3{1.9, 0.25, 3.0}};
  const solver::LoadPath path = solver::limit_along_path(c, model, o, line, 21);
  REQUIRE(path.weakest);
  REQUIRE(path.positions.size() == 21);
  const double least = path.positions[*path.weakest].found->associated.multiplier, crown = path.positions[10].found->associated.multiplier;
  CHECK(least < crown);
  CHECK(std::abs(path.positions[*path.weakest].from.x) > 0.3);
  for (std::size_t k = 0; k < 21; ++k) {  // the arch is its own mirror image
    const auto &here = path.positions[k].found, &there = path.positions[20 - k].found;
    REQUIRE(here.has_value() == there.has_value());
    if (here) CHECK(here->associated.multiplier == doctest::Approx(there->associated.multiplier).epsilon(1e-8));
    if (here) CHECK(here->associated.multiplier >= least);
  }
  const solver::LiveLoad there = force(1000.0, {0, 0, -1}, {}, path.positions[*path.weakest].place.at);
  CHECK(multiplier(c, there) == doctest::Approx(least).epsilon(1e-9));
}

TEST_CASE("live load: a load meets the first element on its way, and of two that meet there the nearer one") {
  const cases::Model model = cases::build_model(blocks().as_case());
  const auto name = [&](Vec3 from, Vec3 direction) {
    const cases::LoadedPlace p = cases::place_of_load(model, from, direction);
    return p.element < 0 ? std::string("nothing") : model.blocks[static_cast<std::size_t>(p.element)].name;
  };
  CHECK(name({0.1, 0.1, 5.0}, {0, 0, -1}) == "one");
  CHECK(name({0.1, 0.1, 0.5}, {0, 0, -1}) == "one");  // inside
  CHECK(name({1.0, 0.1, 5.0}, {0, 0, -1}) == "slab");
  CHECK(name({1.0, 0.1, 0.5}, {1, 0, 0}) == "other");
  CHECK(name({1.0, 0.1, 5.0}, {0, 0, 1}) == "nothing");
}

TEST_SUITE_END();

}  // namespace voussoir::testing
