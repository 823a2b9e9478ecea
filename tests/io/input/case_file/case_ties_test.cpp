// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>

#include "cases/model.h"
#include "io/input/case_file/case_file.h"
#include "tests/io/temp_folder.h"

// Keys of ties: all are read, and what is wrong with each is said.
namespace voussoir {
namespace {

std::string refusal(const std::string& text) {
  try {
    io::read_case({"test.toml", text}, {});
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

const std::string kTie = "[[tie]]\nname = \"t\"\nfrom = [0,0,0]\nto = [1,0,0]\n", kWhole = kTie + "area = 1e-4\n";
const std::string kAcross = "[[house.tie]]\nname = \"t\"\nkind = \"across\"\nheights = [2.0]\narea = 1e-4\n";
const std::string kMesh = "[[house.mesh]]\nname = \"m\"\nstiffness = 2e5\n";

/// A bar of [[tie]] or of [[house.tie]], in line 1, five lines long.
void check_bar(const std::string& at, const std::string& whole) {
  const auto faulty = [&](const std::string& line, const std::string& says) {
    CHECK(refusal(whole + line) == "test.toml:6: " + at + "." + says);
  };
  CHECK(refusal(whole) == "accepted");
  faulty("young = 0", "young = 0 Pa: must be > 0");
  faulty("yield = -1", "yield = -1 Pa: must be > 0");
  faulty("hardening = -1", "hardening = -1 Pa: must be >= 0");
  faulty("hardening = 1e9", "hardening = 1e+09 Pa needs yield");
  faulty("elongation = 0", "elongation = 0: must be > 0");
  faulty("pretension = -5", "pretension = -5 N: must be >= 0");
  faulty("plate = [0.1, 0]", "plate[1] = 0 m: must be > 0");
  faulty("compression = 1", "compression = 1: found an integer, wanted true or false");
  CHECK(refusal(whole + "yield = 3e8\nhardening = 3e11") == "test.toml:7: " + at + ".hardening = 3e+11 Pa: must be below young");
  CHECK(refusal(whole + "yield = 1e8\npretension = 10001") ==
        "test.toml:7: " + at + ".pretension = 10001 N is over the force at which the tie yields (yield x area)");
  CHECK(refusal(whole + "elongation = 1e-3\nyoung = 1e11\npretension = 10001") ==
        "test.toml:8: " + at + ".pretension = 10001 N is over the force at which the tie breaks (elongation x young x area)");
  CHECK(refusal(whole + "lenght = 1").find("unknown key") != std::string::npos);
}

}  // namespace

TEST_CASE("case file: every key of ties is read") {
  const cases::Case c = io::load_case(VOUSSOIR_SOURCE_DIR "/tests/io/input/case_file/data/every_key.toml").value;
  REQUIRE(c.ties.size() == 1);
  const cases::Tie& t = c.ties[0];
  CHECK(t.name == "rod");
  CHECK(t.from == Vec3{0.1, 0.2, 0.3});
  CHECK(t.to == Vec3{1.1, 0.2, 0.3});
  CHECK(t.area == 2e-4);
  CHECK(t.young == 2e11);
  CHECK(*t.yield == 3e8);
  CHECK(t.hardening == 2e9);
  CHECK(*t.elongation == 0.05);
  CHECK(t.pretension == 5000.0);
  CHECK(t.compression);
  CHECK(*t.plate == std::array{0.2, 0.3});
  REQUIRE(c.house->ties.size() == 3);
  const cases::HouseTie &along = c.house->ties[0], &across = c.house->ties[1], &corner = c.house->ties[2];
  CHECK(along.kind == cases::HouseTieKind::along);
  CHECK(along.bar.name == "wall rods");
  CHECK(along.walls == std::vector<std::string>{"front", "rear"});
  CHECK(along.heights == std::vector{2.2, 2.3});
  CHECK(*along.depth == 0.15);
  CHECK(along.bar.area == 3e-4);
  CHECK(*along.bar.plate == std::array{0.25, 0.35});
  CHECK(across.kind == cases::HouseTieKind::across);
  CHECK(across.at == std::vector{1.5, 3.5});
  CHECK(corner.kind == cases::HouseTieKind::corner);
  CHECK(corner.reach == 0.75);
  REQUIRE(c.house->meshes.size() == 1);
  const cases::HouseMesh& m = c.house->meshes[0];
  CHECK(m.name == "net");
  CHECK(m.walls == std::vector<std::string>{"left"});
  CHECK(m.from == 0.5);
  CHECK(*m.to == 1.5);
  CHECK(m.spacing == std::array{0.25, 0.15});
  CHECK(m.faces == cases::MeshFaces::both);
  CHECK(m.stiffness == 2e5);
  CHECK(*m.strength == 4e3);
  CHECK(*m.elongation == 0.12);
  REQUIRE(m.connectors);
  CHECK(m.connectors->every == 3);
  CHECK(m.connectors->area == 1e-5);
  CHECK(m.connectors->young == 1e9);
  CHECK(*m.connectors->yield == 2e7);
  CHECK(*m.connectors->elongation == 0.2);
}

TEST_CASE("ready parts strengthen a ready house, from any folder") {
  const TempFolder folder;
  const cases::Case c = io::load_case(folder.write("mine.toml", "include = [\"flat20n\", \"parts/corner-ties\"]\n")).value;
  CHECK(c.house->ties.size() == 1);
  folder.write("parts/corner-ties.toml", "title = \"my own\"\n");
  CHECK(io::load_case(folder.write("own.toml", "include = [\"flat20n\", \"parts/corner-ties.toml\"]\n")).value.title == "my own");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VOUSSOIR_SOURCE_DIR "/cases/catalogue/studies/strengthening/houses")) {
    const std::string name = entry.path().stem();
    CAPTURE(name);
    const cases::Case strengthened = io::load_case(entry.path()).value;
    const cases::Model m = cases::build_model(strengthened);
    CHECK(strengthened.title.starts_with("Flat20N with "));
    CHECK(m.ties.empty() == (name == "ring-beam" || name == "buttresses"));
    if (name == "corner-ties") CHECK(m.tie_bill.at(0).ties == 12);
    if (name == "wall-rods") CHECK(m.tie_bill.at(0).length == doctest::Approx(2.0 * (5.4 + 3.4)).epsilon(1e-12));
    if (name == "cross-ties") CHECK(m.tie_bill.at(0).anchors == 6);
    ++files;
  }
  CHECK(files == 7);
  files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(VOUSSOIR_SOURCE_DIR "/cases/catalogue/studies/strengthening-two-storeys/houses")) {
    const std::string name = entry.path().stem();
    CAPTURE(name);
    const cases::Case strengthened = io::load_case(entry.path()).value;
    CHECK(strengthened.title.starts_with("Two storeys with "));
    CHECK(cases::build_model(strengthened).ties.empty() == (name == "strong-mortar"));
    ++files;
  }
  CHECK(files == 6);
}

TEST_CASE("faults: ties") {
  CHECK(refusal("[[tie]]\nfrom = [0,0,0]\nto = [1,0,0]\narea = 1e-4") ==
        "test.toml:1: tie[0].name is missing; wanted a string in quotes, not empty: a name of its own, for results and messages");
  CHECK(refusal("[[tie]]\nname = \"t\"\nto = [1,0,0]\narea = 1e-4").starts_with("test.toml:1: tie[0].from is missing; wanted an array"));
  CHECK(refusal("[[tie]]\nname = \"t\"\nfrom = [1,0,0]\narea = 1e-4").starts_with("test.toml:1: tie[0].to is missing; wanted an array"));
  CHECK(refusal(kTie).starts_with("test.toml:1: tie[0].area is missing; wanted a number, m2, > 0"));
  CHECK(refusal(kTie + "area = 0") == "test.toml:5: tie[0].area = 0 m2: must be > 0");
  check_bar("tie[0]", kWhole);
}

TEST_CASE("faults: ties of houses") {
  const std::string corner = "[[house.tie]]\nkind = \"corner\"\nname = \"t\"\nheights = [2.0]\narea = 1e-4\n";
  const std::string along = "[[house.tie]]\nkind = \"along\"\nname = \"t\"\nheights = [2.0]\narea = 1e-4\n";
  check_bar("house.tie[0]", along);
  CHECK(refusal("[[house.tie]]\nname = \"t\"\nheights = [2.0]\narea = 1e-4").starts_with("test.toml:1: house.tie[0].kind is missing"));
  CHECK(refusal("[[house.tie]]\nkind = \"along\"\nheights = [2.0]\narea = 1e-4").starts_with("test.toml:1: house.tie[0].name is missing"));
  CHECK(refusal("[[house.tie]]\nkind = \"along\"\nname = \"t\"\narea = 1e-4").starts_with("test.toml:1: house.tie[0].heights is missing"));
  CHECK(refusal("[[house.tie]]\nkind = \"round\"\nname = \"t\"\nheights = [2.0]\narea = 1e-4") ==
        "test.toml:2: house.tie[0].kind = \"round\": must be \"along\" | \"across\" | \"corner\"");
  CHECK(refusal(kAcross) == "test.toml:1: house.tie[0] needs at (kind = \"across\")");
  CHECK(refusal(kAcross + "at = []") == "test.toml:1: house.tie[0] needs at (kind = \"across\")");
  CHECK(refusal(kAcross + "at = [1.0, -1.0]") == "test.toml:6: house.tie[0].at[1] = -1 m: must be >= 0");
  CHECK(refusal(kAcross + "at = [1.0]\nreach = 1.0") ==
        "test.toml:7: house.tie[0].reach = 1 m does not go with this kind, but with kind = \"corner\"");
  CHECK(refusal(corner) == "test.toml:1: house.tie[0] needs reach (kind = \"corner\")");
  CHECK(refusal(corner + "reach = 0.0") == "test.toml:1: house.tie[0] needs reach (kind = \"corner\")");
  CHECK(refusal(corner + "reach = -1.0") == "test.toml:6: house.tie[0].reach = -1 m: must be >= 0");
  CHECK(refusal(corner + "reach = 1.0\ndepth = 0.1") ==
        "test.toml:7: house.tie[0].depth = 0.1 m does not go with this kind, but with kind = \"along\"");
  CHECK(refusal(along + "at = [1.0]") == "test.toml:6: house.tie[0].at = [1] m does not go with this kind, but with kind = \"across\"");
  CHECK(refusal(along + "depth = -0.1") == "test.toml:6: house.tie[0].depth = -0.1 m: must be >= 0");
  CHECK(refusal("[[house.tie]]\nkind = \"along\"\nname = \"t\"\nheights = []\narea = 1e-4") ==
        "test.toml:4: house.tie[0].heights = [] m has no height");
}

TEST_CASE("faults: meshes of houses") {
  CHECK(refusal(kMesh) == "accepted");
  CHECK(refusal("[[house.mesh]]\nstiffness = 2e5").starts_with("test.toml:1: house.mesh[0].name is missing"));
  CHECK(refusal("[[house.mesh]]\nname = \"m\"").starts_with("test.toml:1: house.mesh[0].stiffness is missing"));
  const auto faulty = [&](const std::string& line, const std::string& says) {
    CHECK(refusal(kMesh + line) == "test.toml:4: house.mesh[0]." + says);
  };
  faulty("walls = [\"\"]", "walls[0] = \"\": must not be empty");
  faulty("from = -1.0", "from = -1 m: must be >= 0");
  faulty("to = 0.0", "to = 0 m: must be > 0");
  faulty("spacing = [0.2, 0.0]", "spacing[1] = 0 m: must be > 0");
  faulty("faces = \"front\"", "faces = \"front\": must be \"both\" | \"outside\" | \"inside\"");
  faulty("strength = 0", "strength = 0 N/m: must be > 0");
  faulty("elongation = 0", "elongation = 0: must be > 0");
  CHECK(refusal(kMesh + "from = 1.0\nto = 1.0") == "test.toml:5: house.mesh[0].to = 1 m: must be above house.mesh.from");
  CHECK(refusal("[[house.mesh]]\nname = \"m\"\nstiffness = 0") == "test.toml:3: house.mesh[0].stiffness = 0 N/m: must be > 0");
  const std::string c = kMesh + "[house.mesh.connectors]\n";
  CHECK(refusal(c + "area = 1e-5") == "accepted");
  CHECK(refusal(c).starts_with("test.toml:4: house.mesh[0].connectors.area is missing"));
  CHECK(refusal(c + "area = 0") == "test.toml:5: house.mesh[0].connectors.area = 0 m2: must be > 0");
  CHECK(refusal(c + "area = 1e-5\nevery = 0") == "test.toml:6: house.mesh[0].connectors.every = 0: must be in [1, 1000]");
  CHECK(refusal(c + "area = 1e-5\nyoung = 0") == "test.toml:6: house.mesh[0].connectors.young = 0 Pa: must be > 0");
  CHECK(refusal(c + "area = 1e-5\nyield = 0") == "test.toml:6: house.mesh[0].connectors.yield = 0 Pa: must be > 0");
  CHECK(refusal(c + "area = 1e-5\nelongation = 0") == "test.toml:6: house.mesh[0].connectors.elongation = 0: must be > 0");
  CHECK(refusal(kMesh + "faces = \"inside\"\nconnectors = { area = 1e-5 }").find("connectors needs faces = \"both\"") != std::string::npos);
}

}  // namespace voussoir
