// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/limit.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/limit/kinematics/mechanism.h"
#include "solver/limit/programme/linear_programme.h"
#include "solver/run/simulation.h"
#include "solver/world/errors.h"

// Limit analysis against closed forms: blocks on a plane, stacks, loads, a tilted base.
namespace voussoir::testing {
namespace {

constexpr double kWidth = 0.4, kDepth = 0.3, kHeight = 1.0;  // m
constexpr double kDensity = 2000.0;                          // kg/m3
constexpr double kWeight = kDensity * 9.8 * kWidth * kDepth * kHeight;

double tangent(double degrees) { return std::tan(degrees * 3.14159265358979323846 / 180.0); }

cases::BlockSpec box(const std::string& name, Vec3 low, Vec3 high) {
  cases::BlockSpec b;
  b.name = name, b.material = "stone", b.box = {{low, high}};
  return b;
}

/// Contact points up to the rim, so that levers are those of the block itself.
cases::Case one_block(double friction) {
  cases::Case c;
  c.materials["stone"] = {kDensity, 1e9, 0.2};
  c.base = cases::Base{};
  c.contact.friction = friction;
  c.segment_rule = geometry::SegmentRule::rim;
  c.blocks.push_back(box("block", {0, 0, 0}, {kWidth, kDepth, kHeight}));
  return c;
}

solver::LimitResult analysed(const cases::Case& c, solver::LimitOptions o = {}) {
  return solver::limit_analysis(c, cases::build_model(c), o);
}

solver::LimitOptions towards(double degrees, int facets = 8, bool outer = false) {
  const double angle = degrees * 3.14159265358979323846 / 180.0;
  solver::LimitOptions o;
  o.live.direction = {std::cos(angle), std::sin(angle), 0.0}, o.facets = facets, o.outer = outer;
  return o;
}

std::string refusal(const cases::Case& c, const solver::LimitOptions& o = {}) {
  try {
    analysed(c, o);
    return "none";
  } catch (const cases::InputError& e) {
    return e.what();
  }
}

cases::Load force_on(const std::string& block, Vec3 force) {
  cases::Load load;
  load.block = block, load.force = force;
  return load;
}

/// On a base, apart from each other: "one", "other" and a fixed one, a group; "cut", of three pieces above one another.
cases::Case stones() {
  cases::Case c = one_block(70.0);
  c.blocks.clear();
  const auto place = [](double x) { return geometry::make_box({x, 0, 0}, {x + kWidth, kDepth, kHeight}); };
  cases::StonesSpec set;
  set.file = "none.obj", set.material = "stone";
  for (const auto& [name, x] : {std::pair{"one", 0.0}, std::pair{"fixed", 1.0}, std::pair{"other", 2.0}})
    set.stones.push_back({name, {"group"}, std::string(name) == "fixed", {{place(x), {}}}, ""});
  cases::Stone cut{"cut", {}, false, {}, ""};
  for (const double z : {0.0, 0.4, 0.6})
    cut.pieces.push_back({geometry::make_box({3.0, 0, z}, {3.0 + kWidth, kDepth, z == 0.0 ? 0.4 : z == 0.4 ? 0.6 : 1.0}), {}});
  set.stones.push_back(cut);
  c.stones.push_back(set);
  return c;
}

bool near(Vec3 a, Vec3 b) { return norm(a - b) < 1e-6; }

}  // namespace

TEST_SUITE_BEGIN("limit analysis" * doctest::skip(!solver::has_linear_programmes()));

TEST_CASE("limit: a block rocks about its edge") {
  const solver::LimitResult r = analysed(one_block(60.0));
  CHECK(r.plane);
  CHECK(r.weight == doctest::Approx(kWeight));
  CHECK(r.associated.multiplier == doctest::Approx(kWidth / kHeight).epsilon(1e-9));
  CHECK(r.coulomb.multiplier == doctest::Approx(kWidth / kHeight).epsilon(1e-6));
  CHECK(r.coulomb_proven());
  CHECK(r.associated.proof.forces.worst() < 1e-9);
  CHECK(r.associated.proof.motion.off_normal < 1e-9);
  CHECK(r.associated.proof.upper == doctest::Approx(r.associated.proof.lower).epsilon(1e-9));
  const solver::Mechanism m = solver::mechanism_of(r.contacts, r.associated);
  REQUIRE(m.parts.size() == 1);
  const kernels::Twist t = m.parts[0].motion;
  CHECK(near(t.w / norm(t.w), {0, 1, 0}));
  CHECK(near(t.v + cross(t.w, Vec3{kWidth, 0.5 * kDepth, 0} - m.parts[0].centre), {}));  // the edge rests
  REQUIRE(m.seams.size() == 1);
  CHECK(m.seams[0].hinge);
  CHECK(m.standing == 0.0);
}

TEST_CASE("limit: a block slides; Coulomb's slip does not lift it") {
  const solver::LimitResult r = analysed(one_block(15.0));
  CHECK(r.associated.multiplier == doctest::Approx(tangent(15.0)).epsilon(1e-9));
  CHECK(r.coulomb.multiplier == doctest::Approx(tangent(15.0)).epsilon(1e-6));
  const Vec3 up = r.associated.motion[0].v, level = r.coulomb.motion[0].v;
  CHECK(up.z / up.x == doctest::Approx(tangent(15.0)).epsilon(1e-6));
  CHECK(std::abs(level.z) < 1e-9 * level.x);
}

TEST_CASE("limit: the friction of a joint is that of its law without the bond; only tension and cohesion are a bond") {
  cases::Case c = one_block(15.0);
  cases::JointLaw& law = c.joint_laws["bed"];
  law.friction = 40.0, law.compression = 1e6;  // as cases/README.md writes a dry joint: no tension, no cohesion
  c.joints.default_law = "bed";
  CHECK(analysed(c).associated.multiplier == doctest::Approx(tangent(15.0)).epsilon(1e-9));
  CHECK(analysed(c).contacts.bonded == 0);
  law.residual_friction = 10.0;
  CHECK(analysed(c).associated.multiplier == doctest::Approx(tangent(10.0)).epsilon(1e-9));
  law.cohesion = 1e4;
  CHECK(analysed(c).associated.multiplier == doctest::Approx(tangent(10.0)).epsilon(1e-9));
  CHECK(analysed(c).contacts.bonded == 1);
  law.normal_stiffness = law.shear_stiffness = 1e9, law.maximum_closure = 1e-3;  // such a joint has no bond, whatever its cohesion
  CHECK(analysed(c).contacts.bonded == 0);
}

TEST_CASE("limit: facets in the friction cone and round it bracket the cone") {
  // A dead force across the live one of a tenth of the weight turns the shear away from the corner of a facet.
  const double exact = std::sqrt(tangent(15.0) * tangent(15.0) - 0.01);
  const auto pushed = [](double degrees) {
    cases::Case c = one_block(15.0);
    cases::Load load;
    const double angle = degrees * 3.14159265358979323846 / 180.0;
    load.block = "block", load.force = 0.1 * kWeight * Vec3{-std::sin(angle), std::cos(angle), 0.0};
    c.loads.push_back(load);
    return c;
  };
  for (const double degrees : {0.0, 10.0, 22.5, 77.0}) {
    const solver::LimitResult in = analysed(pushed(degrees), towards(degrees)), out = analysed(pushed(degrees), towards(degrees, 8, true));
    INFO(degrees);
    const auto shear = [](const solver::LimitResult& r) { return std::hypot(r.associated.multiplier, 0.1) / tangent(15.0); };
    CHECK(in.associated.multiplier < exact);
    CHECK(shear(in) >= 1.0 - in.cone_error - 1e-9);
    CHECK(out.associated.multiplier > exact);
    CHECK(shear(out) <= 1.0 + out.cone_error + 1e-9);
  }
  CHECK(analysed(one_block(15.0), towards(33.0)).cone_error == doctest::Approx(1.0 - std::cos(3.14159265358979323846 / 8.0)));
  CHECK(analysed(pushed(33.0), towards(33.0, 64)).associated.multiplier == doctest::Approx(exact).epsilon(1.3e-3));
}

TEST_CASE("limit: askew, a block tips over its corner's edges: the lesser of two") {
  // About the edge at x = width: live × cos × h/2 = width/2; about that at y = depth: live × sin × h/2 = depth/2.
  const double degrees = 20.0, c = std::cos(degrees * 3.14159265358979323846 / 180.0),
               s = std::sin(degrees * 3.14159265358979323846 / 180.0);
  CHECK(analysed(one_block(70.0), towards(degrees)).associated.multiplier ==
        doctest::Approx(std::min(kWidth / (kHeight * c), kDepth / (kHeight * s))).epsilon(1e-6));
}

TEST_CASE("limit: points at the centres of segments shorten the lever") {
  cases::Case c = one_block(60.0);
  c.segment_rule = geometry::SegmentRule::centres, c.segment_size = 0.1;
  CHECK(analysed(c).associated.multiplier == doctest::Approx(kWidth * (1.0 - 1.0 / 4.0) / kHeight).epsilon(1e-9));
}

TEST_CASE("limit: dead loads do not grow, and count where they act") {
  cases::Case c = one_block(70.0);
  cases::Load load;
  load.block = "block", load.force = {0.0, 0.0, -2.0 * kWeight}, load.at = Vec3{0.25 * kWidth, 0.5 * kDepth, kHeight};
  c.loads.push_back(load);
  // About the edge: live × h/2 = width/2 + 2 × 3/4 width.
  CHECK(analysed(c).associated.multiplier == doctest::Approx(4.0 * kWidth / kHeight).epsilon(1e-6));
  CHECK(analysed(c).has_loads);
  CHECK_FALSE(analysed(c).is_tilt);
  CHECK(analysed(one_block(70.0)).is_tilt);
}

TEST_CASE("limit: a load on a group acts on each of its stones that is free, one on a stone in pieces on the whole") {
  cases::Case c = stones();
  const auto multiplier = [&](const std::vector<std::string>& loaded) {
    c.loads.clear();
    for (const std::string& name : loaded) c.loads.push_back(force_on(name, {0.0, 0.2 * kWeight, 0.0}));
    return analysed(c, towards(90.0)).associated.multiplier;
  };
  const double all = multiplier({"one", "other"});
  CHECK(all < multiplier({}) - 0.05);
  CHECK(multiplier({"group"}) == all);
  CHECK(multiplier({"cut"}) == doctest::Approx(multiplier({"cut/2"})).epsilon(1e-9));  // its middle piece has the centroid of the whole
  CHECK(multiplier({"cut"}) < multiplier({}) - 0.05);
}

TEST_CASE("limit: a tilted base has taken its share") {
  cases::Case c = one_block(60.0);
  c.base->tilt = {0.0, 5.0};
  CHECK_FALSE(analysed(c).is_tilt);  // what it adds to a tilt is no tangent
  const double angle = 5.0 * 3.14159265358979323846 / 180.0, slope = kWidth / kHeight;
  const double one = analysed(c, towards(0.0)).associated.multiplier, other = analysed(c, towards(180.0)).associated.multiplier;
  CHECK(std::min(one, other) == doctest::Approx(slope * std::cos(angle) - std::sin(angle)).epsilon(1e-6));
  CHECK(std::max(one, other) == doctest::Approx(slope * std::cos(angle) + std::sin(angle)).epsilon(1e-6));
}

TEST_CASE("limit: a stack parts at its weakest bed; no associated factor is below Coulomb's") {
  cases::Case c = one_block(60.0);
  c.blocks.push_back(box("top", {0.1, 0, kHeight}, {0.3, kDepth, kHeight + 1.0}));
  const solver::LimitResult r = analysed(c);
  CHECK(r.associated.multiplier == doctest::Approx(0.2).epsilon(1e-9));  // the upper block on its own
  const solver::Mechanism m = solver::mechanism_of(r.contacts, r.associated);
  REQUIRE(m.parts.size() == 1);
  CHECK(m.standing == doctest::Approx(kDensity * kWidth * kDepth * kHeight));
  CHECK(r.coulomb.multiplier <= r.associated.multiplier * (1.0 + 1e-9));
}

TEST_CASE("limit: the interior-point method, for houses, gives what Clp gives") {
  cases::Case c = one_block(40.0);
  c.blocks.push_back(box("middle", {-0.05, 0.0, kHeight}, {0.35, 0.25, kHeight + 0.3}));
  c.blocks.push_back(box("top", {0.0, 0.05, kHeight + 0.3}, {0.3, 0.3, kHeight + 0.8}));
  for (const double degrees : {0.0, 20.0, 75.0, 200.0}) {
    INFO(degrees);
    solver::LimitOptions inside = towards(degrees);
    inside.inside_from = 0;
    const solver::LimitResult clp = analysed(c, towards(degrees)), r = analysed(c, inside);
    CHECK(r.associated.multiplier == doctest::Approx(clp.associated.multiplier).epsilon(1e-6));
    CHECK(r.coulomb.multiplier == doctest::Approx(clp.coulomb.multiplier).epsilon(1e-4));
    CHECK(r.associated.proof.holds);
    for (std::size_t b = 0; b < c.blocks.size(); ++b) {
      CHECK(norm(r.associated.motion[b].v - clp.associated.motion[b].v) < 1e-4);
      CHECK(norm(r.associated.motion[b].w - clp.associated.motion[b].w) < 1e-3);
    }
  }
  solver::LimitOptions inside;
  inside.inside_from = 0;
  cases::Case leaning = one_block(30.0);
  leaning.base->tilt = {0.0, 31.0};
  CHECK(refusal(leaning, inside).starts_with("does not stand under its dead loads alone"));
}

TEST_CASE("limit: what cannot be answered is refused in words") {
  cases::Case weightless = one_block(30.0);
  weightless.gravity.acceleration = {};
  CHECK(refusal(weightless).starts_with("gravity.acceleration: is zero"));
  cases::Case leaning = one_block(30.0);
  leaning.base->tilt = {0.0, 31.0};
  CHECK(refusal(leaning).starts_with("does not stand under its dead loads alone"));
  cases::Case fixed = one_block(30.0);
  fixed.blocks[0].fixed = true;
  CHECK(refusal(fixed).starts_with("has no block that could move"));
  cases::Case shaken = one_block(30.0);
  shaken.loads.push_back(force_on("block", {}));
  shaken.loads[0].history = "push.csv";
  CHECK(refusal(shaken) == "load[0].history: does not go with limit analysis, which knows no time; allowed: force");
  cases::Case loaded = stones();
  loaded.loads.push_back(force_on("fixed", {0.0, 1.0, 0.0}));
  CHECK(refusal(loaded) == "load[0].block: \"fixed\" is fixed, a load cannot move it");
  const cases::Model built = cases::build_model(loaded);
  CHECK_THROWS_WITH(solver::Simulation(loaded, built, {}, {}), "load[0].block: \"fixed\" is fixed, a load cannot move it");  // a run, too
  loaded.loads[0].block = "group";
  CHECK(refusal(loaded) == "none");
  cases::Case boxed = one_block(30.0);  // between two fixed blocks as high as itself
  for (const double x : {-0.2, kWidth}) {
    boxed.blocks.push_back(box("stop" + std::to_string(boxed.blocks.size()), {x, 0, 0}, {x + 0.2, kDepth, kHeight}));
    boxed.blocks.back().fixed = true;
  }
  CHECK(refusal(boxed).starts_with("has no collapse multiplier in this direction"));
}

TEST_CASE("limit: where the interior-point method does not converge, that is said, not that the structure falls") {
  cases::Case c = one_block(60.0);  // pressed so hard on its base that numbers overflow
  c.loads.push_back(force_on("block", {0.0, 0.0, -1e200}));
  solver::LimitOptions inside;
  inside.inside_from = 0;
  std::string said;
  try {
    analysed(c, inside);
  } catch (const solver::NumericalError& e) {
    said = e.what();
  }
  INFO(said);
  CHECK(said.find("to the accuracy needed") != std::string::npos);
  CHECK(said.find("does not stand") == std::string::npos);
}

TEST_SUITE_END();

}  // namespace voussoir::testing
