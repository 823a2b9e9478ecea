// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "cases/case.h"
#include "cases/house/house.h"
#include "cases/model.h"
#include "tests/cases/paper_house.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::opening;

namespace {

/// The keys at fault in a case, in the order in which they are found.
std::vector<std::string> keys_at_fault(const Case& c) {
  std::vector<std::string> keys;
  try {
    build_model(c, 1);
  } catch (const InputErrors& several) {
    for (const InputError& e : several.all()) keys.push_back(e.key());
  } catch (const InputError& e) {
    keys.push_back(e.key());
  }
  return keys;
}

Case without_openings() {
  Case c = testing::paper_flat20();
  c.house->openings.clear();
  return c;
}

using Keys = std::vector<std::string>;

}  // namespace

TEST_CASE("house: all faults of the plan are told at once") {
  Case c = without_openings();
  House& h = *c.house;
  h.bearing_wall = 0.04, h.nonbearing_wall = 0.05;
  h.storeys.push_back({2.0, 0.5, {}});
  h.inner_walls.push_back({"middle", PlanAxis::y, 2.0, 0.06, {}});
  h.turn = 30.0;
  // A storey's wall of 0.5 m is thicker than the least that the one below is laid out with.
  CHECK(keys_at_fault(c) ==
        Keys{"house.bearing_wall", "house.nonbearing_wall", "house.storey[0].bearing_wall", "house.inner_wall[0].thickness", "house.turn"});
}

TEST_CASE("house: each opening tells its own faults, in heights and along the wall") {
  Case c = without_openings();
  House& h = *c.house;
  h.openings = {opening("front", -0.5, 1.0, 0.0, 9.0), opening("frnot", 1.0, 1.0, 0.0, 2.0), opening("left", 1.0, 0.8, 0.83, 0.7, 0.5),
                opening("rear", 1.0, 1.0, 0.0, 2.0)};
  CHECK(keys_at_fault(c) ==
        Keys{"house.opening[0].height", "house.opening[0].from", "house.opening[1].wall", "house.opening[2].lintel.length"});
  h.openings = {opening("front", 1.0, 1.0, 0.03, 1.0), opening("rear", 1.0, 1.0, 0.0, 1.0)};
  CHECK(keys_at_fault(c) == Keys{"house.opening[0].sill", "house.opening[1].height"});  // 1.03 m is where the first one ends a course
}

TEST_CASE("house: short pieces of two openings are told at once, each with its remedy") {
  Case c = without_openings();
  const double corner = c.house->nonbearing_wall, side = c.house->bearing_wall;
  c.house->openings = {opening("front", corner + 0.04, 0.8, 0.0, 1.0), opening("left", side + 0.06, 0.8, 0.0, 1.0)};
  try {
    build_model(c, 1);
    FAIL("built");
  } catch (const InputErrors& several) {
    REQUIRE(several.all().size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(several.all()[i].key() == "house.opening[" + std::to_string(i) + "].from");
      CHECK(several.all()[i].problem().find("nearest that fits") != std::string::npos);
    }
  }
}

TEST_CASE("house: what depends on a fault alone is no fault") {
  Case c = without_openings();
  House& h = *c.house;
  h.inner_walls.push_back({"middle", PlanAxis::y, 0.05, 0.2, {}});  // no room for it
  h.openings = {opening("middle", 1.0, 0.8, 0.0, 1.0)};
  CHECK(keys_at_fault(c) == Keys{"house.inner_wall[0].at"});
}

TEST_CASE("a case: names, blocks, loads and the roof tell their faults beside those of the house") {
  Case c = without_openings();
  c.house->joint = "norml", c.house->material = "adobee", c.house->bearing_wall = 0.04;
  c.house->roof.beam = {-0.2, 0.2};
  BlockSpec b;
  b.name = "slider", b.material = "steel";
  c.blocks.push_back(b);
  c.loads.push_back({});
  c.loads[0].block = "slidr";
  CHECK(keys_at_fault(c) ==
        Keys{"load[0].block", "house.bearing_wall", "house.material", "house.roof.beam", "block[0].material", "house.joint"});
}

TEST_CASE("a case: a name that is nearly known is suggested") {
  Case c = without_openings();
  c.house->joint = "norml";
  try {
    build_model(c, 1);
    FAIL("built");
  } catch (const InputError& e) {
    CHECK(e.problem().starts_with("unknown joint law \"norml\"; did you mean \"normal\"? known: "));
  }
}
