// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "io/input/case_file/case_file.h"
#include "io/input/case_file/case_keys.h"
#include "tests/io/temp_folder.h"

// Keys of storeys, inner walls, piers, floors, pitched roofs and parts, and of walls of any plan: all are read, and what is wrong with each
// is said.
namespace voussoir {
namespace {

cases::Case read(const std::string& text) { return io::read_case({"test.toml", text}, {}).value; }

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

const std::string kBuilding = R"(
[house]
bond = "rubble"
rubble = { seed = 5, irregularity = 0.25, through = 0.4 }
[house.leaves]
walls = ["front", "rear"]
outer = 0.15
joint = "rubble"
through = { spacing = 0.9, every = 5, material = "lava" }
[[house.storey]]
height = 2.2
bearing_wall = 0.2
nonbearing_wall = 0.1
[[house.inner_wall]]
name = "middle"
along = "x"
at = 1.5
thickness = 0.3
storeys = [1]
[[house.pier]]
wall = "rear"
from = 2.0
width = 0.4
depth = 0.6
height = 1.8
[[house.floor]]
storey = 2
along = "x"
beam = [0.12, 0.18]
spacing = 0.7
bearing = 0.2
element = 0.35
load = 90.0
joint = "lime"
anchorage = "anchor"
anchor = { area = 2e-4, yield = 2.4e8, every = 2, reach = 0.4, plate = [0.2, 0.1] }
deck = { shear_stiffness = 4e5, shear_strength = 2e3, stiffness = 5e6, strength = 1e4 }
[[house.opening]]
wall = "middle"
storey = 2
from = 1.0
width = 0.9
height = 2.0
arch = { rise = 0.1, thickness = 0.25, springer = 0.15, voussoirs = 5, material = "tuff" }
[house.roof]
kind = "pitched"
pitch = 35.0
spacing = 0.9
tie = { area = 3e-4, compression = true }
deck = { shear_stiffness = 3e5, stiffness = 4e6 }
[[base.part]]
x = [1.0, 2.0]
y = [3.0, 5.0]
level = 0.4
motion = { velocity = [0, 0, -1e-3] }
[[base.part]]
wall = "rear"
from = 0.5
to = 2.5
level = 0.2
[[block]]
name = "stone"
material = "adobe"
part = "front wall, storey 1"
box = [[0, 0, 0], [1, 1, 1]]
[[stones]]
file = "a.obj"
unit = "m"
part = "left wall"
)";

/// A fault in the line behind a table of five lines.
void faulty(const std::string& table, const std::string& line, const std::string& says) {
  const std::string got = refusal(table + line);
  CAPTURE(got);
  CHECK(got.find(says) != std::string::npos);
}

}  // namespace

TEST_CASE("case file: every key of walls is read") {
  const cases::Case c = io::load_case(VOUSSOIR_SOURCE_DIR "/tests/io/input/case_file/data/every_key.toml").value;
  REQUIRE(c.walls.size() == 2);
  const cases::WallSpec& w = c.walls[0];
  CHECK(w.name == "street");
  CHECK(w.points == std::vector<std::array<double, 2>>{{0.0, 0.0}, {4.0, 0.5}, {3.0, 4.0}});
  CHECK(w.closed);
  CHECK(w.line == cases::WallLine::left);
  CHECK(w.thickness == 0.38);
  CHECK(w.base == 0.25);
  CHECK(w.height == 2.75);
  CHECK(w.brick == std::array{0.25, 0.125, 0.08});
  CHECK(w.bond == cases::WallBond::running);
  CHECK(w.cells == cases::CellCounts{2, 2, 1});
  CHECK(w.material == "adobe");
  CHECK(w.meeting == cases::WallMeeting::butt);
  CHECK(w.load == 350.0);
  CHECK(w.tops == std::vector<std::array<double, 2>>{{0.5, 2.75}, {2.0, 3.5}, {3.5, 2.75}});
  CHECK(c.walls[1].gable == 4.0);
  REQUIRE(w.openings.size() == 1);
  CHECK(w.openings[0].from == 1.5);
  CHECK(w.openings[0].width == 0.9);
  CHECK(w.openings[0].sill == 0.8);
  CHECK(w.openings[0].height == 1.2);
  REQUIRE(w.openings[0].lintel);
  CHECK(w.openings[0].lintel->bearing == 0.25);
  CHECK(w.openings[0].lintel->height == 0.15);
  CHECK(w.openings[0].lintel->material == "old wood");
  REQUIRE(w.openings[0].arch);
  CHECK(w.openings[0].arch->rise == 0.2);
  CHECK(w.openings[0].arch->thickness == 0.3);
  CHECK(w.openings[0].arch->voussoirs == 9);
}

TEST_CASE("case file: every key of floors and roofs between walls is read") {
  const cases::Case c = io::load_case(VOUSSOIR_SOURCE_DIR "/tests/io/input/case_file/data/every_key.toml").value;
  const std::vector<std::array<double, 2>> corners{{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
  REQUIRE(c.floors.size() == 1);
  const cases::WallFloor& f = c.floors[0];
  CHECK(f.name == "upper");
  CHECK(f.walls == std::vector<std::string>{"street 1", "yard"});
  CHECK(f.corners == corners);
  CHECK(f.direction == std::array{1.0, 0.25});
  CHECK(f.level == 2.5);
  CHECK(f.material == "old wood");
  CHECK(f.within_member == "normal");
  CHECK(f.beams.beam == std::array{0.12, 0.18});
  CHECK(f.beams.spacing == 0.55);
  CHECK(f.beams.bearing == 0.15);
  CHECK(f.beams.element == 0.45);
  CHECK(f.beams.load == 120.0);
  CHECK(f.beams.joint == "normal");
  CHECK(f.beams.anchorage == cases::Anchorage::nailed);
  REQUIRE(f.beams.anchor);
  CHECK(f.beams.anchor->every == 2);
  REQUIRE(f.beams.deck);
  CHECK(f.beams.deck->strength == 2.0e4);
  REQUIRE(c.roofs.size() == 1);
  const cases::WallRoof& r = c.roofs[0];
  CHECK(r.name == "main");
  CHECK(r.gables == std::vector<std::string>{"street 2"});
  CHECK(r.corners == corners);
  CHECK(r.material == "old wood");
  CHECK(r.within_member == "normal");
  CHECK(r.joint == "normal");
  CHECK(r.rafters.pitch == 40.0);
  CHECK(r.rafters.beam == std::array{0.12, 0.18});
  CHECK(r.rafters.spacing == 0.9);
  CHECK(r.rafters.bearing == 0.15);
  CHECK(r.rafters.element == 0.45);
  CHECK(r.rafters.between_beams == "dry");
  CHECK(r.rafters.surcharge == 55.0);
  REQUIRE(c.wall_ties.size() == 2);
  CHECK(c.wall_ties[0].bar.name == "side rods");
  CHECK(c.wall_ties[0].kind == cases::HouseTieKind::along);
  CHECK(c.wall_ties[0].walls == std::vector<std::string>{"street 1", "yard"});
  CHECK(c.wall_ties[0].heights == std::vector{2.1});
  CHECK(c.wall_ties[0].depth == 0.1);
  CHECK(c.wall_ties[0].bar.area == 4e-4);
  CHECK(c.wall_ties[1].kind == cases::HouseTieKind::across);
  CHECK(c.wall_ties[1].at == std::vector{1.25});
  REQUIRE(c.vaults.size() == 1);
  const cases::WallVault& v = c.vaults[0];
  CHECK(v.name == "nave");
  CHECK(v.walls == std::vector<std::string>{"street 1", "yard"});
  CHECK(v.gables == std::vector<std::string>{"street 2"});
  CHECK(v.corners == corners);
  CHECK(v.material == "old wood");
  CHECK(v.rise == 0.9);
  CHECK(v.thickness == 0.25);
  CHECK(v.ring == 0.4);
  CHECK(v.voussoirs == 17);
  CHECK(v.surcharge == 45.0);
  CHECK(v.kind == cases::VaultKind::pavilion);
  CHECK(v.oculus == 0.7);
  REQUIRE(r.rafters.tie);
  CHECK(r.rafters.tie->area == 3.0e-4);
  REQUIRE(r.rafters.deck);
  CHECK(r.rafters.deck->stiffness == 1.0e7);
}

TEST_CASE("case file: every key of a building is read") {
  const cases::Case c = read(kBuilding);
  const cases::House& h = *c.house;
  REQUIRE(h.leaves);
  CHECK(h.leaves->walls == std::vector<std::string>{"front", "rear"});
  CHECK(h.leaves->outer == 0.15);
  CHECK(h.leaves->joint == "rubble");
  REQUIRE(h.leaves->through);
  CHECK(h.leaves->through->spacing == 0.9);
  CHECK(h.leaves->through->every == 5);
  CHECK(h.leaves->through->material == "lava");
  REQUIRE(h.storeys.size() == 1);
  CHECK(h.storeys[0].height == 2.2);
  CHECK(h.storeys[0].bearing_wall == 0.2);
  CHECK(h.storeys[0].nonbearing_wall == 0.1);
  REQUIRE(h.inner_walls.size() == 1);
  CHECK(h.inner_walls[0].name == "middle");
  CHECK(h.inner_walls[0].along == cases::PlanAxis::x);
  CHECK(h.inner_walls[0].at == 1.5);
  CHECK(h.inner_walls[0].thickness == 0.3);
  CHECK(h.inner_walls[0].storeys == std::vector{1});
  REQUIRE(h.piers.size() == 1);
  CHECK(h.piers[0].wall == "rear");
  CHECK(h.piers[0].from == 2.0);
  CHECK(h.piers[0].width == 0.4);
  CHECK(h.piers[0].depth == 0.6);
  CHECK(h.piers[0].height == 1.8);
  CHECK(h.openings.at(0).storey == 2);
  CHECK(h.bond == cases::Bond::rubble);
  REQUIRE(h.rubble);
  CHECK(h.rubble->seed == 5);
  CHECK(h.rubble->irregularity == 0.25);
  CHECK(h.rubble->through == 0.4);
  REQUIRE(h.openings[0].arch);
  CHECK(h.openings[0].arch->rise == 0.1);
  CHECK(h.openings[0].arch->thickness == 0.25);
  CHECK(h.openings[0].arch->springer == 0.15);
  CHECK(h.openings[0].arch->voussoirs == 5);
  CHECK(h.openings[0].arch->material == "tuff");
  REQUIRE(c.base);
  REQUIRE(c.base->parts.size() == 2);
  CHECK(*c.base->parts[0].x == std::array{1.0, 2.0});
  CHECK(*c.base->parts[0].y == std::array{3.0, 5.0});
  CHECK(c.base->parts[0].level == 0.4);
  CHECK(c.base->parts[0].motion->velocity->z == -1e-3);
  CHECK(c.base->parts[1].wall == "rear");
  CHECK(c.base->parts[1].from == 0.5);
  CHECK(c.base->parts[1].to == 2.5);
  CHECK(h.roof.kind == cases::RoofKind::pitched);
  CHECK(h.roof.pitch == 35.0);
  CHECK(h.roof.spacing == 0.9);
  REQUIRE(h.roof.tie);
  CHECK(h.roof.tie->area == 3e-4);
  CHECK(h.roof.tie->compression);
  REQUIRE(h.roof.deck);
  CHECK(h.roof.deck->shear_stiffness == 3e5);
  CHECK(h.roof.deck->stiffness == 4e6);
  CHECK(c.blocks.at(0).part == "front wall, storey 1");
  CHECK(c.stones.at(0).part == "left wall");
}

TEST_CASE("case file: every key of a floor is read") {
  const cases::Case c = read(kBuilding);
  REQUIRE(c.house->floors.size() == 1);
  const cases::Floor& f = c.house->floors[0];
  CHECK(f.storey == 2);
  CHECK(f.along == cases::PlanAxis::x);
  CHECK(f.beam == std::array{0.12, 0.18});
  CHECK(f.spacing == 0.7);
  CHECK(f.bearing == 0.2);
  CHECK(f.element == 0.35);
  CHECK(f.load == 90.0);
  CHECK(f.joint == "lime");
  CHECK(f.anchorage == cases::Anchorage::anchor);
  REQUIRE(f.anchor);
  CHECK(f.anchor->every == 2);
  CHECK(f.anchor->reach == 0.4);
  CHECK(f.anchor->bar.area == 2e-4);
  CHECK(*f.anchor->bar.plate == std::array{0.2, 0.1});
  REQUIRE(f.deck);
  CHECK(f.deck->shear_stiffness == 4e5);
  CHECK(*f.deck->shear_strength == 2e3);
  CHECK(f.deck->stiffness == 5e6);
  CHECK(*f.deck->strength == 1e4);
}

TEST_CASE("case file: a building written out in full is read again as it was") {
  const std::string once = io::resolved_toml(read(kBuilding));
  CHECK(io::resolved_toml(read(once)) == once);
}

TEST_CASE("faults: storeys, inner walls, piers") {
  faulty("[[house.storey]]\n", "height = 0", "house.storey[0].height = 0 m: must be > 0");
  faulty("[[house.storey]]\n", "bearing_wall = -0.1", "house.storey[0].bearing_wall = -0.1 m: must be > 0");
  faulty("[[house.inner_wall]]\n", "", "house.inner_wall[0].at is missing");
  faulty("[[house.inner_wall]]\nat = 1.0\n", "along = \"z\"", "house.inner_wall[0].along = \"z\": must be \"x\" | \"y\"");
  faulty("[[house.inner_wall]]\nat = 1.0\n", "storeys = [0]", "storeys[0] = 0: must be");
  faulty("[[house.inner_wall]]\nat = 1.0\n", "thickness = 0", "thickness = 0 m: must be > 0");
  faulty("[[house.pier]]\nfrom = 1.0\n", "", "house.pier[0].wall is missing");
  faulty("[[house.pier]]\nwall = \"rear\"\n", "", "house.pier[0].from is missing");
  faulty("[[house.pier]]\nwall = \"rear\"\nfrom = 1.0\n", "depth = 0", "house.pier[0].depth = 0 m: must be > 0");
  faulty("[[house.pier]]\nwall = \"rear\"\nfrom = 1.0\n", "width = -1", "house.pier[0].width = -1 m: must be > 0");
  faulty("[[house.opening]]\nwall = \"rear\"\nfrom = 1.0\nwidth = 1.0\nheight = 1.0\n", "storey = 0",
         "house.opening[0].storey = 0: must be");
  faulty("[house]\n", "bond = \"dutch\"", "house.bond = \"dutch\": must be \"english\" | \"running\" | \"header\" | \"flemish\"");
}

TEST_CASE("faults: walls of two leaves") {
  faulty("[house.leaves]\n", "outer = 0", "house.leaves.outer = 0 m: must be > 0");
  faulty("[house.leaves]\n", "outer = \"half\"", "house.leaves.outer = \"half\": found a string in quotes, wanted a number (m, > 0)");
  faulty("[house.leaves]\n", "walls = \"front\"", "house.leaves.walls = \"front\": found a string in quotes, wanted an array");
  faulty("[house.leaves]\n", "joint = \"\"", "house.leaves.joint = \"\": must not be empty");
  faulty("[house.leaves]\n", "collar = 1", "house.leaves.collar");
  faulty("[house.leaves]\n", "through = 1", "house.leaves.through = 1: found an integer, wanted a table");
  faulty("[house.leaves]\n", "through = { spacing = 0 }", "house.leaves.through.spacing = 0 m: must be > 0");
  faulty("[house.leaves]\n", "through = { every = 1 }", "house.leaves.through.every = 1: must be");
  faulty("[house.leaves]\n", "through = { every = 2.5 }",
         "house.leaves.through.every = 2.5: found a number with a fraction, wanted an integer (in [2, 1000])");
  faulty("[house.leaves]\n", "through = { material = 3 }",
         "house.leaves.through.material = 3: found an integer, wanted a string in quotes");
}

TEST_CASE("faults: floors") {
  const std::string floor = "[[house.floor]]\n", bar = "anchor = { area = 1e-4 }\n";
  faulty(floor, "storey = 0", "house.floor[0].storey = 0: must be");
  faulty(floor, "beam = [0.1, 0]", "house.floor[0].beam[1] = 0 m: must be > 0");
  faulty(floor, "spacing = 0.1", "house.floor[0].spacing = 0.1 m is not more than the width of a beam");
  faulty(floor, "load = -1", "house.floor[0].load = -1 kg/m2: must be >= 0");
  faulty(floor, "anchorage = \"glued\"", "must be \"friction\" | \"nailed\" | \"anchor\"");
  faulty(floor, "anchorage = \"nailed\"", "house.floor[0].anchor is missing; this anchorage needs its section");
  faulty(floor, bar, "needs anchorage = \"nailed\" or \"anchor\"");
  faulty(floor, "anchorage = \"nailed\"\nanchor = { area = 1e-4, plate = [0.1, 0.1] }", "does not go with anchorage = \"nailed\"");
  faulty(floor, "anchorage = \"anchor\"\nanchor = { area = 1e-4, reach = 0 }", "anchor.reach = 0 m: must be > 0");
  faulty(floor, "anchorage = \"anchor\"\nanchor = { area = 1e-4, every = 0 }", "anchor.every = 0: must be");
  faulty(floor, "anchorage = \"anchor\"\nanchor = { area = 1e-4, hardening = 1e9 }", "needs yield");
  faulty(floor, "deck = { stiffness = 1e6 }", "deck.shear_stiffness is missing");
  faulty(floor, "deck = { shear_stiffness = 1e6 }", "deck.stiffness is missing");
  faulty(floor, "deck = { shear_stiffness = 1e6, stiffness = 1e6, shear_strength = 0 }", "deck.shear_strength = 0 N/m: must be > 0");
  faulty(floor, "deck = { shear_stiffness = 1e6, stiffness = 1e6, strength = -2 }", "deck.strength = -2 N/m: must be > 0");
}

TEST_CASE("faults: flat roofs") {
  faulty("[house.roof]\nkind = \"flat\"\n", "bearing = 0", "house.roof.bearing = 0 m: must be > 0");
  faulty("[house.roof]\nkind = \"vault\"\n", "bearing = 0.2", "house.roof.bearing = 0.2 m needs kind = \"flat\"");
}

TEST_CASE("faults: pitched roofs") {
  faulty("[house.roof]\nkind = \"pitched\"\n", "pitch = 3.0", "house.roof.pitch = 3 degrees: must be");
  faulty("[house.roof]\nkind = \"pitched\"\n", "spacing = 0", "house.roof.spacing = 0 m: must be > 0");
  faulty("[house.roof]\nkind = \"pitched\"\n", "tie = { young = 1e9 }", "house.roof.tie.area is missing");
  faulty("[house.roof]\nkind = \"pitched\"\n", "tie = { area = 1e-4, plate = [0.1, 0.1] }", "does not go with a tie from rafter to rafter");
  faulty("[house.roof]\nkind = \"flat\"\n", "pitch = 20.0", "house.roof.pitch = 20 degrees needs kind = \"pitched\"");
  faulty("[house.roof]\nkind = \"flat\"\n", "tie = { area = 1e-4 }", "needs kind = \"pitched\"");
  faulty("[house.roof]\nkind = \"flat\"\n", "deck = { shear_stiffness = 1e6, stiffness = 1e6 }", "needs kind = \"pitched\"");
}

}  // namespace voussoir
