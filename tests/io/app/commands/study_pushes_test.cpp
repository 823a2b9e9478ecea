// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "tests/io/app/commands/study_table.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// The studies of pushes that codes ask for: their files are sound, and their table names the worst run of each figure.
namespace {

using study::script;

study::Table::Values push(const std::string& name, const std::string& shear, const std::string& demand, const std::string& open = "") {
  return {{"options", name},
          {"capacity: multiplier", "0.5"},
          {"capacity: peak_shear", shear},
          {"capacity: near_collapse", "0.004"},
          {"capacity: n2_ec8_demand_over_capacity", demand},
          {"capacity: n2_ec8_not_proven", open}};
}

}  // namespace

TEST_CASE("pushes: the study files ask for what they say, and nothing is wrong with them") {
  const std::string program = std::string("VOUSSOIR=") + shell::kProgram + " ";
  for (const auto& [file, runs] :
       {std::pair{"push-combinations/push-24.toml", "24 runs"}, std::pair{"push-combinations/push-30.toml", "8 runs"},
        std::pair{"static-beside-dynamic/ida-x.toml", "12 runs"}}) {
    const std::string path = shell::source(std::string("cases/catalogue/studies/") + file);
    const shell::Outcome o = shell::run(program + script("run") + path + " --check 2>&1");
    CHECK_MESSAGE(o.code == 0, o.text);
    CHECK_MESSAGE(o.text.find(std::string(runs) + ", threads each: 1; no faults found") != std::string::npos, o.text);
  }
}

TEST_CASE("pushes: the table has a row a push, and the worst of each figure with its push") {
  const TempFolder folder;
  study::Table t;
  t.add("hut", "", push("mass_px_e0", "2e4", "0.4"));
  t.add("hut", "", push("mass_mx_e0", "1e4", "", "the curve ends"));
  t.add("hut", "", push("mass_py_e0", "3e4", "0.8"));
  const std::string file = folder.write("table.csv", t.text());
  const shell::Outcome o = shell::run(script("pushes.py") + file);
  CHECK(o.code == 0);
  CHECK(o.text.find("| mass_px_e0 | 0.5000 | 20.0 | – | 4.00 | – | – | 0.40 | – | – | yes |") != std::string::npos);
  CHECK(o.text.find("| mass_mx_e0 | 0.5000 | 10.0 | – | 4.00 | – | – | – | – | – | no |") != std::string::npos);
  CHECK(o.text.find("10.0 (mass_mx_e0)") != std::string::npos);
  CHECK(o.text.find("0.80 (mass_py_e0); 1 not known") != std::string::npos);
  const shell::Outcome none = shell::run(script("pushes.py") + folder.write("other.csv", "run,status,options\nr0,done,a\n") + " 2>&1");
  CHECK(none.code == 1);
  CHECK(none.text.find("holds no pushover that is done") != std::string::npos);
}

TEST_CASE("static beside dynamic: each run has the targets of both pushovers under its own motion, and a verdict") {
  if (shell::code_of("/usr/bin/python3 -c 'import h5py' 2>/dev/null") != 0) {
    MESSAGE("skipped: no python3 with h5py");
    return;
  }
  const TempFolder folder;
  folder.write("block.toml", R"(title = "a block"
[materials.stone]
density = 2000.0
young = 1e9
poisson = 0.2
[segments]
rule = "rim"
[contact]
friction = 60.0
[time]
duration = 0.3
[base]
[[output.history]]
name = "control"
point = [0.2, 0.15, 0.5]
[[block]]
name = "block"
material = "stone"
box = [[0.0, 0.0, 0.0], [0.4, 0.3, 1.0]]
)");
  folder.write("x.csv", "t [s],a [m/s2]\n0,0\n0.1,1\n0.2,-1\n0.3,0\n");
  const std::string in = "cd " + shell::quoted(folder.path()) + " && ", run = in + shell::kProgram + " run block.toml --quiet -j 1 -o ";
  REQUIRE(shell::code_of(run + "study/runs/r0 --motion x=x.csv 2>/dev/null") == 0);
  REQUIRE(shell::code_of(run + "push --set analysis.kind=pushover 2>/dev/null") == 0);
  REQUIRE(shell::code_of(run + "back --set analysis.kind=pushover --set 'analysis.direction=[-1,0]' 2>/dev/null") == 0);
  folder.write("study/table.csv", "run,record,level,status,peak_base_shear,collapsed\nr0,x,1.0,done,100,0\nr1,x,2.0,to be done,,\n");
  const std::string words = script("static_beside.py") + "study --push push --back back --corner-period 0.5 -o beside.csv";
  const shell::Outcome o = shell::run(in + "VOUSSOIR=" + shell::kProgram + " " + words + " 2>&1");
  REQUIRE_MESSAGE(o.code == 0, o.text);
  const std::string table = shell::text_of(folder.path("beside.csv"));
  CHECK(table.find("\nr0,x,1.0,") != std::string::npos);
  CHECK(table.find("\nr1,") == std::string::npos);
  CHECK(table.find("both bear it") != std::string::npos);
  const shell::Outcome shown = shell::run(in + script("static_beside.py") + "--show beside.csv");
  CHECK_MESSAGE(shown.text.find("| x | 1 |") != std::string::npos, shown.text);
  CHECK(shell::code_of(in + script("static_beside.py") + "study 2>/dev/null") == 1);
}
