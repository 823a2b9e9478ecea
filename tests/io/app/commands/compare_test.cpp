// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/output/measures/compared_measures.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

using voussoir::io::measures_beside;
using voussoir::io::measures_beside_json;
using Json = nlohmann::ordered_json;

namespace {

const std::string kA =
    R"({"end_time": 2.5, "damage_grade": 3, "collapse_time": -1.0, "fallen_mass_fraction": 0.25, "peak_drift": 0.031, "free_volume": null,
        "first_fallen_wall": "front", "walls": [{"name": "front", "peak_drift": 0.031, "first_fallen_time": -1.0},
        {"name": "left", "peak_drift": null, "first_fallen_time": 1.5}]})";
const std::string kB =
    R"({"end_time": 2.5, "damage_grade": 5, "collapse_time": 2.25, "fallen_mass_fraction": 0.75, "peak_drift": 0.021, "free_volume": null,
        "first_fallen_wall": "rear", "walls": [{"name": "rear", "peak_drift": 0.5, "first_fallen_time": 2.0},
        {"name": "front", "peak_drift": 0.021, "first_fallen_time": 1.0}]})";

/// The cells of the line that begins so.
std::vector<std::string> cells(const std::string& text, const std::string& label) {
  std::stringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(label + " ")) continue;
    std::stringstream in(line.substr(label.size()));
    std::vector<std::string> all;
    for (std::string word; in >> word;) all.push_back(word);
    return all;
  }
  return {};
}

using shell::Outcome;
/// The program; its standard output.
Outcome the_program(const std::string& words) { return shell::run(shell::kProgram + " " + words + " 2>/dev/null"); }
bool says(const Outcome& o, const std::vector<std::string>& words) {
  for (const std::string& w : words) {
    if (o.text.find(w) == std::string::npos) return false;
  }
  return true;
}

Json row(const Json& rows, const std::string& name) {
  for (const Json& r : rows) {
    if (r["name"] == name) return r;
  }
  return {};
}

}  // namespace

TEST_CASE("compare: measures side by side, with their difference") {
  using Cells = std::vector<std::string>;
  const std::string text = measures_beside(kA, kB);
  CHECK(cells(text, "run to [s]") == Cells{"2.500", "2.500", "0"});
  CHECK(cells(text, "damage grade (EMS-98)") == Cells{"3", "5", "+2"});
  CHECK(cells(text, "collapsed at [s]") == Cells{"never", "2.250", "-"});
  CHECK(cells(text, "fallen mass [%]") == Cells{"25.0", "75.0", "+50.0"});
  CHECK(cells(text, "out-of-plane drift [%]") == Cells{"3.10", "2.10", "-1.00"});
  CHECK(cells(text, "front: drift [%]") == Cells{"3.10", "2.10", "-1.00"});
  CHECK(cells(text, "front: first fallen [s]") == Cells{"never", "1.000", "-"});
  CHECK(cells(text, "left: first fallen [s]") == Cells{"1.500", "-", "-"});
  CHECK(cells(text, "rear: drift [%]") == Cells{"-", "50.00", "-"});
  CHECK(cells(measures_beside(kA, kA), "front: drift [%]").empty());  // of walls only what differs
  CHECK(cells(text, "free volume [%]").empty());                      // neither has a room
}

TEST_CASE("compare: the same for programs") {
  const Json rows = Json::parse(measures_beside_json(kA, kB));
  CHECK(row(rows, "damage_grade")["difference"] == 2);
  CHECK(row(rows, "peak_drift")["difference"].get<double>() == doctest::Approx(-0.01));
  CHECK(row(rows, "collapse_time")["difference"].is_null());
  CHECK(row(rows, "first_fallen_wall")["b"] == "rear");
  CHECK(row(rows, "front: peak_drift")["a"] == 0.031);
  CHECK(row(rows, "rear: peak_drift")["a"].is_null());
}

TEST_CASE("compare: the end of a run that stopped while settling, and times of settling, are times; what never came is none") {
  const std::string a = R"({"end_time": -0.25, "collapse_time": -1.0, "settling_first_crack_time": -0.5})";
  const std::string b = R"({"end_time": 2.0, "collapse_time": 1.5, "settling_first_crack_time": -0.3})";
  const std::string text = measures_beside(a, b);
  CHECK(cells(text, "run to [s]") == std::vector<std::string>{"-0.250", "2.000", "+2.250"});
  CHECK(cells(text, "collapsed at [s]") == std::vector<std::string>{"never", "1.500", "-"});
  const Json json = Json::parse(measures_beside_json(a, b));
  CHECK(row(json, "settling_first_crack_time")["difference"].get<double>() == doctest::Approx(0.2));
  CHECK(row(json, "collapse_time")["difference"].is_null());
}

TEST_CASE("compare: two runs that differ, by the program") {
  const TempFolder folder;
  std::ofstream(folder.path("case.toml")) << R"(materials.stone = { density = 2000.0, young = 1e9, poisson = 0.2 }
gravity.settle = false
time.duration = 0.01
[base]
[[block]]
name = "a"
material = "stone"
box = [[0,0,0],[0.2,0.2,0.2]]
)";
  const auto run = [&](const std::string& name, const std::string& words) {
    REQUIRE(the_program("run " + folder.path("case.toml") + " --quiet -j 1 -o " + folder.path(name) + " " + words).code == 0);
  };
  run("a", "");
  run("b", "--set 'block[0].velocity=[0.5,0,0]'");
  run("c", "");
  const std::string a = folder.path("a"), b = folder.path("b");
  Outcome o = the_program("compare " + a + " " + b);
  CHECK(o.code == 1);
  CHECK(says(o, {"different: ", "first: ", "measure", "B - A", "peak speed [m/s]"}));
  CHECK(cells(o.text, "run to [s]") == std::vector<std::string>{"0.010", "0.010", "0"});
  const auto peak = Json::parse(the_program("summary " + b + " --format json").text)["peak_speed"].get<double>();
  CHECK(peak > 0.4);  // the push, less friction
  CHECK(std::stod(cells(o.text, "peak speed [m/s]").at(1)) == doctest::Approx(peak).epsilon(0.01));
  o = the_program("compare " + a + " " + folder.path("c"));
  CHECK(o.code == 0);
  CHECK(says(o, {"identical: "}));
  const std::string level = "--set motion.record=bam-like --set motion.intensity.measure=PGA --set motion.intensity.level=";
  run("d", level + "2.0");  // with /motion/factors, which is no row at a time
  run("e", level + "3.0");
  o = the_program("compare " + folder.path("d") + " " + folder.path("d"));
  CHECK(o.code == 0);
  o = the_program("compare " + folder.path("d") + " " + folder.path("e"));
  CHECK(o.code == 1);
  CHECK(says(o, {"/motion/factors"}));
  o = the_program("compare " + a + " " + b + " --format json");
  CHECK(o.code == 1);
  const Json json = Json::parse(o.text);
  CHECK(json["identical"] == false);
  CHECK(json["first"]["dataset"].is_string());
  CHECK(row(json["measures"], "peak_speed")["b"] == peak);
  o = the_program("compare " + a + " " + folder.path("c") + " --format json");
  CHECK(o.code == 0);
  CHECK(Json::parse(o.text)["identical"] == true);
  CHECK(the_program("compare " + a + " " + b + " --format xml").code == 2);
}
