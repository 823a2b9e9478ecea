// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "io/input/files/hdf5_file.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// A record on its way from the command line to run.h5, by the program.

namespace {

using shell::Outcome;
using voussoir::io::Hdf5File;

/// The program; both of its streams. (`voussoir` is a namespace here.)
Outcome voussoir_says(const std::string& words) { return shell::voussoir(words); }
bool says(const Outcome& o, const std::string& words) { return o.text.find(words) != std::string::npos; }

constexpr const char* kStone = R"(materials.stone = { density = 2000.0, young = 1e8, poisson = 0.2 }
gravity.settle = false
time.duration = 0.04
output.history = [{ name = "top", point = [0.1, 0.1, 0.1] }]
[base]
[[block]]
name = "a"
material = "stone"
box = [[0,0,0],[0.2,0.2,0.2]]
)";

std::string constant(double value) {
  return "t [s], a [m/s2]\n0, " + std::to_string(value) + "\n0.01, " + std::to_string(value) + "\n0.02, " + std::to_string(value) +
         "\n0.03, " + std::to_string(value) + "\n0.04, " + std::to_string(value) + "\n";
}

}  // namespace

TEST_CASE("three files of one station in one option, a window of them, and the motion of the base in run.h5") {
  const TempFolder folder;
  const std::string house = folder.write("case.toml", kStone), l = folder.write("l.csv", constant(1.0)),
                    t = folder.write("t.csv", constant(2.0)), v = folder.write("v.csv", constant(3.0)), out = folder.path("out");
  const std::string motion = " --motion L=" + l + " T=" + t + " V=" + v + " --direction TLV --scale 2";
  Outcome o = voussoir_says("run " + house + motion + " -j 1 -o " + out + " --set motion.from=0.01 --set motion.taper=0.005");
  REQUIRE_MESSAGE(o.code == 0, o.text);
  CHECK(says(o, "motion along x"));
  CHECK(says(o, "peaks 4 m/s2"));
  CHECK(says(o, "from 0.01 s on, tapered over 0.005 and 0.005 s"));
  const Hdf5File run = Hdf5File::open(out + "/run.h5");
  CHECK(run.read<double>("/motion/time") == run.read<double>("/history/time"));
  const auto a = run.read<double>("/motion/acceleration");
  CHECK(a[3 * 15] == doctest::Approx(4.0));  // T goes along x
  CHECK(a[3 * 15 + 1] == doctest::Approx(2.0));
  CHECK(a[3 * 15 + 2] == doctest::Approx(6.0));
  CHECK(a[0] == 0.0);       // the taper
  CHECK(a[3 * 35] == 0.0);  // the window is over
  CHECK(run.attribute_text("/motion/acceleration", "description").find("from 0.01 s on") != std::string::npos);
  CHECK(run.exists("/acceleration/top"));
  o = voussoir_says("check " + out + "/case.toml");
  CHECK(says(o, "motion along z"));
  CHECK(says(o, "from 0.01 s on"));
  CHECK(says(voussoir_says("summary " + out), "peak acceleration"));
  o = voussoir_says("run " + house + motion + " -j 1 -o " + out + "2 --set motion.from=1");
  CHECK(o.code == 2);
  CHECK(says(o, "motion.from = 1 s"));
  CHECK(says(o, "allowed: from 0 to below 0.04"));
}

TEST_CASE("several rates: the motion of the base has the times of the histories") {
  const TempFolder folder;
  const std::string house = folder.write("case.toml", kStone), l = folder.write("l.csv", constant(1.0)), out = folder.path("out");
  const Outcome o = voussoir_says("run " + house + " --quiet -j 1 --motion L=" + l + " -o " + out + " --dt 2e-5 --set time.multirate=8");
  REQUIRE_MESSAGE(o.code == 0, o.text);
  const Hdf5File run = Hdf5File::open(out + "/run.h5");
  CHECK(run.read<double>("/history/time").at(1) == doctest::Approx(1.12e-3));  // 1 ms is no whole cycle
  CHECK(run.read<double>("/motion/time") == run.read<double>("/history/time"));
}

TEST_CASE("a run that is sent further has the bits of one that was not stopped: motion of the base and accelerations too") {
  const TempFolder folder;
  const std::string house = folder.write("case.toml", kStone), l = folder.write("l.csv", constant(1.0));
  const std::string words = "run " + house + " --quiet -j 1 --motion L=" + l + " -o ";
  REQUIRE(voussoir_says(words + folder.path("straight")).code == 0);
  REQUIRE(voussoir_says(words + folder.path("further") + " --duration 0.02").code == 0);
  CHECK(voussoir_says("compare " + folder.path("straight") + " " + folder.path("further")).code == 1);
  REQUIRE(voussoir_says("resume " + folder.path("further") + " --quiet -j 1 --until 0.04").code == 0);
  const Outcome o = voussoir_says("compare " + folder.path("straight") + " " + folder.path("further"));
  CHECK_MESSAGE(o.code == 0, o.text);
}

TEST_CASE("summary: the peak base shear is told as a share of the weight, as by assess") {
  const TempFolder folder;
  const std::string house = folder.write("case.toml", kStone), x = folder.write("x.csv", constant(3.0)), out = folder.path("out");
  REQUIRE(voussoir_says("run " + house + " --motion x=" + x + " -j 1 --quiet -o " + out).code == 0);
  const auto json = [&](const std::string& command) { return nlohmann::json::parse(voussoir_says(command + " " + out + " --format json").text); };
  const auto summary = json("summary"), assessment = json("assess");
  const double share = summary.at("base_shear_over_weight");
  CHECK(share == assessment.at("base_shear_over_weight").get<double>());
  CHECK(share * 0.2 * 0.2 * 0.2 * 2000.0 * 9.8 == doctest::Approx(summary.at("peak_base_shear").get<double>()).epsilon(1e-12));  // N
  char words[32];
  std::snprintf(words, sizeof words, ", %.3f of the weight", share);
  CHECK(says(voussoir_says("summary " + out), words));
}
