// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cases/house/random_house.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "cases/census.h"
#include "tests/cases/house/house_checks.h"
#include "tests/cases/house/house_mass.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::check_joint_areas;
using voussoir::testing::check_no_slivers;
using voussoir::testing::check_nothing_unjoined;
using voussoir::testing::Dice;
using voussoir::testing::expected_mass;
using voussoir::testing::random_case;

/// Houses drawn from the ranges of the keys; set VOUSSOIR_RANDOM_HOUSES for more of them.
namespace {

int houses_to_try() {
  const char* wanted = std::getenv("VOUSSOIR_RANDOM_HOUSES");
  return wanted == nullptr ? 180 : std::atoi(wanted);
}

}  // namespace

TEST_CASE("any house is built whole or refused by name") {
  Dice dice(20261125);
  int built = 0, refused = 0, vaulted = 0, timbered = 0, storeyed = 0, parted = 0, floored = 0, pitched = 0, piers = 0, leaved = 0,
      arched = 0, stony = 0, stepped = 0;
  const int houses = houses_to_try();
  for (int i = 0; i < houses; ++i) {
    CAPTURE(i);
    const Case c = random_case(dice);
    try {
      const Model m = build_model(c);
      const Census n = census(m);
      if (c.house->walls.size() == 4) CHECK(std::abs(n.mass / expected_mass(*c.house, c) - 1.0) < 1e-9);
      check_joint_areas(m);
      check_nothing_unjoined(m);
      check_no_slivers(m, *c.house);
      ++built;
      vaulted += c.house->roof.kind == RoofKind::vault ? 1 : 0;
      timbered += c.house->reinforcement ? 1 : 0;
      storeyed += c.house->storeys.empty() ? 0 : 1;
      parted += c.house->inner_walls.empty() ? 0 : 1;
      floored += c.house->floors.empty() ? 0 : 1;
      pitched += c.house->roof.kind == RoofKind::pitched ? 1 : 0;
      piers += c.house->piers.empty() ? 0 : 1;
      leaved += c.house->leaves ? 1 : 0;
      arched += std::ranges::any_of(c.house->openings, [](const Opening& o) { return o.arch.has_value(); }) ? 1 : 0;
      stony += c.house->bond == Bond::rubble ? 1 : 0;
      stepped += c.base->parts.empty() ? 0 : 1;
    } catch (const InputError& e) {
      CAPTURE(e.what());
      CHECK((e.key().starts_with("house.") || e.key().starts_with("base.part")));  // never a fault of geometry: every refusal names a key
      ++refused;
    }
  }
  CHECK(built > houses / 3);
  CHECK(vaulted > houses / 15);
  CHECK(timbered > houses / 30);
  CHECK(storeyed > houses / 15);
  CHECK(parted > houses / 30);
  CHECK(floored > houses / 30);
  CHECK(pitched > houses / 30);
  CHECK(piers > houses / 60);
  CHECK(leaved > houses / 60);
  CHECK(arched > houses / 60);
  CHECK(stony > houses / 30);
  CHECK(stepped > houses / 60);
  CHECK(refused > houses / 10);
}

namespace {

/// Thicknesses to the millimetre, and bearings of floors to the centimetre.
void make_true(Dice& dice, House& h) {
  const auto other = [&](double& length) { length = std::round(1000.0 * length * dice.pick(0.7, 1.4, 0.01)) / 1000.0; };
  other(h.bearing_wall), other(h.nonbearing_wall);
  for (Storey& s : h.storeys) {
    if (s.bearing_wall) other(*s.bearing_wall), s.bearing_wall = std::min(*s.bearing_wall, h.bearing_wall);
    if (s.nonbearing_wall) other(*s.nonbearing_wall), s.nonbearing_wall = std::min(*s.nonbearing_wall, h.nonbearing_wall);
  }
  for (InnerWall& w : h.inner_walls) other(w.thickness);
  for (Pier& p : h.piers) other(p.width);
  for (Floor& f : h.floors) f.bearing = dice.pick(0.05, 0.2, 0.01);
  if (h.leaves && h.leaves->outer) other(*h.leaves->outer);
}

}  // namespace

TEST_CASE("any house whose walls are no whole number of brick widths thick is built whole, as thick as it is said to be") {
  Dice dice(20261129);
  const int houses = houses_to_try() / 2;
  int built = 0, floored = 0, leaved = 0, piers = 0, parted = 0;
  std::array<int, 5> bonds{};
  for (int i = 0; i < houses; ++i) {
    CAPTURE(i);
    Case c = random_case(dice);
    make_true(dice, *c.house);
    try {
      const Model m = build_model(c);
      if (c.house->walls.size() == 4) CHECK(std::abs(census(m).mass / expected_mass(*c.house, c) - 1.0) < 1e-8);
      check_joint_areas(m);
      check_nothing_unjoined(m);
      check_no_slivers(m, *c.house, true);
      ++built;
      floored += c.house->floors.empty() ? 0 : 1;
      leaved += c.house->leaves ? 1 : 0;
      piers += c.house->piers.empty() ? 0 : 1;
      parted += c.house->inner_walls.empty() ? 0 : 1;
      ++bonds.at(static_cast<std::size_t>(c.house->bond));
    } catch (const InputError& e) {
      CAPTURE(e.what());
      CHECK((e.key().starts_with("house.") || e.key().starts_with("base.part")));
    }
  }
  CHECK(built > houses / 5);
  CHECK(std::min({floored, leaved, piers, parted}) > 0);
  CHECK(*std::ranges::min_element(bonds) > 0);
}

// House 274 of 5,000: the feet of two rafters leave of a brick's top only strips about 9 mm wide, of its corner cell an L.
TEST_CASE("a joint that cuts every cell left of a face: what is free is checked against whole cells") {
  Case c = testing::paper_flat20();
  House& h = *c.house;
  h.openings.clear();
  h.bond = Bond::running;
  h.inner_size = {1.913, 1.476};
  h.height = 0.9;
  h.roof = {};
  h.roof.kind = RoofKind::pitched;
  h.roof.pitch = 23.0;
  h.roof.spacing = 0.4;
  h.roof.beam = {0.2, 0.15};
  h.roof.element = 0.3;
  const Model m = build_model(c);
  CHECK(std::abs(census(m).mass / expected_mass(h, c) - 1.0) < 1e-9);
  check_joint_areas(m);
  check_nothing_unjoined(m);
  check_no_slivers(m, h);
}
