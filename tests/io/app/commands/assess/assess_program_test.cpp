// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

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
  const shell::Outcome damped = w.run("limit block.toml --quiet --set 'damping.frequency=\"auto\"'");
  CHECK(damped.code == 0);
  CHECK(damped.text.find("damping.frequency") == std::string::npos);  // nothing is damped, so no mode is computed
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
  CHECK_MESSAGE(o.text.find("maps/") > o.text.find("acceleration [m/s2]"), o.text);  // names of maps after all tables
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

TEST_CASE("assess: a pushover against a spectrum, and what it has to say where it cannot compare") {
  const Words w;
  const std::string block(kBlock);
  w.folder.write("push.toml", block.substr(0, block.find("[[output.history]]")) +
                                  "[analysis]\nkind = \"pushover\"\ndemand = \"ec8:1:B:0.2g\"\n" + block.substr(block.find("[[block]]")));
  REQUIRE(w.run("run push.toml -o out --quiet -j 1").code == 0);
  // One element, so φ = 1 and Γ = 1; frames are in single precision.
  const Json capacity = Json::parse(w.run("summary out --format json").text)["capacity"];
  CHECK(capacity["participation"].get<double>() == doctest::Approx(1.0).epsilon(2e-4));
  CHECK(capacity["equivalent_mass"].get<double>() == doctest::Approx(240.0).epsilon(2e-4));
  const double period = capacity["n2_ec8_period"].get<double>(), force = capacity["ec8_force"].get<double>();
  const double yield = capacity["ec8_yield"].get<double>();
  CHECK(period == doctest::Approx(2.0 * 3.14159265358979 * std::sqrt(240.0 * yield / force)).epsilon(2e-4));
  const shell::Outcome text = w.output("assess out --demand ec8:1:B:0.05g --demand-damping 0.05");
  CHECK(text.code == 0);
  CHECK(text.text.find("demand               ec8:1:B:0.05g, 5.0 % of damping, T_C 0.50 s") != std::string::npos);
  CHECK(text.text.find("equivalent system    participation 1.000, m* 0.24 t of 0.24 t, effective 100.0 %") != std::string::npos);
  const Json json = Json::parse(w.output("assess out --format json").text)["capacity"]["performance"];
  CHECK(json["spectrum"] == "ec8:1:B:0.2g");
  CHECK(json["points"][0]["target"].get<double>() == doctest::Approx(capacity["n2_ec8_target"].get<double>()));
  w.folder.write("s.csv", "0.01, 2\n3.0, 2\n");
  CHECK(w.run("assess out --demand s.csv").text.find("the unit of acceleration is not stated") != std::string::npos);
  CHECK(w.run("assess out --demand s.csv --unit m/s2 --corner-period 0.4").text.find("T_C 0.40 s") != std::string::npos);
  const std::string over = "--demand s.csv --unit m/s2 --corner-period 0.4 --spectra s.csv --overwrite";
  CHECK(w.run("assess out " + over).code == 3);  // its own input
  CHECK(shell::text_of(w.folder.path("s.csv")) == "0.01, 2\n3.0, 2\n");
  const shell::Outcome unknown = w.run("assess out --demand ec8:1:Q:0.2g");
  CHECK(unknown.code == 2);
  CHECK(unknown.text.find("--demand: 'ec8:1:Q:0.2g': no ground 'Q'; allowed: ec8:TYPE:GROUND:AG") != std::string::npos);
  CHECK(w.run("assess out --corner-period 0.4").text.find("--demand: is missing") != std::string::npos);
  REQUIRE(w.run("run block.toml -o shaken --quiet -j 1").code == 0);
  const shell::Outcome none = w.run("assess shaken --demand ec8:1:B:0.2g");
  CHECK(none.code == 2);
  CHECK(none.text.find("asks for the capacity curve of a pushover") != std::string::npos);
}

TEST_CASE("limit: the kinematic analysis of a block, and what it asks for" * doctest::skip(!voussoir::solver::has_linear_programmes())) {
  const Words w;
  const shell::Outcome text = w.output("limit block.toml --kinematic --demand ec8:1:B:0.2g --quiet --associated");
  CHECK(text.code == 0);
  CHECK(text.text.find("multiplier 0.40000, e* 1.0000, a_0 = 2.9037 m/s2 with FC = 1.35") != std::string::npos);
  CHECK(text.text.find("d_C0 = 0.20000 m, d_0 = 0.20000 m") != std::string::npos);
  CHECK(text.text.find("linear, SLV, q = 2       demand 1.177 m/s2, capacity 2.904 m/s2: demand over capacity 0.405") != std::string::npos);
  const Json json = Json::parse(w.output("limit block.toml --kinematic --confidence 1 --quiet --format json").text);
  CHECK(json["associated"]["kinematic"]["activation"].get<double>() == doctest::Approx(0.4 * 9.8));
  CHECK(json["coulomb"]["kinematic"]["zero"].get<double>() == doctest::Approx(0.2).epsilon(1e-5));
  for (const char* bad : {"--demand ec8:1:B:0.2g", "--kinematic --direction z", "--kinematic --on block", "--kinematic --height 3",
                          "--kinematic --demand ec8:1:B:0.2g --height 9 --building-height 8 --building-period 0.3"})
    CHECK_MESSAGE(w.run(std::string("limit block.toml --associated --quiet ") + bad).code == 2, bad);
}

TEST_CASE("states of rest have no speeds and no accelerations, and their times are explained") {
  const Words w;
  const shell::Outcome run = w.output("run block.toml -o rest --set analysis.kind=rest --quiet");
  REQUIRE_MESSAGE(run.code == 0, run.text);
  const shell::Outcome summary = w.output("summary rest"), assess = w.output("assess rest");
  for (const shell::Outcome* o : {&run, &summary, &assess}) {
    CHECK_MESSAGE(o->text.find("times                are iterations of the search for equilibrium") != std::string::npos, o->text);
    CHECK_MESSAGE(o->text.find("peak speed") == std::string::npos, o->text);
    CHECK_MESSAGE(o->text.find("acceleration") == std::string::npos, o->text);
  }
  REQUIRE(w.output("run block.toml -o shaken --quiet").code == 0);
  CHECK(w.output("summary shaken").text.find("peak speed") != std::string::npos);
  CHECK(w.output("assess shaken").text.find("acceleration [m/s2]") != std::string::npos);
}

TEST_CASE("limit: what moves is told by walls, which fall the way that they are pushed" *
          doctest::skip(!voussoir::solver::has_linear_programmes())) {
  const Words w;
  const std::string hut = shell::quoted(VOUSSOIR_SOURCE_DIR "/cases/tutorial/hut.toml");
  for (const auto& [direction, wall, sign] : {std::tuple{"x", "right wall", 1.0}, {"-x", "left wall", -1.0}}) {
    const shell::Outcome o = w.output("limit " + hut + " --associated --quiet --direction " + direction);
    REQUIRE_MESSAGE(o.code == 0, o.text);
    const std::size_t table = o.text.find("\nmoving part"), first = o.text.find('\n', table + 1) + 1;
    REQUIRE_MESSAGE(table != std::string::npos, o.text);
    const std::string line = o.text.substr(first, o.text.find('\n', first) - first);
    CHECK_MESSAGE(line.starts_with(wall), line);
    std::array<double, 3> v{};
    REQUIRE(std::sscanf(line.c_str() + line.find('('), "(%lf,%lf,%lf)", &v[0], &v[1], &v[2]) == 3);
    CHECK_MESSAGE(sign * v[0] > 0.2, line);
    CHECK_MESSAGE(std::abs(v[1]) < 0.5 * std::abs(v[0]), line);
  }
  CHECK(w.output("limit block.toml --quiet").text.find("moving part") == std::string::npos);  // of one block there is nothing to tell
}

TEST_CASE("modes: the eigenvalue beside the impulse is the building's, however many local modes lie below") {
  // A block on a bed of mortar, and twelve light ones that hang on soft joints at its side.
  std::string text =
      "title = \"local modes\"\n[gravity]\nsettle = false\n[damping]\nratio = 0.02\nfrequency = 20.0\n[time]\nduration = 0.1\n"
      "[materials.stone]\ndensity = 2000.0\nyoung = 1e9\npoisson = 0.2\n[materials.cork]\ndensity = 100.0\nyoung = 1e9\npoisson = 0.2\n"
      "[joint_laws.bed]\ntension = 1e6\ncohesion = 1e6\nfriction = 30.0\ncompression = 1e7\nthickness = 0.01\nyoung = 2e7\npoisson = 0.2\n"
      "[joint_laws.soft]\ntension = 1e6\ncohesion = 1e6\nfriction = 30.0\ncompression = 1e7\nthickness = 0.01\nyoung = 2e3\npoisson = 0.2\n"
      "[joints]\ndefault = \"bed\"\n[[joints.between]]\nmaterials = [\"cork\", \"stone\"]\nlaw = \"soft\"\n[contact]\nfriction = "
      "30.0\n[base]\n"
      "[[block]]\nname = \"body\"\nmaterial = \"stone\"\nbox = [[0.0, 0.0, 0.0], [3.0, 0.5, 0.8]]\n";
  for (int k = 0; k < 12; ++k) {
    char block[160];
    std::snprintf(block, sizeof block, "[[block]]\nname = \"cork %d\"\nmaterial = \"cork\"\nbox = [[%.2f, 0.5, 0.4], [%.2f, 0.6, 0.5]]\n",
                  k, 0.05 + 0.24 * k, 0.15 + 0.24 * k);
    text += block;
  }
  const Words w;
  w.folder.write("local.toml", text);
  const shell::Outcome o = w.output("modes local.toml --count 8 -j 1 --quiet");
  REQUIRE_MESSAGE(o.code == 0, o.text);
  std::array<double, 2> told{}, row{};
  for (const int axis : {0, 1}) {
    const std::size_t end = o.text.find(std::string("   the building along ") + "xy"[axis]);
    REQUIRE_MESSAGE(end != std::string::npos, o.text);
    told[static_cast<std::size_t>(axis)] = std::stod(o.text.substr(o.text.rfind('\n', end) + 1));
  }
  REQUIRE(std::sscanf(o.text.c_str() + o.text.find("\neigenvalue  ") + 11, "%lf %lf", &row[0], &row[1]) == 2);
  CHECK(row == told);
}
