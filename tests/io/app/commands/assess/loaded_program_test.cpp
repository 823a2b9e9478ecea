// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// Where a result is printed, the control point stands by name and place, and each load with the displacement of its place.
namespace {

using Json = nlohmann::json;

/// A dry block of 0.4 × 0.3 × 1.0 m and 240 kg, far from the origin, that a force at its top pushes over.
const char* const kPushed = R"(title = "a block that is pushed"
[materials.stone]
density = 2000.0
young = 1e9
poisson = 0.2
[segments]
rule = "rim"
[contact]
friction = 60.0
[base]
[[block]]
name = "slab"
material = "stone"
part = "front wall"
box = [[3000.0, 0.0, 0.0], [3000.4, 0.3, 1.0]]
[[load]]
at = [2999.0, 0.15, 0.9]
force = [100.0, 0.0, 0.0]
grows = true
[analysis]
kind = "pushover"
pattern = "given"
largest_drift = 0.02
)";

struct Words {
  TempFolder folder;
  Words() { folder.write("pushed.toml", kPushed); }
  [[nodiscard]] shell::Outcome run(const std::string& words) const {
    return shell::run("cd " + shell::quoted(folder.path()) + " && " + shell::kProgram + " " + words);
  }
};

void check_says(const shell::Outcome& o, const std::string& part) {
  CAPTURE(o.text);
  CHECK_MESSAGE(o.text.find(part) != std::string::npos, part);
}

}  // namespace

TEST_CASE("a pushover tells its control point and its loads at the end of the run, in summary, in assess and in JSON") {
  const Words words;
  const shell::Outcome run = words.run("run pushed.toml --quiet -o out 2>&1");
  REQUIRE_MESSAGE(run.code == 0, run.text);
  const std::string control = "control point        front wall (element 0), at (3000.200, 0.150, 0.500) m\n";
  const std::string load = "  load 1: on front wall, at (3000.00, 0.15, 0.90) m\n";
  for (const shell::Outcome& o : {run, words.run("summary out"), words.run("assess out")}) check_says(o, control), check_says(o, load);
  const Json summary = Json::parse(words.run("summary out --format json").text);
  const Json &point = summary["capacity"]["control"], &push = summary["loads"][0];
  CHECK(point["element"] == 0);
  CHECK(point["part"] == "front wall");
  CHECK(point["position"][0].get<double>() == doctest::Approx(3000.2));
  // The load at its peak: it tips the block about its foot, F 0.9 m = W 0.2 m.
  CHECK(push["peak_force"].get<double>() == doctest::Approx(240.0 * 9.81 * 0.2 / 0.9).epsilon(0.05));
  CHECK(push["peak_force"].get<double>() == doctest::Approx(100.0 * summary["capacity"]["multiplier"].get<double>()).epsilon(1e-6));
  // At the end the block leans by 2 % at its centre: the loaded place is at 0.9 / 0.5 of that height.
  CHECK(push["end_displacement"].get<double>() == doctest::Approx(0.02 * 0.9).epsilon(0.1));
  check_says(words.run("report out --overwrite && cat out/report.html"), "control");
}

TEST_CASE("the control point is chosen by name, and a name that there is not is refused with the names that there are") {
  const Words words;
  CHECK(words.run("run pushed.toml --quiet -o out --set 'analysis.control=\"slab\"' 2>&1").code == 0);
  const shell::Outcome wrong = words.run("check pushed.toml --set 'analysis.control=\"frnt wall\"' 2>&1");
  CHECK(wrong.code == 2);
  check_says(wrong, "analysis.control = \"frnt wall\" is the name of no part; did you mean \"front wall\"? known: front wall");
}
