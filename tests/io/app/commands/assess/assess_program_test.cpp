// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "solver/limit/programme/linear_programme.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// `voussoir limit` and `voussoir assess` as a user types them.
namespace {

using Json = nlohmann::json;

/// A dry block of 0.4 × 0.3 × 1.0 m and 240 kg that stands, with a cut at its foot.
const char* const kBlock = R"(title = "a block"
[materials.stone]
density = 2000.0
young = 1e9
poisson = 0.2
[segments]
rule = "rim"
[contact]
friction = 60.0
[gravity]
ramp = 0.2
[damping]
ratio = 0.5
frequency = 20.0
[time]
duration = 0.1
[base]
[[output.history]]
name = "block"
point = [0.2, 0.15, 0.5]
[[output.cut]]
name = "foot"
point = [0.2, 0.15, 0.0]
[[block]]
name = "block"
material = "stone"
box = [[0.0, 0.0, 0.0], [0.4, 0.3, 1.0]]
)";

struct Words {
  TempFolder folder;
  Words() { folder.write("block.toml", kBlock); }
  [[nodiscard]] shell::Outcome run(const std::string& words) const { return output(words + " 2>&1"); }
  /// Without what goes to standard error, as a note on the damping of this block.
  [[nodiscard]] shell::Outcome output(const std::string& words) const {
    return shell::run("cd " + shell::quoted(folder.path()) + " && " + shell::kProgram + " " + words);
  }
};

}  // namespace

TEST_CASE("limit: multiplier and mechanism in words and as JSON" * doctest::skip(!voussoir::solver::has_linear_programmes())) {
  const Words w;
  const shell::Outcome text = w.run("limit block.toml --direction -x --quiet");
  CHECK(text.code == 0);
  CHECK(text.text.find("0.40000, as on a base tilted by 21.801 degrees") != std::string::npos);
  CHECK(text.text.find("turns about (0.000, -1.000, 0.000) through (0.000, 0.150, 0.000)") != std::string::npos);
  const Json json = Json::parse(w.output("limit block.toml --format json --quiet --mechanism m.csv").text);
  CHECK(json["associated"]["multiplier"].get<double>() == doctest::Approx(0.4));
  CHECK(json["coulomb"]["parts"][0]["elements"] == Json::array({0}));
  CHECK(shell::text_of(w.folder.path("m.csv")).starts_with("flow,element,tag,part,vx,vy,vz,wx,wy,wz\nassociated,0,\"block\",1,"));
  CHECK(w.run("limit block.toml --quiet --mechanism m.csv").code == 3);  // it is there already
  const shell::Outcome bad = w.run("limit block.toml --direction up");
  CHECK(bad.code == 2);
  CHECK(bad.text.find("--direction: \"up\" is none; allowed: x, -x, y, -y, z, -z, degrees") != std::string::npos);
  const shell::Outcome leaning = w.run("limit block.toml --set base.tilt=[0.0,30.0]");
  CHECK(leaning.code == 2);
  CHECK(leaning.text.find("does not stand under its dead loads alone") != std::string::npos);
}

TEST_CASE("assess: a cut at the foot of a block at rest bears its weight") {
  const Words w;
  REQUIRE(w.run("run block.toml -o out --quiet -j 1").code == 0);
  const shell::Outcome text = w.run("assess out --spectra s.csv --damping 0.02,0.05");
  CHECK(text.code == 0);
  CHECK(text.text.find("foot") != std::string::npos);
  const Json json = Json::parse(w.run("assess out --format json").text);
  const double weight = 2000.0 * 0.4 * 0.3 * 1.0 * 9.8;
  CHECK(json["weight"].get<double>() == doctest::Approx(weight));
  CHECK(json["cuts"][0]["name"] == "foot");
  CHECK(json["cuts"][0]["axial"]["value"].get<double>() == doctest::Approx(-weight).epsilon(1e-3));
  CHECK(std::abs(json["cuts"][0]["bending"]["value"].get<double>()) < 1e-3 * weight);
  CHECK(shell::text_of(w.folder.path("s.csv")).find("\"block\",z,0.05,") != std::string::npos);
  CHECK(w.run("assess out --maps maps").code == 2);  // a block has no walls
  CHECK(w.run("run block.toml -o other --quiet --set output.cut[0].point=[0.0,0.0,5.0]").text.find("cuts no joint") != std::string::npos);
}

TEST_CASE("capacity: a slab that tips off its foot before it is pushed is told as fallen, with its share of the mass") {
  const Words w;
  const std::string block(kBlock), head = block.substr(0, block.find("[[output.history]]"));
  const auto two = [&](const std::string& slab) {
    return head + "[analysis]\nkind = \"pushover\"\nlargest_factor = 0.1\n" +
           "[[block]]\nname = \"foot\"\nmaterial = \"stone\"\nbox = [[0.0, 0.0, 0.0], [0.2, 0.2, 0.2]]\n" +
           "[[block]]\nname = \"slab\"\nmaterial = \"stone\"\nbox = " + slab + "\n";
  };
  w.folder.write("falls.toml", two("[[0.15, 0.0, 0.2], [0.55, 0.2, 0.3]]"));
  w.folder.write("stands.toml", two("[[0.0, 0.0, 0.2], [0.2, 0.2, 0.4]]"));
  for (const std::string name : {"falls", "stands"}) {
    REQUIRE(w.run("run " + name + ".toml -o " + name + " --quiet -j 1").code == 0);
    const Json capacity = Json::parse(w.run("summary " + name + " --format json").text)["capacity"];
    CHECK(capacity["fallen_before"].get<double>() == doctest::Approx(name == "falls" ? 0.5 : 0.0));
  }
  CHECK(w.run("summary falls").text.find("before the load      50.0 % of the mass fell") != std::string::npos);
}

TEST_CASE("assess: the map of a wall lies in its folder whatever the wall's name") {
  const Words w;
  w.folder.write("walls.toml", std::string(kBlock) + "part = \"../x wall\"\n[[block]]\nname = \"other\"\nmaterial = \"stone\"\n" +
                                   "part = \"a/b wall\"\nbox = [[1.0, 0.0, 0.0], [1.4, 0.3, 1.0]]\n[[block]]\nname = \"third\"\n" +
                                   "material = \"stone\"\npart = \"a b wall\"\nbox = [[2.0, 0.0, 0.0], [2.4, 0.3, 1.0]]\n");
  REQUIRE(w.run("run walls.toml -o out --quiet -j 1").code == 0);
  const shell::Outcome o = w.run("assess out --maps maps");
  CHECK_MESSAGE(o.code == 0, o.text);
  for (const char* name : {"maps/_.-x-wall-0.100s.svg", "maps/a-b-wall-0.100s.svg", "maps/a-b-wall_-0.100s.svg"})
    CHECK_MESSAGE(std::filesystem::exists(w.folder.path(name)), o.text);
}

TEST_CASE("assess: the motion of the base is the run's, though its record has gone") {
  const Words w;
  w.folder.write("x.csv", "t [s],a [m/s2]\n0,0\n0.05,2\n0.1,0\n");
  REQUIRE(w.run("run block.toml -o out --quiet -j 1 --motion x=x.csv").code == 0);
  const std::string before = w.run("assess out").text;
  CHECK(before.find("base ") != std::string::npos);
  std::filesystem::remove(w.folder.path("x.csv"));
  const shell::Outcome after = w.run("assess out");
  CHECK(after.code == 0);
  CHECK(after.text == before);
  w.folder.write("s.csv", "mine");
  const shell::Outcome refused = w.run("assess out --spectra s.csv");  // before anything else is said
  CHECK(refused.code == 3);
  CHECK(refused.text.find("base shear") == std::string::npos);
}
