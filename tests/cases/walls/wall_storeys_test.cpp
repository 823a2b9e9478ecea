// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <string>

#include "tests/cases/walls/plan_spans.h"

using namespace voussoir;
using namespace voussoir::cases;
using namespace voussoir::testing;

// Storeys and gables of walls of any plan, by the tags of their bricks.
namespace {

/// A room of 5 m by 4 m.
WallSpec room(std::string name, double base, double height, double thickness = 0.4) {
  WallSpec w = closed(wall(std::move(name), {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}}, thickness, height));
  w.line = WallLine::right, w.base = base;
  return w;
}

/// The range of heights of each part [m].
std::map<std::string, std::array<double, 2>> parts_of(const Case& c) {
  std::map<std::string, std::array<double, 2>> all;
  for (const Block& b : build_model(c).blocks) {
    if (b.kind != PartKind::walling && b.kind != PartKind::arch_stone) continue;
    auto& [low, high] = all.try_emplace(b.tag, std::array{1e9, -1e9}).first->second;
    for (const Vec3& v : b.shape.vertices) low = std::min(low, v.z), high = std::max(high, v.z);
  }
  return all;
}

void check_part(const std::map<std::string, std::array<double, 2>>& parts, const std::string& name, double low, double high) {
  CAPTURE(name);
  REQUIRE(parts.contains(name));
  CHECK(parts.at(name)[0] == doctest::Approx(low));
  CHECK(parts.at(name)[1] == doctest::Approx(high));
}

}  // namespace

TEST_CASE("walls without walls or floors on them have no storeys") {
  const auto parts = parts_of(case_of({room("low", 0.0, 2.0)}));
  CHECK(parts.size() == 4);
  check_part(parts, "low 1 wall", 0.0, 2.0);
}

TEST_CASE("a wall upon another is its next storey, whatever stands beside it") {
  WallSpec tower = room("tower", 3.6, 1.2);
  tower.points = {{0.0, 0.0}, {2.4, 0.0}, {2.4, 4.0}, {0.0, 4.0}};
  WallSpec shed = wall("shed", {{5.0, 1.0}, {7.0, 1.0}}, 0.4, 2.0);
  const auto parts = parts_of(case_of({room("low", 0.0, 2.0), room("high", 2.0, 1.6, 0.2), tower, shed}));
  check_part(parts, "low 1 wall, storey 1", 0.0, 2.0);
  check_part(parts, "high 1 wall, storey 2", 2.0, 3.6);
  check_part(parts, "tower 1 wall, storey 3", 3.6, 4.8);
  check_part(parts, "shed wall, storey 1", 0.0, 2.0);
}

TEST_CASE("floors part the walls in which their beams lie, and those round their rooms; low parts are none") {
  Case c = case_of({room("outer", 0.0, 5.2), wall("apart", {{9.0, 0.0}, {9.0, 3.0}}, 0.4, 5.2)});
  c.floors = {floor_between("first", {"outer 1", "outer 3"}), floor_between("attic", {"outer 1", "outer 3"})};
  c.floors[0].level = 2.4, c.floors[1].level = 4.8;  // 0.4 m of wall above the second
  const auto parts = parts_of(c);
  CHECK(parts.size() == 9);
  for (const char* side : {"outer 1", "outer 2", "outer 3", "outer 4"}) {
    check_part(parts, std::string(side) + " wall, storey 1", 0.0, 2.4);
    check_part(parts, std::string(side) + " wall, storey 2", 2.4, 5.2);
  }
  check_part(parts, "apart wall, storey 1", 0.0, 5.2);
}

TEST_CASE("a high wall has the storeys of the walls that meet it") {
  WallSpec upper = wall("upper", {{2.0, 0.4}, {2.0, 3.0}}, 0.4, 2.0);
  upper.base = 2.4;
  WallSpec lower = wall("lower", {{2.0, 0.4}, {2.0, 3.0}}, 0.4, 2.4);
  const auto parts = parts_of(case_of({wall("front", {{0.0, 0.2}, {5.0, 0.2}}, 0.4, 4.4), lower, upper}));
  check_part(parts, "lower wall, storey 1", 0.0, 2.4);
  check_part(parts, "upper wall, storey 2", 2.4, 4.4);
  check_part(parts, "front wall, storey 1", 0.0, 2.4);
  check_part(parts, "front wall, storey 2", 2.4, 4.4);
}

TEST_CASE("what rises above the height of a wall is its gable, in its uppermost storey") {
  for (const bool two : {false, true}) {
    CAPTURE(two);
    std::vector<WallSpec> walls{room("outer", 0.0, 2.0), wall("askew", {{8.0, 0.0}, {10.0, 3.0}}, 0.4, 2.0)};
    if (two) walls.push_back(room("upper", 2.0, 2.0));
    walls[1].gable = 3.2;
    Case c = case_of(walls);
    c.roofs = {two ? roof_between("roof", {"upper 1", "upper 3"}, {"upper 2"}) : roof_between("roof", {"outer 1", "outer 3"}, {"outer 2"})};
    const auto parts = parts_of(c);
    const std::string storey = two ? ", storey 2" : "";
    const std::string side = two ? "upper" : "outer";
    check_part(parts, side + " 2 wall" + storey, two ? 2.0 : 0.0, two ? 4.0 : 2.0);
    REQUIRE(parts.contains(side + " 2 gable" + storey));
    CHECK(parts.at(side + " 2 gable" + storey)[0] == doctest::Approx(two ? 4.0 : 2.0));
    CHECK(parts.at(side + " 2 gable" + storey)[1] > (two ? 4.9 : 2.9));
    CHECK_FALSE(parts.contains(side + " 4 gable" + storey));
    check_part(parts, two ? "askew walling, storey 1" : "askew walling", 0.0, 2.0);
    check_part(parts, two ? "askew gable, storey 1" : "askew gable", 2.0, 3.2);
  }
}

TEST_CASE("a side of some bricks and a half has as many of them wherever the plan stands") {
  WallSpec low = closed(wall("low", {{0.0, 0.0}, {3.4, 0.0}, {3.4, 3.4}, {0.0, 3.4}}, 0.2, 3.0, WallBond::running));
  low.line = WallLine::right, low.brick = {0.4, 0.2, 0.2};
  WallSpec high = low;
  high.name = "high", high.base = 3.0;
  const Case c = case_of({low, high});
  const Model here = build_model(c);
  for (int i = 1; i < 12; ++i) {
    CAPTURE(i);
    check_same(here, build_model(moved(c, 0.55 * i, i % 2 == 0)));
  }
}
