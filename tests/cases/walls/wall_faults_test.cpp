// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <functional>

#include "cases/walls/walls.h"
#include "tests/cases/refused.h"
#include "tests/cases/walls/plan_walls.h"

using namespace voussoir;
using namespace voussoir::cases;
using namespace voussoir::testing;

namespace {

WallOpening opening(double from, double width, double sill, double height) { return {from, width, sill, height, {}, {}}; }

/// A corner with an inner wall on it, which is good.
Case good() {
  Case c = case_of({wall("outer", {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}}, 0.4, 2.4), wall("inner", {{2.0, 0.0}, {2.0, 3.0}}, 0.2, 2.4)});
  c.walls[0].openings = {opening(2.8, 1.0, 0.0, 2.0)};
  return c;
}

void refuse(const std::function<void(std::vector<WallSpec>&)>& change, const std::string& key, const std::string& says) {
  check_refused(good(), std::function<void(Case&)>([&](Case& c) { change(c.walls); }), key, says);
}

}  // namespace

TEST_CASE("a good plan of walls is built") { CHECK(!build_model(good()).blocks.empty()); }

TEST_CASE("walls that cannot be laid are refused with the key, the value and what is allowed") {
  using Walls = std::vector<WallSpec>;
  refuse([](Walls& w) { w[1].name = "outer"; }, "wall[1].name", "\"outer\" is already the name of wall[0]");
  refuse([](Walls& w) { w[1].points.pop_back(); }, "wall[1].points", "are 1; a wall needs 2 or more");
  refuse([](Walls& w) { w[0].points[2] = {5.0, 0.05}; }, "wall[0].points", "from point 2 to point 3 are 0.05 m");
  refuse(
      [](Walls& w) {
        w[0].points[2] = {1.0, 0.5};
      },
      "wall[0].points", "point 2: the sides there enclose 7.1 degrees; allowed: 30 or more");
  refuse([](Walls& w) { w[0].points[2] = {9.0, 1.0}; }, "wall[0].bond", "allowed: \"through\"");
  refuse([](Walls& w) { w[1].thickness = 0.1; }, "wall[1].thickness", "at least 0.134 m");
  refuse([](Walls& w) { w[1].brick[2] = 0.1; }, "wall[1].brick", "0.1 m high, but walls that meet have the same courses; allowed: 0.2 m");
  refuse([](Walls& w) { w[1].material = "clay"; }, "wall[1].material", "clay");
  refuse([](Walls& w) { w[1].points = {{1.0, 0.1}, {4.0, 0.1}}; }, "wall[1].points", "overlap at an angle below 30 degrees");
}

TEST_CASE("places along a wall are refused with what lies there") {
  using Walls = std::vector<WallSpec>;
  refuse([](Walls& w) { w[0].openings[0].from = 1.5; }, "wall[0].opening[0].from",
         "1.5 m: the outer 1 wall would be open from 1.5 to 2.5 m along the line of the wall, and the inner wall meets it from 1.9 to 2.1 "
         "m; at least 0.08 m of wall, "
         "a fifth of a brick, must lie between them; nearest: 2.18 m");
  refuse([](Walls& w) { w[0].openings[0].from = 4.2, w[0].openings[0].width = 0.6; }, "wall[0].opening[0].from", "nearest: 4.12 m");
  refuse([](Walls& w) { w[0].openings[0].from = 2.12, w[0].openings[0].width = 2.6; }, "wall[0].opening[0].from", "no room for it");
  refuse([](Walls& w) { w[0].openings[0].from = 4.5; }, "wall[0].opening[0].from", "does not go round a corner");
  refuse([](Walls& w) { w[0].openings[0].from = 0.03; }, "wall[0].opening[0].from", "and it begins at 0 m; at least 0.08 m");
  refuse([](Walls& w) { w[0].openings[0].height = 2.5; }, "wall[0].opening[0].height", "above the wall (2.4 m); at most 2.4 m");
  refuse([](Walls& w) { w[0].openings[0].sill = 2.4; }, "wall[0].opening[0].sill", "0 to below the height of the wall, 2.4 m");
  refuse([](Walls& w) { w[0].openings[0].height = 2.38; }, "wall[0].opening[0].height", "nearest: 2.4 m");
  refuse([](Walls& w) { w[0].openings[0].lintel = WallLintel{0.03, 0.2, {}}; }, "wall[0].opening[0].lintel.bearing", "at least 0.08 m");
  refuse(
      [](Walls& w) {
        w[0].openings[0].lintel = WallLintel{0.2, 0.5, {}};
      },
      "wall[0].opening[0].lintel.height", "0.5 m ends at 2.5 m, above the wall (2.4 m)");
  refuse([](Walls& w) { w[0].openings.push_back(opening(3.85, 0.5, 1.0, 1.0)); }, "wall[0].opening[1].from",
         "and wall[0].opening[0].from is from 2.8 to 3.8 m");
  refuse([](Walls& w) { w[0].openings[0].lintel = WallLintel{0.7, 0.2, {}}; }, "wall[0].opening[0].lintel.bearing", "nearest: 0.62 m");
}

TEST_CASE("arches of walls are refused with their keys") {
  using Walls = std::vector<WallSpec>;
  const auto with = [](Arch arch) { return [arch](Walls& w) { w[0].openings[0].height = 1.5, w[0].openings[0].arch = arch; }; };
  refuse(with({0.6, 0.3, 0.25, {}, {}}), "wall[0].opening[0].arch.rise", "0.6 m; allowed: 0 (a flat arch) to 0.5 m");
  refuse(with({0.3, 0.05, 0.25, {}, {}}), "wall[0].opening[0].arch.thickness", "less than half a course; at least 0.1 m");
  refuse(with({0.3, 0.7, 0.25, {}, {}}), "wall[0].opening[0].arch.thickness", "0.7 m ends at 2.5 m, above the wall (2.4 m)");
  refuse(with({0.3, 0.3, 0.1, {}, {}}), "wall[0].opening[0].arch.springer", "less than half a brick; at least 0.2 m");
  refuse(with({0.3, 0.3, 0.65, {}, {}}), "wall[0].opening[0].arch.springer", "nearest: 0.62 m");
  refuse(with({0.3, 0.3, 0.25, 50, {}}), "wall[0].opening[0].arch.voussoirs", "50 voussoirs; allowed: 3 to");
  refuse(with({0.3, 0.3, 0.25, {}, "clay"}), "wall[0].opening[0].arch.material", "clay");
}

TEST_CASE("all faults of walls are told at once") {
  Case c = good();
  c.walls[0].openings = {opening(1.5, 1.0, 0.0, 2.0), opening(2.8, 1.0, 0.0, 2.5)};
  c.walls[1].material = "clay", c.walls[1].brick[2] = 0.1;
  std::vector<std::string> keys;
  try {
    build_model(c);
  } catch (const InputErrors& several) {
    for (const InputError& e : several.all()) keys.push_back(e.key());
  }
  for (const char* key : {"wall[0].opening[0].from", "wall[0].opening[1].height", "wall[1].material", "wall[1].brick"}) {
    CAPTURE(key);
    CHECK(std::ranges::find(keys, key) != keys.end());
  }
}

TEST_CASE("an opening without a lintel under masonry is told") {
  CHECK(wall_heads_without_lintel(good().walls).size() == 1);
  Case c = good();
  c.walls[0].openings[0].lintel = WallLintel{};
  CHECK(wall_heads_without_lintel(c.walls).empty());
}

TEST_CASE("bricks adapted by a third at most are told") {
  for (double length = 0.9; length < 6.0; length += 0.137) {
    const std::vector<WallSpec> walls{wall("w", {{0.0, 0.0}, {length, 0.0}}, 0.41, 2.37)};
    const std::vector<AdaptedBricks> adapted = adapted_bricks(walls);
    REQUIRE(adapted.size() == 1);
    CHECK(adapted[0].shortest > 0.4 * 2 / 3 - 1e-9);
    CHECK(adapted[0].longest < 0.4 * 4 / 3 + 1e-9);
    CHECK(adapted[0].width == doctest::Approx(0.205));
    CHECK(adapted[0].lowest == doctest::Approx(2.37 / 12));
  }
  CHECK(adapted_bricks({wall("w", {{0.0, 0.0}, {4.0, 0.0}}, 0.4, 2.4)}).empty());
}

TEST_CASE("places in messages count along the line of the wall, as in the case") {
  using Walls = std::vector<WallSpec>;
  refuse([](Walls& w) { w[0].openings.push_back(opening(8.35, 0.6, 0.0, 2.0)); }, "wall[0].opening[1].from",
         "the outer 2 wall would be open from 8.35 to 8.95 m along the line of the wall, and it ends at 9 m");
  refuse([](Walls& w) { w[0].openings.push_back(opening(5.1, 0.6, 0.0, 2.0)); }, "wall[0].opening[1].from",
         "the outer 1 wall meets it from 4.8 to 5.2 m");
}

TEST_CASE("a wall that begins in the wall upon which it stands is refused at its base, once") {
  Case c = case_of({closed(wall("low", {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}}, 0.4, 2.4))});
  c.walls.push_back(c.walls[0]);
  c.walls[1].name = "high", c.walls[1].base = 2.3;
  check_refused(c, std::function<void(Case&)>([](Case&) {}), "wall[1].base",
                "2.3 m: the high 1 wall would begin inside the low 1 wall, whose top is at 2.4 m; nearest: 2.4 m");
  try {
    build_model(c);
  } catch (const InputErrors& e) {
    CHECK(e.all().size() == 1);
  } catch (const InputError&) {
  }
  c.walls[1].base = 2.4;
  CHECK_NOTHROW(build_model(c));
}

TEST_CASE("a wall that reaches beyond the one upon which it stands is told") {
  Case c = case_of({wall("low", {{0.0, 0.0}, {5.0, 0.0}}, 0.4, 2.4), wall("high", {{0.0, 0.0}, {5.0, 0.0}}, 0.6, 2.0)});
  c.walls[1].base = 2.4;
  const std::vector<InputError> found = wall_overhangs(c.walls, {});
  REQUIRE(found.size() == 2);
  CHECK(found[0].key() == "wall[1].thickness");
  CHECK(found[0].problem().find("the high wall reaches 0.1 m beyond the wall on which it stands, on its right") != std::string::npos);
  c.walls[1].thickness = 0.4;
  CHECK(wall_overhangs(c.walls, {}).empty());
  c.walls[1].thickness = 0.2;
  CHECK(wall_overhangs(c.walls, {}).empty());
}

TEST_CASE("an opening lies above the end of a low wall that rises elsewhere") {
  Case c = good();
  c.walls[1].height = 1.2, c.walls[1].tops = {{1.5, 1.2}, {2.5, 3.0}, {3.0, 3.0}};  // 1.2 m where it meets the outer wall
  c.walls[0].openings = {opening(1.5, 1.0, 1.4, 0.8)};
  CHECK_NOTHROW(build_model(c));
  c.walls[1].height = 2.0, c.walls[1].tops[0][1] = 2.0;
  check_refused(c, std::function<void(Case&)>([](Case&) {}), "wall[0].opening[0].from", "the inner wall meets it from 1.9 to 2.1 m");
}

TEST_CASE("vaults and roofs that lie in walls are refused with what bounds them") {
  Case c = case_of({closed(wall("low", {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}}, 0.4, 2.0))});
  c.walls.push_back(c.walls[0]);
  c.walls[1].name = "high", c.walls[1].base = 2.0, c.walls[1].height = 2.4, c.walls[1].thickness = 0.2;
  c.vaults.resize(1);
  c.vaults[0].name = "vault", c.vaults[0].walls = {"low 1", "low 3"}, c.vaults[0].material = "adobe";
  check_refused(c, std::function<void(Case&)>([](Case&) {}), "vault[0]",
                "give vault[0] four \"corners\" between which that wall does not stand");
}

TEST_CASE("what a wall loses in its bends is told: blocks are straight") {
  WallSpec ring = closed(wall("ring", {}, 0.4, 1.0, WallBond::through));
  const double radius = 2.0, step = 2.0 * std::acos(-1.0) / 24.0;
  for (int i = 0; i < 24; ++i) ring.points.push_back({radius * std::cos(i * step), radius * std::sin(i * step)});
  ring.brick = {0.8, 0.4, 0.25};
  const Case c = case_of({ring});
  const double line = 24.0 * 2.0 * radius * std::sin(0.5 * step) * 0.4 * 1.0;
  const std::vector<AdaptedBricks> adapted = adapted_bricks(c.walls);
  REQUIRE(adapted.size() == 1);
  CHECK(adapted[0].lost > 0.005);
  CHECK(volume_of(build_model(c)) == doctest::Approx(line * (1.0 - adapted[0].lost)).epsilon(1e-4));
}
