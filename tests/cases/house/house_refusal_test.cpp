// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "cases/house/house.h"
#include "tests/cases/paper_house.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::opening;

namespace {

struct Refusal {
  std::function<void(House&)> change;
  std::string key;
  std::string says;  // a part of the message
};

void check_refused(const Refusal& refusal) {
  CAPTURE(refusal.key);
  CAPTURE(refusal.says);
  House house = *testing::paper_flat20().house;
  refusal.change(house);
  const std::vector<NamedMaterial> materials{{"adobe", {}}, {"wood", {}}};
  std::string key = "built", problem;
  try {
    build_house(house, materials);
  } catch (const InputError& e) {
    key = e.key();
    problem = e.problem();
  }
  CHECK(key == refusal.key);
  CAPTURE(problem);
  CHECK(problem.find(refusal.says) != std::string::npos);
}

}  // namespace

TEST_CASE("sizes that cannot be laid are refused with the nearest that can") {
  const std::vector<Refusal> refusals{
      {[](House& h) { h.height = 0.0; }, "house.height", "allowed: above 0"},
      {[](House& h) { h.mortar = -0.01; }, "house.mortar", "allowed: above 0"},
      {[](House& h) { h.mortar = 0.1; }, "house.mortar", "not less than the height of a brick (0.1 m)"},
      {[](House& h) { h.mortar = 0.02; }, "house.brick", "and mortar of 0.02 m; nearest: [0.22, 0.1, 0.1], or bond = \"running\""},
      {[](House& h) {
         h.brick = {0.25, 0.12, 0.065};
       },
       "house.brick", "nearest: [0.24, 0.12, 0.065], mortar = 0.01, or bond = \"running\""},
      {[](House& h) { h.bearing_wall = 0.06; }, "house.bearing_wall", "less than two thirds of a brick's width; at least 0.067 m"},
      {[](House& h) { h.nonbearing_wall = 0.04; }, "house.nonbearing_wall", "at least 0.067 m"},
      {[](House& h) { h.nonbearing_wall = -0.2; }, "house.nonbearing_wall", "allowed: above 0"},
      {[](House& h) { h.inner_size[1] = 0.0; }, "house.inner_size", "allowed: above 0"},
      {[](House& h) { h.inner_size[0] = std::nan(""); }, "house.inner_size", "allowed: above 0"},
      {[](House& h) { h.inner_size[1] = 0.05; }, "house.inner_size", "at least 0.1 m"},
      {[](House& h) {
         h.brick = {0.25, 0.1, 0.1};
       },
       "house.brick", "nearest: [0.2, 0.1, 0.1], or bond = \"running\""},
      {[](House& h) {
         h.brick = {0.1, 0.2, 0.1}, h.bond = Bond::running;
       },
       "house.brick", "must not be wider"},
      {[](House& h) {
         h.brick = {0.02, 0.01, 0.0001};
       },
       "house", "at most 20000000"},
      {[](House& h) { h.turn = 30.0; }, "house.turn", "not a multiple of 90; nearest: 0"},
      {[](House& h) { h.turn = std::numeric_limits<double>::infinity(); }, "house.turn", "not a multiple of 90"},
      {[](House& h) {
         h.copies = {0, 1};
       },
       "house.copies", "at least 1"},
      {[](House& h) {
         h.copies = {1, 2}, h.spacing = {8.0, 3.0};
       },
       "house.spacing", "overlap along y; at least 3.4 m"},
      {[](House& h) {
         h.copies = {2, 1}, h.spacing = {3.6, 6.0};
       },
       "house.spacing", "overlap along x; at least 5.4 m"},
      {[](House& h) { h.origin[0] = std::nan(""); }, "house.origin", "out of range"},
      {[](House& h) { h.roof.beam[0] = 0.0; }, "house.roof.beam", "allowed: above 0"},
      {[](House& h) { h.roof.element = 1e-5; }, "house.roof.element", "more than 1000 parts"},
      {[](House& h) { h.roof.bearing = 0.3; }, "house.roof.bearing",
       "0.3 m is more than the thickness of the bearing walls; allowed: up to 0.2 m"},
  };
  for (const Refusal& r : refusals) check_refused(r);
}

TEST_CASE("unknown names are refused by name") {
  const std::vector<Refusal> refusals{
      {[](House& h) { h.material = "mud"; }, "house.material", "unknown material \"mud\"; known: adobe, wood"},
      {[](House& h) { h.wood.material = "oak"; }, "house.wood.material", "unknown material \"oak\""},
      {[](House& h) { h.openings[1].wall = "north"; }, "house.opening[1].wall", "\"north\" is no wall; allowed: front, rear, left, right"},
  };
  for (const Refusal& r : refusals) check_refused(r);
}

TEST_CASE("openings that do not fit their wall are refused") {
  const std::vector<Refusal> refusals{
      {[](House& h) { h.openings[1].width = 7.0; }, "house.opening[1].width", "7 m is wider than the front wall between its corners (5 m)"},
      {[](House& h) { h.openings[1].width = 0.0; }, "house.opening[1].width", "allowed: above 0"},
      {[](House& h) { h.openings[1].from = 4.5; }, "house.opening[1].from",
       "outside the front wall, whose inner corners are at 0.2 and 5.2 m; allowed: 0.2 to 4.2 m"},
      {[](House& h) { h.openings[0].from = 0.1; }, "house.opening[0].from", "outside the front wall"},
      {[](House& h) { h.openings[0].from = std::nan(""); }, "house.opening[0].from", "outside the front wall"},
      {[](House& h) { h.openings[1].height = 1.5; }, "house.opening[1].height", "over the height of the wall (2.4 m); at most 1.4 m"},
      {[](House& h) { h.openings[1].sill = 0.03; }, "house.opening[1].sill",
       "needs a bed joint at 0.03 m, 0.03 m from the foot of the walls; a course of cut bricks is at least 0.05 m high; nearest: 0 m"},
      {[](House& h) { h.openings[1].sill = 0.97; }, "house.opening[1].height",
       "1 m needs a bed joint at 1.97 m, 0.03 m from that of house.opening[0].height"},
      {[](House& h) { h.openings[1].sill = 2.4; }, "house.opening[1].sill", "not below the top of the wall"},
      {[](House& h) { h.openings[1].sill = -0.1; }, "house.opening[1].sill", "allowed: above 0"},
      {[](House& h) { h.openings[1].height = 1.03; }, "house.opening[1].height", "nearest: 1 m"},
      {[](House& h) { h.openings[1] = opening("rear", 2.0, 0.5, 0.5, 0.02); }, "house.opening[1].height", "nearest: 0.05 m"},
      {[](House& h) { h.openings[1].from = 2.0; }, "house.opening[1]", "overlaps house.opening[0] in the front wall: from 2 to 3 m"},
      {[](House& h) { h.openings[1].from = 2.4; }, "house.opening[1].lintel", "overlaps house.opening[0].lintel"},
      {[](House& h) { h.openings.push_back(opening("front", 1.2, 0.5, 2.0, 0.2)); }, "house.opening[2]",
       "overlaps house.opening[0].lintel"},
  };
  for (const Refusal& r : refusals) check_refused(r);
}

TEST_CASE("pieces of wall too short to build are refused with a place that fits") {
  const std::vector<Refusal> refusals{
      {[](House& h) { h.openings[1] = opening("front", 2.26, 0.5, 0.0, 1.0); }, "house.opening[1].from",
       "leaves a piece of the front wall 0.06 m long (from 2.2 to 2.26 m); a piece is at least 0.1 m, half a brick; nearest that fits: 2.3 "
       "m"},
      {[](House& h) { h.openings[1] = opening("front", 2.22, 0.5, 0.0, 1.0); }, "house.opening[1].from", "nearest that fits: 2.2 m"},
      {[](House& h) { h.openings[1] = opening("left", 2.57, 0.6, 0.0, 1.0); }, "house.opening[1].from",
       "(from 3.17 to 3.2 m); a piece is at least 0.1 m, half a brick; nearest that fits: 2.6 m"},
      {[](House& h) { h.openings = {opening("left", 0.25, 2.94, 0.0, 1.0)}; }, "house.opening[0].from", "move or resize it"},
      {[](House& h) { h.openings = {opening("front", 1.0, 1.0, 0.0, 1.1, 2.5)}; }, "house.opening[0].lintel.length",
       "nearest that fits: 2.6 m"},
  };
  for (const Refusal& r : refusals) check_refused(r);
}

TEST_CASE("lintels that do not fit are refused") {
  const std::vector<Refusal> refusals{
      {[](House& h) { h.openings[1].lintel->length = 6.0; }, "house.opening[1].lintel.length", "6 m is longer than the front wall"},
      {[](House& h) { h.openings[1].lintel->length = 1.0; }, "house.opening[1].lintel.length",
       "finds no support beside the opening; more than its width, 1 m"},
      {[](House& h) { h.openings[1].lintel->length = 3.0; }, "house.opening[1].lintel.length",
       "into a corner of the front wall (inner corners at 0.2 and 5.2 m); at most 2.6 m here"},
      {[](House& h) { h.openings[1].lintel->height = 0.14; }, "house.opening[1].lintel.height", "nearest: 0.1 m"},
      {[](House& h) { h.openings[1].lintel->height = 0.5; }, "house.opening[1].lintel.height", "over the height of the wall"},
      {[](House& h) { h.openings[1].lintel->element = 0.0; }, "house.opening[1].lintel.element", "allowed: above 0"},
  };
  for (const Refusal& r : refusals) check_refused(r);
}

TEST_CASE("a house without timber needs no wood") {
  House house;
  house.wood.material = "oak";
  CHECK(!has_timber(house));
  CHECK(!build_house(house, std::vector<NamedMaterial>{{"adobe", {}}}).empty());
}
