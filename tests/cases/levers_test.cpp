// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/levers.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;

namespace {

Case two_blocks(double size) {
  Case c;
  c.materials["stone"] = {2000.0, 1e9, 0.2};
  c.base = Base{};
  c.segment_size = size;
  for (int k = 0; k < 2; ++k) {
    BlockSpec b;
    b.name = "b" + std::to_string(k), b.material = "stone";
    b.box = {{Vec3{0.0, 0.0, 0.5 * k}, Vec3{0.4, 0.2, 0.5 * (k + 1)}}};
    c.blocks.push_back(b);
  }
  return c;
}

}  // namespace

TEST_CASE("levers of walls: a segment of the wall's bricks over the thickness") {
  const Case c = testing::paper_flat40();  // bearing walls of 0.4 m, the others of 0.2 m
  const std::vector<Lever> l = levers(c, build_model(c));
  REQUIRE(l.size() == 2);
  CHECK(l[0].width == 0.4);
  CHECK(l[0].segments == 16.0);
  CHECK(l[1].width == 0.2);
  CHECK(l[1].short_by() == 0.125);
  CHECK(l[1].height == 2.4);
  CHECK(levers(testing::paper_flat20(), build_model(testing::paper_flat20())).size() == 1);
}

TEST_CASE("levers of walls: none of walls that are not built") {
  Case c = testing::paper_flat40();
  c.house->walls = {"front"}, c.house->roof.kind = RoofKind::none, c.output.history.clear();
  const std::vector<Lever> front = levers(c, build_model(c));
  REQUIRE(front.size() == 1);
  CHECK(front[0].width == 0.4);
  c.house->walls = {"left"}, c.house->openings.clear();
  const std::vector<Lever> left = levers(c, build_model(c));
  REQUIRE(left.size() == 1);
  CHECK(left[0].width == 0.2);
}

TEST_CASE("levers of free blocks: the joint with the fewest segments across, found from its points") {
  for (const int n : {1, 2, 4}) {
    const Case c = two_blocks(0.2 / n);
    const std::vector<Lever> l = levers(c, build_model(c));
    REQUIRE(l.size() == 1);
    CHECK(l[0].segments == doctest::Approx(n).epsilon(1e-6));
    CHECK(l[0].width == doctest::Approx(0.2).epsilon(1e-6));
    CHECK(l[0].joint == 0);
  }
}

TEST_CASE("levers: none is short under the rule of the rim") {
  Case c = two_blocks(0.05);
  c.segment_rule = geometry::SegmentRule::rim;
  CHECK(levers(c, build_model(c)).empty());
}

TEST_CASE("levers: a round joint has no number of segments across") {
  Case c = two_blocks(0.05);
  for (BlockSpec& b : c.blocks) {  // sixteen-sided, with its axis along x
    const double x = b.name == "b0" ? 0.0 : 0.5;
    b.box.reset();
    b.extrude = {{x, x + 0.5}};
    for (int k = 0; k < 16; ++k)
      b.polygon.push_back({0.4 * std::cos(k * 0.3926990816987241), 0.5 + 0.4 * std::sin(k * 0.3926990816987241)});
    b.free = true;
  }
  c.base.reset();
  const Model m = build_model(c);
  REQUIRE(m.assembly.joints.size() == 1);
  CHECK(levers(c, m).empty());
}

TEST_CASE("points at the corners: four of a joint of two boxes, and none with a bond") {
  Case c = two_blocks(0.05);
  c.segment_rule = geometry::SegmentRule::corners;
  const Model m = build_model(c);
  CHECK(levers(c, m).empty());
  REQUIRE(m.assembly.joints.size() == 2);
  for (const geometry::Joint& j : m.assembly.joints) {
    REQUIRE(j.side_a.size() == 4);
    for (const geometry::Segment& p : j.side_a) {
      CHECK(std::abs(p.s) == doctest::Approx(0.2));
      CHECK(std::abs(p.t) == doctest::Approx(0.1));
      CHECK(p.area == doctest::Approx(0.02));
    }
  }
  c.joint_laws["mortar"].tension = 1e4, c.joint_laws["mortar"].compression = 1e6;
  testing::check_refused(
      c, [](Case& x) { x.joints.default_law = "mortar"; }, "segments.rule", "block \"b0\" (element 0) and the base has the law \"mortar\"");
  testing::check_refused(
      c,
      [](Case& x) {
        x.joints.between.push_back({{"stone", "stone"}, "mortar"});
      },
      "segments.rule", "block \"b0\" (element 0) and block \"b1\" (element 1) has the law \"mortar\"");
  c.joint_laws["mortar"].tension = 0.0;
  c.joints.default_law = "mortar";  // neither tension nor cohesion
  CHECK_NOTHROW(build_model(c));
}
