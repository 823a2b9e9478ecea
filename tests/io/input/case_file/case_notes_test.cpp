// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"

// Findings: values that are let through, though no building has them: most are slips of units.

using namespace voussoir;

namespace {

using Notes = std::vector<std::string>;

Notes notes_of(const std::string& text) { return io::read_case({"test.toml", text}).findings; }

const std::string kStone = "[materials.stone]\nyoung = 10e9\npoisson = 0.2\n";
const std::string kLaw = "[joint_laws.lime]\ncompression = 2e6\n";

}  // namespace

TEST_CASE("notes: an unusual value is told with its place, its unit and what is usual; zero mostly means none") {
  CHECK(notes_of(kStone + "density = 2200.0\n") == Notes{});
  CHECK(notes_of(kStone + "density = 2.2\n") ==
        Notes{"test.toml:4: materials.stone.density = 2.2 kg/m3 is unusual; usually 200 to 12000 kg/m3"});
  CHECK(notes_of(kLaw + "tension = 0.05\ncohesion = 0\nfriction = 0.5\n") ==
        Notes{"test.toml:3: joint_laws.lime.tension = 0.05 Pa is unusual; usually 100 to 1e13 Pa",
              "test.toml:5: joint_laws.lime.friction = 0.5 degrees is unusual; usually 5 to 75 degrees"});
  CHECK(notes_of("[house]\nbrick = [250, 120, 60]\n").size() == 3);  // mm
  CHECK(io::read_case({"test.toml", kStone + "density = 2200.0\n"}, {"materials.stone.density=5e4"}).findings ==
        Notes{"--set materials.stone.density=5e4: materials.stone.density = 50000 kg/m3 is unusual; usually 200 to 12000 kg/m3"});
}

TEST_CASE("notes: keys of another kind of roof, in the file that says the kind") {
  const std::string vault = "[house.roof]\nkind = \"vault\"\n", flat = "[house.roof]\nkind = \"flat\"\n";
  CHECK(notes_of(vault + "radius = 1.4\nthickness = 0.1\nring = 0.3\nvoussoirs = 21\n") == Notes{});
  CHECK(notes_of(flat + "beam = [0.1, 0.15]\nelement = 0.3\nbetween_beams = \"wood\"\nedge_beams = \"normal\"\n") == Notes{});
  CHECK(notes_of(vault + "beam = [0.1, 0.15]\n") ==
        Notes{"test.toml:3: house.roof.beam = [0.1, 0.15] m has no effect with this kind of roof; it belongs to flat and pitched ones"});
  CHECK(notes_of(flat + "radius = 1.4\nring = 0.3\n").size() == 2);
  CHECK(notes_of("[house.roof]\nkind = \"gables\"\nradius = 1.4\nthickness = 0.1\n").size() == 1);
  CHECK(notes_of(vault + "beam = [0.2, 0.2]\n") == Notes{});  // the default, as a resolved case has it
  CHECK(io::read_case({"test.toml", flat + "beam = [0.1, 0.15]\n"}, {"house.roof.kind=vault"}).findings == Notes{});  // meant so
}

TEST_CASE("notes: levels of intensity that look like g") {
  const auto of_level = [](const std::string& keys) { return notes_of("[motion]\nrecord = \"bam-like\"\n[motion.intensity]\n" + keys); };
  CHECK(of_level("measure = \"PGA\"\nlevel = 3.0\n") == Notes{});
  CHECK(of_level("measure = \"PGV\"\nlevel = 0.3\n") == Notes{});
  CHECK(of_level("measure = \"PGA\"\nlevel = 0.25\n") ==
        Notes{"test.toml:5: motion.intensity.level = 0.25 is unusual; usually 0.5 to 45 m/s2 (not g)"});
}

TEST_CASE("notes: gravity that is not that of the earth; mortar without a thickness") {
  CHECK(notes_of("[gravity]\nacceleration = [0, 0, -9.81]\n") == Notes{});
  CHECK(notes_of("[gravity]\nacceleration = [0, 0, 0]\n") == Notes{});
  CHECK(notes_of("[gravity]\nacceleration = [0, 0, 9.81]\n") ==
        Notes{"test.toml:2: gravity.acceleration = [0, 0, 9.81] m/s2 does not point down; usually [0, 0, -9.81]"});
  CHECK(notes_of("[gravity]\nacceleration = [0, 0, -1]\n") ==
        Notes{"test.toml:2: gravity.acceleration = [0, 0, -1] m/s2 is not that of the earth; usually [0, 0, -9.81]"});
  const Notes rigid = notes_of(kLaw + "tension = 5e4\ncohesion = 8e4\nfriction = 30\nyoung = 2500.0e6\npoisson = 0.2\n");
  REQUIRE(rigid.size() == 1);
  CHECK(rigid[0].starts_with("test.toml:6: joint_laws.lime.young = "));
  CHECK(rigid[0].ends_with(" has no effect without the thickness of the mortar (m), or stones.gap"));
}
