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

/// A box of this height on the ground, its faces outward.
std::string obj_box(const std::string& height) {
  std::string text = "o stone\n";
  for (const std::string& z : {std::string("0"), height})
    text += "v 0 0 " + z + "\nv 0.2 0 " + z + "\nv 0.2 0.2 " + z + "\nv 0 0.2 " + z + "\n";
  return text + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

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

TEST_CASE("the page tells the peaks of what was shaken where the run ends before its record") {
  const TempFolder folder;
  const std::string house = folder.write("case.toml", std::string(kHead) + kBlock), out = folder.path("out"), page = out + "/report.html";
  const std::string whole = folder.write("whole.csv", constant("1.5")),
                    longer = folder.write("long.csv", constant("1.5") + "0.06, 9\n0.08, 9\n");
  for (const std::string& record : {whole, longer}) {
    REQUIRE(voussoir_says("run " + house + " --quiet -j 1 --overwrite --motion x=" + record + " -o " + out).code == 0);
    REQUIRE(voussoir_says("report " + out + " --overwrite").code == 0);
    const std::string text = shell::text_of(page);
    CHECK(has(text, R"("peak":[1.5,)"));
    CHECK((text.find(R"("until":0.04)") != std::string::npos) == (record == longer));
  }
}

TEST_CASE("the page of a run of stones has mode shapes, unless their file now holds others") {
  const TempFolder folder;
  const std::string stones = "[[stones]]\nfile = \"stone.obj\"\nunit = \"m\"\nmaterial = \"stone\"\n";
  const std::string house = folder.write("case.toml", kHead + stones), out = folder.path("out");
  folder.write("stone.obj", obj_box("0.2"));
  Outcome o = voussoir_says("run " + house + " --quiet -j 1 -o " + out);
  REQUIRE_MESSAGE(o.code == 0, o.text);
  o = voussoir_says("report " + out + " --modes 2");
  CHECK_MESSAGE(o.code == 0, o.text);
  folder.write("stone.obj", obj_box("0.2") + "o second\n" + "v 0.5 0 0\nv 0.7 0 0\nv 0.7 0.2 0\nv 0.5 0.2 0\nv 0.5 0 0.2\nv 0.7 0 0.2\n" +
                                "v 0.7 0.2 0.2\nv 0.5 0.2 0.2\nf 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\n" +
                                "f 12 9 13 16\n");
  o = voussoir_says("report " + out + " --modes 2 --overwrite");
  CHECK(o.code == 3);
  CHECK_MESSAGE(has(o.text, "has 1 elements, its case now 2"), o.text);
}
