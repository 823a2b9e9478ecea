// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// The page of a run whose input files are no longer what they were.

namespace {

using shell::Outcome;

/// The program; both of its streams. (`voussoir` is a namespace here.)
Outcome voussoir_says(const std::string& words) { return shell::voussoir(words); }
bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

constexpr const char* kHead = R"(materials.stone = { density = 2000.0, young = 1e8, poisson = 0.2 }
gravity.settle = false
time.duration = 0.04
[base]
)";
constexpr const char* kBlock = R"([[block]]
name = "a"
material = "stone"
box = [[0,0,0],[0.2,0.2,0.2]]
)";

std::string constant(const std::string& value) { return "t [s], a [m/s2]\n0, " + value + "\n0.02, " + value + "\n0.04, " + value + "\n"; }

}  // namespace

TEST_CASE("the page of a run shows the motion that shook it though its record's file has changed since, or is gone") {
  const TempFolder folder;
  const std::string house = folder.write("case.toml", std::string(kHead) + kBlock), out = folder.path("out"), page = out + "/report.html";
  const std::string record = folder.write("l.csv", constant("1.5"));
  REQUIRE(voussoir_says("run " + house + " --quiet -j 1 --motion L=" + record + " -o " + out).code == 0);
  Outcome o = voussoir_says("report " + out);
  REQUIRE(o.code == 0);
  CHECK_FALSE(has(o.text, "warning"));
  CHECK(has(shell::text_of(page), R"("peak":[1.5,)"));
  folder.write("l.csv", constant("2.5"));
  o = voussoir_says("report " + out + " --overwrite");
  CHECK(o.code == 0);
  CHECK(has(o.text, "have changed since the run"));
  CHECK(has(shell::text_of(page), R"("peak":[1.5,)"));
  std::filesystem::remove(record);
  o = voussoir_says("report " + out + " --overwrite");
  CHECK(o.code == 0);
  CHECK(has(o.text, "l.csv: no such file; the page shows the motion that the run holds"));
  CHECK(has(shell::text_of(page), R"("peak":[1.5,)"));
}
