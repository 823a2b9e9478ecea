// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "cases/case.h"
#include "cases/loads/moving_load.h"
#include "cases/model.h"
#include "cases/solids/origin.h"

using namespace voussoir;

// Loads at a place, and loads that move.

namespace {

constexpr double kLeft = 1.0, kEnd = 2.0;  // m

/// Two blocks of 1.0 x 0.5 x 0.5 m in a row, on a base.
cases::Case two_blocks() {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e9, 0.2};
  c.base = cases::Base{};
  const double ends[] = {0.0, kLeft, kEnd};
  for (int i = 0; i < 2; ++i) {
    cases::BlockSpec b;
    b.name = i == 0 ? "left" : "right", b.material = "stone";
    b.box = {{Vec3{ends[i], 0.0, 0.0}, Vec3{ends[i + 1], 0.5, 0.5}}};
    c.blocks.push_back(b);
  }
  return c;
}

cases::Load weight_at(Vec3 at) {
  cases::Load load;
  load.force = {0.0, 0.0, -1000.0}, load.at = at;
  return load;
}

const cases::SupportHistory kWay{{0.0, 1.0, 1.5, 3.0}, {{0.1, 0.2, 4.0}, {0.6, 0.3, 4.0}, {0.6, 0.3, 4.0}, {1.9, 0.2, 4.0}}, false, "", ""};

}  // namespace

TEST_CASE("load: without a block it acts on the first one that its force meets from its point on") {
  const cases::Model m = cases::build_model(two_blocks());
  const auto at = [&](Vec3 p) { return cases::load_shares(m, weight_at(p), 0).at(0); };
  CHECK(m.blocks[static_cast<std::size_t>(at({0.3, 0.2, 7.0}).element)].name == "left");
  CHECK(norm(at({0.3, 0.2, 7.0}).point - Vec3{0.3, 0.2, 0.5}) < 1e-8);
  CHECK(m.blocks[static_cast<std::size_t>(at({1.3, 0.2, 0.4}).element)].name == "right");  // inside: there
  CHECK(at({1.3, 0.2, 0.4}).point == Vec3{1.3, 0.2, 0.4});
  CHECK_THROWS_WITH_AS(at({0.3, 0.9, 7.0}), "load[0].at: no block lies at [0.3, 0.9, 7], or behind it along the force", cases::InputError);
}

TEST_CASE("load: what meets a fixed block is refused") {
  cases::Case c = two_blocks();
  c.blocks[0].fixed = true;
  const cases::Model m = cases::build_model(c);
  CHECK_THROWS_WITH_AS(cases::load_shares(m, weight_at({0.3, 0.2, 7.0}), 2),
                       "load[2].at: the force at [0.3, 0.2, 7] meets \"left\", which is fixed", cases::InputError);
}

TEST_CASE("load: resultant and moment of one that moves are those of a force at its place, at any time") {
  const cases::Model m = cases::build_model(two_blocks());
  cases::Load load;
  load.force = {0.0, 0.0, -1000.0}, load.path = "way.csv";
  const std::vector<cases::MovingShare> shares = cases::moving_shares(m, load, 0, kWay);
  CHECK(shares.size() > 10);
  for (const double t : {0.0, 0.3, 0.777, 1.0, 1.2, 1.5, 2.0, 2.9, 3.0, 10.0}) {
    Vec3 force, moment;
    for (const cases::MovingShare& s : shares) {
      const Vec3 f = cases::value_at(s.force, t);
      force += f, moment += cross(s.share.point, f);
    }
    Vec3 place = cases::value_at(kWay, t);
    place.z = 0.5;
    CAPTURE(t);
    CHECK(norm(force - load.force) < 1e-9);
    CHECK(norm(moment - cross(place, load.force)) < 1e-9);
  }
  for (const cases::MovingShare& s : shares) CHECK(cases::value_at(s.force, -1e-6) == Vec3{});
}

TEST_CASE("load: a path that leaves the model is refused, with the place") {
  const cases::Model m = cases::build_model(two_blocks());
  cases::Load load;
  load.force = {0.0, 0.0, -1000.0}, load.path = "way.csv";
  const cases::SupportHistory off{{0.0, 1.0}, {{1.5, 0.2, 4.0}, {2.5, 0.2, 4.0}}, false, "", ""};
  CHECK_THROWS_WITH_AS(cases::moving_shares(m, load, 1, off), doctest::Contains("load[1].path: no block lies at [2.0"), cases::InputError);
}

TEST_CASE("load: places of a model far from the origin are those of the case file") {
  cases::Case c = two_blocks();
  const Vec3 far{1e6, -3e6, 100.0};
  for (cases::BlockSpec& b : c.blocks)
    for (Vec3& corner : *b.box) corner += far;
  c.base->z += far.z;
  cases::Load load;
  load.force = {0.0, 0.0, -1000.0}, load.path = "way.csv";
  cases::SupportHistory way = kWay;
  for (Vec3& p : way.displacement) p += far;
  const auto near = cases::moving_shares(cases::build_model(two_blocks()), load, 0, kWay);
  cases::move_origin(c, far);
  const cases::Model m = cases::build_model(c);
  REQUIRE(m.origin == far);
  const auto there = cases::moving_shares(m, load, 0, way);
  REQUIRE(near.size() == there.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    CHECK(near[i].share.element == there[i].share.element);
    CHECK(norm(near[i].share.point + far - (there[i].share.point + m.origin)) < 1e-6);
  }
}

TEST_CASE("push direction: along vertical loads that grow, else that of the analysis") {
  cases::Case c = two_blocks();
  c.analysis.kind = cases::AnalysisKind::pushover, c.analysis.direction = {0.0, -2.0};
  CHECK(cases::push_direction(c) == Vec3{0.0, -1.0, 0.0});
  c.analysis.direction = {0.0, -1e300};
  CHECK(cases::push_direction(c) == Vec3{0.0, -1.0, 0.0});
  c.analysis.pattern = cases::LoadPattern::given;
  c.loads.push_back(weight_at({0.3, 0.2, 7.0}));
  c.loads[0].grows = true;
  CHECK(cases::push_direction(c) == Vec3{0.0, 0.0, -1.0});
  c.loads[0].force.x = 10.0;
  CHECK(cases::push_direction(c) == Vec3{0.0, -1.0, 0.0});
}
