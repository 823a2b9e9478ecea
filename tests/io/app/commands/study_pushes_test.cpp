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

TEST_CASE("pushes: both study files ask for what they say, and nothing is wrong with them") {
  const std::string program = std::string("VOUSSOIR=") + shell::kProgram + " ";
  for (const auto& [file, runs] : {std::pair{"push-24.toml", "24 runs"}, std::pair{"push-30.toml", "8 runs"}}) {
    const std::string path = shell::source(std::string("cases/catalogue/studies/push-combinations/") + file);
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
