// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// The way of somebody who begins: help, a case to start from, what is wrong with it.
namespace {

using shell::Outcome;
using shell::text_of;
using shell::voussoir;

bool says(const Outcome& o, const std::string& words) { return o.text.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("new: each kind of case passes its check without a finding, and is never written over a file") {
  for (const std::string kind : {"house", "arch", "stones", "wall"}) {
    CAPTURE(kind);
    const TempFolder folder;
    const std::string file = folder.path("mine.toml");
    REQUIRE(voussoir("new " + kind + " " + shell::quoted(file)).code == 0);
    const Outcome check = voussoir("check " + shell::quoted(file) + " -j 1");
    CAPTURE(check.text);
    CHECK(check.code == 0);
    CHECK(says(check, "no faults found"));
    CHECK_FALSE(says(check, "warning"));
    folder.write("mine.toml", "mine");
    const Outcome again = voussoir("new " + kind + " " + shell::quoted(file));
    CHECK(again.code == 3);
    CHECK(says(again, "is there already"));
    CHECK(text_of(file) == "mine");
    std::filesystem::remove(file);
    std::filesystem::create_symlink(folder.path("elsewhere.toml"), file);
    CHECK(voussoir("new " + kind + " " + shell::quoted(file)).code == 3);
    CHECK_FALSE(std::filesystem::exists(folder.path("elsewhere.toml")));
  }
  CHECK(voussoir("new hose").code == 2);
}

TEST_CASE("check tells how large the checkpoints of a run will be") {
  const TempFolder folder;
  const std::string file = folder.path("mine.toml"), out = folder.path("out");
  REQUIRE(voussoir("new wall " + shell::quoted(file)).code == 0);
  const Outcome check = voussoir("check " + shell::quoted(file) + " -j 1");
  const std::size_t at = check.text.find(" MB of checkpoints");
  REQUIRE(at != std::string::npos);
  const double told = std::stod(check.text.substr(check.text.rfind(' ', at - 1)));
  REQUIRE(voussoir("run " + shell::quoted(file) + " --quiet -j 1 --duration 0.01 --set gravity.settle=false -o " + out).code == 0);
  double bytes = 0.0;
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    if (entry.path().filename().string().starts_with("checkpoint-")) bytes += static_cast<double>(entry.file_size());
  }
  CHECK(std::abs(told - 1e-6 * bytes) < 0.5 + 0.15 * 1e-6 * bytes);
}

TEST_CASE("help lists the commands in the order of work, and names where to begin") {
  const Outcome help = voussoir("--help");
  std::size_t at = 0;
  for (const char* command :
       {"new", "cases", "keys", "view", "check", "modes", "limit", "run", "resume", "summary", "assess", "report", "compare", "study"}) {
    CAPTURE(command);
    const std::size_t next = help.text.find("\n  " + std::string(command) + " ", at);
    REQUIRE(next != std::string::npos);
    at = next;
  }
  CHECK(says(help, "cases/tutorial"));
  CHECK(says(help, "voussoir new house"));
}

TEST_CASE("a mistyped option is suggested") {
  const Outcome o = voussoir("run flat20n --directon LTV");
  CHECK(o.code == 2);
  CHECK(says(o, "--directon: did you mean --direction?"));
}

TEST_CASE("all faults of a case are told, each on a line of its own") {
  const TempFolder folder;
  REQUIRE(voussoir("new house " + shell::quoted(folder.path("a.toml"))).code == 0);
  const Outcome o = voussoir(
      "check " + shell::quoted(folder.path("a.toml")) +
      " --set house.bearing_wall=0.1 --set house.opening[1].wall=frnt --set house.opening[0].sill=0.05 --set joints.default=morta");
  CHECK(o.code == 2);
  CAPTURE(o.text);
  CHECK(std::count(o.text.begin(), o.text.end(), '\n') == 4);
  for (const char* words : {"house.bearing_wall = 0.1 m is less than two thirds of a brick's width", "did you mean \"front\"?",
                            "did you mean \"mortar\"?", "house.opening[0].sill"}) {
    CAPTURE(words);
    CHECK(says(o, words));
  }
}
