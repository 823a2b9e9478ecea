// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

using namespace voussoir;
using io::load_case;
using io::LoadedCase;
using io::read_case;

namespace {

const std::string kEveryKey = VOUSSOIR_SOURCE_DIR "/tests/io/input/case_file/data/every_key.toml";

cases::Case read(const std::string& text) { return read_case({"test.toml", text}).value; }

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

TEST_CASE("case file: an empty file is a case of defaults") {
  const cases::Case c = read("");
  const cases::Case defaults;
  CHECK(io::resolved_toml(c) == io::resolved_toml(defaults));
  CHECK(c.gravity.acceleration == Vec3{0.0, 0.0, -9.8});
  CHECK(c.gravity.settle);
  CHECK(!c.gravity.ramp);
  CHECK(!c.time.step);
  CHECK(c.time.duration == 10.0);
  CHECK(c.joints.default_law == "dry");
  CHECK(c.contact.friction == 32.0);
  CHECK(c.output.history_interval == 0.001);
  CHECK(!c.motion);
  CHECK(!c.house);
  CHECK(!c.base);
  CHECK(c.folder == ".");
}

TEST_CASE("case file: every key of the analysis is read") {
  const cases::Case c = load_case(kEveryKey).value;
  CHECK(c.title == "Every key");
  CHECK(c.source == "made up");
  CHECK(c.folder == VOUSSOIR_SOURCE_DIR "/tests/io/input/case_file/data");
  CHECK(c.gravity.acceleration == Vec3{0.5, -0.25, -9.81});
  CHECK(!c.gravity.settle);
  CHECK(c.gravity.ramp == 0.75);
  CHECK(c.gravity.settle_limit == 4.5);
  CHECK(c.time.step == 5.0e-5);
  CHECK(c.time.duration == 12.5);
  CHECK(c.damping.ratio == 0.02);
  CHECK(c.damping.frequency == 6.05);
  CHECK(!c.damping.alpha);
  CHECK(!c.damping.debris);
  CHECK(c.damping.inertial);
  CHECK(!c.failure.shear);
  CHECK(c.failure.post_shear == cases::PostShear::brittle);
  CHECK(c.failure.shear_in_tension == cases::ShearInTension::coulomb);
  CHECK(c.contact.friction == 30.0);
  CHECK(c.contact.damping == 0.5);
  CHECK(c.contact.normal == cases::ContactNormal::master);
  CHECK(c.contact.dashpots == cases::Dashpots::unbounded);
  CHECK(c.contact.restitution == 0.6);
  CHECK(c.contact.compression == 6.5e6);
  CHECK(c.contact.crushing_energy == 4000.0);
  CHECK(c.contact.residual_compression == 7.0e5);
  CHECK(c.contact.crushing_depth == 0.008);
  REQUIRE(c.contact.between.size() == 2);
  CHECK(c.contact.between[0].materials == std::array<std::string, 2>{"old wood", "base"});
  CHECK(c.contact.between[0].friction == 20.0);
  CHECK(c.contact.between[1].friction == 33.0);
  CHECK(c.segment_size == 0.025);
  CHECK(c.segment_rule == geometry::SegmentRule::rim);
  CHECK(c.segment_torsion == geometry::Torsion::solid);
  CHECK(c.output.history_interval == 0.002);
  CHECK(c.output.frame_interval == 0.04);
  CHECK(c.output.ledger_interval == 0.05);
  REQUIRE(c.output.history.size() == 2);
  CHECK(c.output.history[0].name == "element1");
  CHECK(c.output.history[0].point == Vec3{0.1, 1.7, 2.05});
  CHECK(c.output.history[1].point == Vec3{1.0, 2.0, 3.0});
  REQUIRE(c.base);
  CHECK(c.base->z == -0.5);
  CHECK(c.base->tilt == std::array{1.0, 2.0});
}

TEST_CASE("case file: every key of materials, joints and motion is read") {
  const cases::Case c = load_case(kEveryKey).value;
  REQUIRE(c.materials.size() == 2);
  CHECK(c.materials.at("adobe").density == 1800.0);
  CHECK(c.materials.at("adobe").young == 9.8e7);
  CHECK(c.materials.at("adobe").poisson == 0.25);
  CHECK(c.materials.at("old wood").density == 800.0);
  CHECK(c.materials.at("old wood").young == 7.0e9);
  REQUIRE(c.joint_laws.size() == 1);
  const cases::JointLaw& law = c.joint_laws.at("normal");
  CHECK(law.tension == 1.27e5);
  CHECK(law.cohesion == 3.04e4);
  CHECK(law.friction == 32.0);
  CHECK(law.compression == 4.9e5);
  CHECK(law.cap == 8.0);
  CHECK(law.thickness == 0.01);
  CHECK(law.young == 9.9e7);
  CHECK(law.poisson == 0.24);
  CHECK(law.fracture_energy_tension == 5.5);
  CHECK(law.fracture_energy_shear == 21.0);
  CHECK(law.softening == cases::SofteningCurve::linear);
  CHECK(law.residual_friction == 28.0);
  CHECK(law.dilatancy == 11.0);
  CHECK(c.scatter.seed == 7);
  CHECK(c.scatter.variation == 0.25);
  CHECK(c.scatter.distribution == cases::Distribution::normal);
  CHECK(c.scatter.laws == std::vector<std::string>{"normal"});
  CHECK(c.joints.default_law == "normal");
  REQUIRE(c.joints.between.size() == 2);
  CHECK(c.joints.between[0].materials == std::array<std::string, 2>{"adobe", "base"});
  CHECK(c.joints.between[0].law == "dry");
  CHECK(c.joints.between[1].materials[1] == "old wood");
  REQUIRE(c.motion);
  CHECK(!c.motion->record);
  CHECK(c.motion->direction == "TLV");
  CHECK(c.motion->unit == "cm/s2");
  CHECK(c.motion->scale == std::array{1.0, 0.5, -0.25});
  CHECK(c.motion->ltv == std::array<std::optional<std::string>, 3>{"l.csv", "t.csv", "v.csv"});
  CHECK(c.motion->xyz == std::array<std::optional<std::string>, 3>{});
}

TEST_CASE("case file: every key of a house is read") {
  const std::optional<cases::House> house = load_case(kEveryKey).value.house;
  REQUIRE(house);
  CHECK(house->inner_size == std::array{4.0, 2.5});
  CHECK(house->height == 2.2);
  CHECK(house->brick == std::array{0.25, 0.12, 0.065});
  CHECK(house->bond == cases::Bond::running);
  CHECK(house->material == "brick");
  CHECK(house->joint == "lime");
  CHECK(house->cells == cases::CellCounts{2, 1, 3});
  CHECK(house->wood.material == "old wood");
  CHECK(house->wood.within_member == "solid");
  CHECK(house->wood.between_members == "nailed");
  CHECK(house->wood.timber_on_timber == "solid");
  CHECK(house->origin == std::array{1.5, -2.5});
  CHECK(house->turn == 270.0);
  CHECK(house->copies == std::array{4, 2});
  CHECK(house->spacing == std::array{9.0, 7.0});
  CHECK(house->bearing_wall == 0.4);
  CHECK(house->nonbearing_wall == 0.3);
  CHECK(house->roof.kind == cases::RoofKind::vault);
  CHECK(house->roof.beam == std::array{0.15, 0.25});
  CHECK(house->roof.element == 0.3);
  CHECK(house->roof.between_beams == "tied");
  CHECK(house->roof.edge_beams == "loose");
  CHECK(house->roof.radius == 1.25);
  CHECK(house->roof.thickness == 0.15);
  CHECK(house->roof.ring == 0.1);
  CHECK(house->roof.voussoirs == 21);
  REQUIRE(house->openings.size() == 2);
  CHECK(house->openings[0].wall == "rear");
  CHECK(house->openings[0].from == 1.0);
  CHECK(house->openings[0].width == 1.2);
  CHECK(house->openings[0].sill == 0.5);
  CHECK(house->openings[0].height == 1.5);
  REQUIRE(house->openings[0].lintel);
  CHECK(house->openings[0].lintel->length == 1.6);
  CHECK(house->openings[0].lintel->height == 0.15);
  CHECK(house->openings[0].lintel->element == 0.4);
  CHECK(!house->openings[1].lintel);
  REQUIRE(house->reinforcement);
  CHECK(house->reinforcement->column == std::array{0.12, 0.14});
  CHECK(house->reinforcement->ring_beam == std::array{0.16, 0.18});
  CHECK(house->reinforcement->ring_beam_place == cases::RingPlace::middle);
  CHECK(house->reinforcement->bearing == std::vector{0.25, 0.95});
  CHECK(house->reinforcement->nonbearing == std::vector{1.2});
}

TEST_CASE("case file: every key of blocks and loads is read") {
  const cases::Case c = load_case(kEveryKey).value;
  REQUIRE(c.blocks.size() == 4);
  const cases::BlockSpec &box = c.blocks[0], &hexahedron = c.blocks[1], &prism = c.blocks[2];
  CHECK(box.name == "box");
  CHECK(box.cells == cases::CellCounts{4, 2, 1});
  CHECK(box.material == "adobe");
  REQUIRE(box.box);
  CHECK((*box.box)[1] == Vec3{0.2, 0.1, 0.3});
  CHECK(box.free);
  CHECK(!box.fixed);
  CHECK(box.velocity == Vec3{1.0, 2.0, 3.0});
  CHECK(box.angular_velocity == Vec3{4.0, 5.0, 6.0});
  REQUIRE(box.rotate);
  CHECK(box.rotate->axis == Vec3{0.0, 1.0, 0.5});
  CHECK(box.rotate->angle == 10.0);
  CHECK(box.rotate->about == Vec3{0.1, 0.2, 0.3});
  CHECK(!box.motion);
  REQUIRE(hexahedron.vertices.size() == 8);
  CHECK(hexahedron.vertices[7] == Vec3{0.0, 1.0, 1.5});
  CHECK(hexahedron.faces.empty());
  CHECK(c.blocks[3].vertices.size() == 5);
  CHECK(c.blocks[3].faces == std::vector<std::vector<int>>{{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  CHECK(hexahedron.fixed);
  REQUIRE(hexahedron.motion);
  CHECK(hexahedron.motion->velocity == Vec3{0.001, 0.002, 0.003});
  CHECK(!hexahedron.motion->file);
  CHECK(prism.polygon == std::vector<std::array<double, 2>>{{0.0, 0.0}, {1.0, 0.0}, {0.5, 1.0}});
  CHECK(prism.extrude == std::array{0.25, 0.5});
  REQUIRE(prism.motion);
  CHECK(prism.motion->file == "spread.csv");
  REQUIRE(c.loads.size() == 1);
  CHECK(c.loads[0].block == "box");
  CHECK(c.loads[0].force == Vec3{1.0, 2.0, 3.0});
  CHECK(c.loads[0].moment == Vec3{4.0, 5.0, 6.0});
  CHECK(c.loads[0].at == Vec3{0.1, 0.05, 0.15});
  CHECK(c.loads[0].ramp == std::array{0.25, 0.5});
  CHECK(c.loads[0].follows);
}

TEST_CASE("case file: every key of stones is read") {
  const cases::Case c = load_case(kEveryKey).value;
  CHECK(c.materials.at("old wood").inside == "normal");
  CHECK(!c.materials.at("adobe").inside);
  REQUIRE(c.stones.size() == 2);
  const cases::StonesSpec &dome = c.stones[0], &wall = c.stones[1];
  CHECK(dome.file == "dome.obj");
  CHECK(dome.unit == "mm");
  CHECK(dome.name == "east");
  CHECK(dome.only == std::vector<std::string>{"lantern", "Mesh_12"});
  CHECK(dome.place == Vec3{1.0, 2.0, 3.0});
  CHECK(dome.turn.axis == Vec3{0.0, 1.0, 0.5});
  CHECK(dome.turn.angle == 12.0);
  CHECK(dome.turn.about == Vec3{0.1, 0.2, 0.3});
  CHECK(dome.material == "adobe");
  CHECK(dome.joint == "normal");
  CHECK(dome.snap == 0.002);
  CHECK(dome.gap == 0.01);
  CHECK(dome.warped == cases::WarpedFaces::triangles);
  CHECK(dome.supports.kind == cases::StoneSupports::Kind::named);
  CHECK(dome.supports.names == std::vector<std::string>{"Mesh_1", "drum"});
  CHECK(wall.turn.axis == Vec3{0.0, 0.0, 1.0});
  CHECK(wall.turn.angle == 90.0);
  CHECK(wall.snap == 1e-3);
  CHECK(!wall.gap);
  CHECK(wall.warped == cases::WarpedFaces::refuse);
  CHECK(wall.fit == cases::StoneFit::planes);
  CHECK(wall.fit_limit == 0.04);
  CHECK(dome.fit == cases::StoneFit::snap);
  CHECK(wall.supports.kind == cases::StoneSupports::Kind::below);
  CHECK(wall.supports.level == 0.25);
  const auto kind = [](const std::string& word) {
    return read("[[stones]]\nfile = \"a.obj\"\nunit = \"m\"\nsupports = \"" + word + "\"\n").stones[0].supports.kind;
  };
  CHECK(kind("ground") == cases::StoneSupports::Kind::ground);
  CHECK(kind("none") == cases::StoneSupports::Kind::none);
}

TEST_CASE("case file: the example of the manual is read") {
  const cases::Case c = load_case(VOUSSOIR_SOURCE_DIR "/tests/io/input/case_file/data/two_bricks.toml").value;
  CHECK(c.title == "Two bricks on a base");
  CHECK(c.gravity.ramp == 1.0);
  CHECK(c.motion->record == "bam-like");
  CHECK(c.joints.between[0].law == "wood");
  CHECK(c.house);
  CHECK(c.blocks.at(0).rotate->angle == 10.0);
  CHECK(c.blocks.at(0).motion->velocity == Vec3{0.001, 0.0, 0.0});
  CHECK(c.base->tilt == std::array{0.0, 0.0});
}

TEST_CASE("case file: the remaining forms of motion, step and damping") {
  cases::Case c = read("[motion]\nrecord = \"bam-like\"\nscale = 2\n[time]\nstep = \"auto\"\n[damping]\nalpha = 1.52");
  CHECK(c.motion->record == "bam-like");
  CHECK(c.motion->scale == std::array{2.0, 2.0, 2.0});
  CHECK(!c.time.step);
  CHECK(c.damping.alpha == 1.52);
  c = read("motion = { x = \"x.AT2\", z = \"z.AT2\", unit = \"g\" }\nhouse = {}");
  CHECK(c.motion->xyz == std::array<std::optional<std::string>, 3>{"x.AT2", std::nullopt, "z.AT2"});
  REQUIRE(c.house);
  CHECK(c.house->roof.kind == cases::RoofKind::none);
}

TEST_CASE("case file: block.motion goes to the last block") {
  const cases::Case c = read(
      "[[block]]\nname = \"a\"\nmaterial = \"m\"\nbox = [[0,0,0],[1,1,1]]\n"
      "[[block]]\nname = \"b\"\nmaterial = \"m\"\nbox = [[1,0,0],[2,1,1]]\nfixed = true\n[block.motion]\nvelocity = [1,0,0]\n");
  CHECK(!c.blocks[0].motion);
  CHECK(c.blocks[1].motion);
}

TEST_CASE("resolved case: reads back as the same case, and says every key") {
  const cases::Case c = load_case(kEveryKey).value;
  const std::string text = io::resolved_toml(c);
  const cases::Case again = read(text);
  CHECK(io::resolved_toml(again) == text);
  CHECK(again.blocks[0].rotate->axis == c.blocks[0].rotate->axis);
  CHECK(again.materials.at("old wood").young == c.materials.at("old wood").young);
  CHECK(again.house->openings[0].lintel->element == 0.4);
  CHECK(again.motion->ltv == c.motion->ltv);
  CHECK(text.find("unit = \"cm/s2\"") != std::string::npos);
  CHECK(text.find("density = 1800.0") != std::string::npos);
  CHECK(text.find("kg/m3; > 0; mass per volume") != std::string::npos);
  CHECK(text.find("\n# none: alpha") != std::string::npos);
}

TEST_CASE("resolved case: each key given in the full file is written") {
  const LoadedCase loaded = load_case(kEveryKey);
  const LoadedCase again = read_case({"resolved.toml", io::resolved_toml(loaded.value)});
  for (const auto& entry : loaded.keys) {  // clang 14 cannot capture a structured binding
    CAPTURE(entry.first);
    REQUIRE(again.keys.contains(entry.first));
  }
}

TEST_CASE("resolved case: numbers come back bit for bit") {
  std::mt19937_64 random(12345);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = random();
    double v = 0.0;
    std::memcpy(&v, &bits, sizeof v);
    if (!std::isfinite(v)) continue;
    if (std::abs(v) > 1e3) v = 1.0 / v;  // possible ones
    cases::Case c;
    c.gravity.acceleration = {v, -v, v * 0x1p-900};
    const cases::Case again = read(io::resolved_toml(c));
    CAPTURE(v);
    REQUIRE(same(again.gravity.acceleration.x, v));
    REQUIRE(same(again.gravity.acceleration.y, -v));
    REQUIRE(same(again.gravity.acceleration.z, v * 0x1p-900));
  }
}

TEST_CASE("resolved case: strings and names with odd characters come back") {
  cases::Case c;
  c.title = "quote \" backslash \\ tab \t newline \n é 石 #";
  c.materials["a \"b\".c"] = {1.0, 1.0, 0.0};
  c.materials[""] = {2.0, 1.0, 0.0};
  const cases::Case again = read(io::resolved_toml(c));
  CHECK(again.title == c.title);
  CHECK(again.materials.at("a \"b\".c").density == 1.0);
  CHECK(again.materials.at("").density == 2.0);
}

TEST_CASE("key reference: cases/KEYS.md is what the option table says (make it anew: voussoir keys --markdown >cases/KEYS.md)") {
  std::ifstream file(std::string(VOUSSOIR_SOURCE_DIR) + "/cases/KEYS.md");
  const std::string committed{std::istreambuf_iterator<char>(file), {}};
  CHECK(committed == io::key_reference_markdown());
}

TEST_CASE("key reference: all tables and their keys") {
  const std::string text = io::key_reference();
  for (const char* header : {"[gravity]",
                             "[time]",
                             "[damping]",
                             "[materials.<name>]",
                             "[joint_laws.<name>]",
                             "[failure]",
                             "[joints]",
                             "[[joints.between]]",
                             "[contact]",
                             "[[contact.between]]",
                             "[analysis]",
                             "[motion]",
                             "[motion.intensity]",
                             "[segments]",
                             "[output]",
                             "[[output.history]]",
                             "[house]",
                             "[house.wood]",
                             "[house.roof]",
                             "[[house.opening]]",
                             "[house.opening.lintel]",
                             "[house.reinforcement]",
                             "[[block]]",
                             "[block.rotate]",
                             "[block.motion]",
                             "[[load]]",
                             "[base]"}) {
    CAPTURE(header);
    CHECK(text.find(std::string("\n") + header) != std::string::npos);
  }
  CHECK(text.find("  density           required") != std::string::npos);
  CHECK(text.find("  settle_limit      3.0") != std::string::npos);
}
