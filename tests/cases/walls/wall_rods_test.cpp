// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cases/refused.h"
#include "tests/cases/walls/plan_spans.h"

using namespace voussoir;
using namespace voussoir::cases;
using namespace voussoir::testing;

// Rods of [[wall_tie]], by side and height.
namespace {

HouseTie rods(HouseTieKind kind, std::vector<std::string> walls) {
  HouseTie t;
  t.bar.name = "rods", t.bar.area = 1e-4, t.bar.plate = std::array{0.2, 0.2};
  t.kind = kind, t.walls = std::move(walls), t.heights = {1.5};
  return t;
}

/// A room of 5 m by 4 m, outside, with an inner wall.
Case room() {
  WallSpec outer = closed(wall("outer", {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}}, 0.4, 2.4));
  outer.line = WallLine::right;
  return case_of({outer, wall("inner", {{2.0, 0.4}, {2.0, 3.6}}, 0.4, 2.4)});
}

}  // namespace

TEST_CASE("rods along sides reach through the walls in which these end, wherever the plan stands") {
  for (const double angle : {0.0, 0.7}) {
    CAPTURE(angle);
    Case c = room();
    c.wall_ties = {rods(HouseTieKind::along, {"outer 1", "outer 2", "inner"})};
    const Model m = build_model(moved(c, angle, false));
    REQUIRE(m.ties.size() == 3);
    CHECK(m.ties[0].length == doctest::Approx(5.0).epsilon(1e-6));
    CHECK(m.ties[1].length == doctest::Approx(4.0).epsilon(1e-6));
    CHECK(m.ties[2].length == doctest::Approx(4.0).epsilon(1e-6));
    CHECK(m.ties[2].name.starts_with("rods 3, inner wall"));
    REQUIRE(m.tie_bill.size() == 1);
    CHECK(m.tie_bill[0].ties == 3);
    CHECK(m.tie_bill[0].anchors == 6);
  }
}

TEST_CASE("rods across lie where they are said to, between the outer faces of two sides") {
  Case c = room();
  c.base->z = 0.5;
  c.wall_ties = {rods(HouseTieKind::across, {"outer 2", "outer 4"})};
  c.wall_ties[0].at = {6.0, 8.0};  // 1 m and 3 m from the corner
  const Model m = build_model(c);
  REQUIRE(m.ties.size() == 2);
  CHECK(m.ties[0].length == doctest::Approx(5.0).epsilon(1e-6));
  for (const TieHold& h : m.ties[0].ends[0]) {
    CHECK(h.point.x == doctest::Approx(5.0));
    CHECK(std::abs(h.point.y - 1.0) < 0.2);
    CHECK(std::abs(h.point.z - 2.0) < 0.2);
  }
}

TEST_CASE("a plate of which exactly half lies on a wall holds, wherever the plan stands") {
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    Case c = room();
    c.wall_ties = {rods(HouseTieKind::across, {"outer 2", "outer 4"})};
    c.wall_ties[0].at = {5.0};  // at the corner
    CHECK(build_model(moved(c, 0.1 * i, false)).ties.size() == 1);
  }
}

TEST_CASE("rods of walls that cannot be are refused with the key, the value and what is allowed") {
  using T = HouseTie&;
  const auto refuse = [](const std::function<void(T)>& change, const std::string& key, const std::string& says) {
    Case c = room();
    c.wall_ties = {rods(HouseTieKind::across, {"outer 2", "outer 4"})};
    c.wall_ties[0].at = {6.0};
    check_refused(c, std::function<void(Case&)>([&](Case& x) { change(x.wall_ties[0]); }), key, says);
  };
  refuse([](T t) { t.walls[1] = "outer 5"; }, "wall_tie[0].walls[1]", "did you mean \"outer");
  refuse([](T t) { t.walls = {"outer 2"}; }, "wall_tie[0].walls", "names 1 sides");
  refuse([](T t) { t.at[0] = 4.5; }, "wall_tie[0].at[0]", "4.5 m is not in the outer 2 wall; allowed: 5 to 9 m");
  refuse([](T t) { t.heights[0] = 2.6; }, "wall_tie[0].heights[0]", "the outer 2 wall stands from 0 to 2.4 m");
  refuse([](T t) { t.kind = HouseTieKind::along, t.at = {}, t.depth = 0.5; }, "wall_tie[0].depth",
         "more than the thickness of the outer 2 wall, 0.4 m");
  refuse([](T t) { t.kind = HouseTieKind::along, t.at = {}, t.walls = {}; }, "wall_tie[0].walls", "names no side; wanted one or more");
  Case twice = room();
  twice.wall_ties.assign(2, rods(HouseTieKind::along, {"outer 1"}));
  check_refused(twice, std::function<void(Case&)>([](Case&) {}), "wall_tie[1].name", "\"rods\" is the name of another tie, too");
}
