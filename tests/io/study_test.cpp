// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/io/temp_folder.h"

// scripts/study on a study of two runs of a second. Where Snakemake or its Python's packages are absent this says so and passes.
namespace {

const std::string kSource = VOUSSOIR_SOURCE_DIR;
const std::string kCase = "cases = [\"" + kSource + "/tests/faults/data/wall.toml\"]\n";

int code_of(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool can_study() {
  if (code_of("snakemake --version >/dev/null 2>&1 && /usr/bin/python3 -c 'import h5py, matplotlib' 2>/dev/null") == 0) return true;
  MESSAGE("skipped: no Snakemake, or no h5py and matplotlib for /usr/bin/python3; scripts/setup study installs them");
  return false;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The study in the folder's "study"; what it says is in "log".
int study(const TempFolder& folder, const std::string& file, const std::string& words = "--cores 2") {
  return code_of("VOUSSOIR=" VOUSSOIR_PROGRAM " /usr/bin/python3 " + kSource + "/scripts/study/run " + file + " -o " +
                 folder.path("study") + " " + words + " >" + folder.path("log") + " 2>&1");
}

/// Column of the table, a value a run.
std::vector<std::string> column(const std::string& table, const std::string& name) {
  std::istringstream lines(text_of(table));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  std::vector<std::string> values;
  for (std::size_t c = 0; !rows.empty() && c < rows[0].size(); ++c) {
    for (std::size_t r = 1; rows[0][c] == name && r < rows.size(); ++r) values.push_back(rows[r].at(c));
  }
  return values;
}

}  // namespace

TEST_CASE("a faulty study file is refused with its key and its value") {
  if (!can_study()) return;
  const TempFolder folder;
  const std::vector<std::vector<std::string>> faults{
      {"casess = 3\n", "casess = 3"},
      {"directions = [\"LTX\"]\n", "directions[0] = \"LTX\"; allowed: LTV"},
      {"scales = [1.0, \"big\"]\n", "scales[1] = \"big\""},
      {"threads = 0\n", "threads = 0"},
      {"seeds = [1]\n", "scatter.variation"},
      {"set = [\"house.brik=1\"]\n", "house.brik"},
      {"[options]\na = \"b=1\"\n", "options.a = \"b=1\""},
  };
  for (const auto& fault : faults) {
    const std::string file = folder.write("faulty.toml", kCase + fault[0]);
    CHECK(study(folder, file) == 2);
    const std::string said = text_of(folder.path("log"));
    CHECK_MESSAGE(said.find("faulty.toml: ") != std::string::npos, said);
    CHECK_MESSAGE(said.find(fault[1]) != std::string::npos, said);
    CHECK_FALSE(std::filesystem::exists(folder.path("study")));
  }
}

TEST_CASE("a study ends with a table, once; what was interrupted is not begun anew") {
  if (!can_study()) return;
  const TempFolder folder;
  const std::string file = folder.write("two.toml", kCase + "scales = [0.0, 1.0]\nduration = 0.6\n");
  REQUIRE_MESSAGE(study(folder, file) == 0, text_of(folder.path("log")));
  const std::string table = folder.path("study/table.csv"), first = text_of(table);
  using Values = std::vector<std::string>;
  CHECK(column(table, "run") == Values{"wall-x0", "wall-x1"});
  CHECK(column(table, "status") == Values{"done", "done"});
  CHECK(column(table, "starts") == Values{"1", "1"});
  CHECK(column(table, "tension").at(0) == "0");  // nothing shakes it
  CHECK(column(table, "tension").at(1) != "0");
  CHECK(column(table, "state_hash").at(0).size() == 16);
  CHECK(text_of(folder.path("study/index.html")).find("2 of 2 runs done") != std::string::npos);

  std::filesystem::remove(folder.path("study/runs/wall-x1/done.json"));  // as if killed at the end of its run
  REQUIRE(study(folder, file) == 0);
  CHECK(text_of(table) == first);

  folder.write("two.toml", kCase + "scales = [0.0, 1.0]\nduration = 0.7\n");  // other runs under the same names
  CHECK(study(folder, file) == 2);
  CHECK(text_of(folder.path("log")).find("wall-x0: holds a run of the same name") != std::string::npos);
}
