// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What a run says that is stopped before its end, and what `check` says of a case that is likely a slip of the pen.

namespace {

using shell::Outcome;
using shell::voussoir;

bool has(const Outcome& o, const std::string& part) {
  const bool found = o.text.find(part) != std::string::npos;
  if (!found) MESSAGE("missing '" << part << "' in: " << o.text);
  return found;
}

constexpr const char* kBlock = R"(title = "block"
gravity.settle = false
joints.default = "dry"
[materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
[base]
[[block]]
name = "a"
material = "stone"
box = [[0, 0, 0], [0.2, 0.2, 0.4]]
)";

std::string written(const TempFolder& folder, const std::string& text) {
  const std::string path = folder.path("case.toml");
  std::ofstream(path) << text;
  return path;
}

}  // namespace

TEST_CASE("a run that is stopped says where, in which stage, and how it goes on") {
  const TempFolder folder;
  const std::string name = written(folder, kBlock);
  const auto stopped = [&](const std::string& out, const std::string& set, const char* signal) {
    return voussoir("run " + name + " --quiet -j 1 -o " + folder.path(out) + set + " & pid=$!; sleep 2; kill -" + signal +
                    " $pid; wait $pid; echo code $?");
  };
  const Outcome shaking = stopped("shaking", " --duration 100000", "TERM");
  CHECK(has(shaking, "code 143"));
  CHECK(has(shaking, " of 100000 s, shaking, by SIGTERM"));
  CHECK(has(shaking, "to go on             voussoir resume " + folder.path("shaking")));
  CHECK(has(voussoir("summary " + folder.path("shaking")), "not finished: at "));
  const Outcome json = voussoir("summary --format json " + folder.path("shaking"));
  CHECK(has(json, "\"stage\": \"shaking\""));
  CHECK(has(json, "\"planned_end\": 100000.0"));
  REQUIRE(voussoir("report " + folder.path("shaking")).code == 0);
  const std::string page = shell::text_of(folder.path("shaking") + "/report.html");
  CHECK(page.find(" of 100000 s, shaking; rows written until ") != std::string::npos);
  CHECK(page.find("\"failure\"") == std::string::npos);
  const Outcome settling = stopped("settling", " --set gravity.settle=true --set gravity.ramp=900", "TERM");
  CHECK(has(settling, "code 143"));
  CHECK(has(settling, "stopped              at -"));
  CHECK(has(settling, " s, settling: the shaking (10 s) has not begun, by SIGTERM"));
  CHECK(settling.text.find("did not come to rest") == std::string::npos);
  const Outcome pushed = stopped("pushed", " --set analysis.kind=pushover --set analysis.pace=1e5 --set analysis.longest=1e5", "TERM");
  CHECK(has(pushed, " s, pushover, of 100000 s at most, by SIGTERM"));
  CHECK(has(pushed, "pushover, not at its end: figures so far"));
}

TEST_CASE("the summary of a run that was lost says so, when and why, and has its figures up to there") {
  const TempFolder folder;
  const std::string name = written(folder, kBlock);
  const Outcome lost = voussoir("run " + name + " --quiet -j 1 --dt 0.01 --set block[0].velocity=[0,0,-5] -o " + folder.path("lost"));
  CHECK(lost.code == 1);
  CHECK(has(lost, "voussoir: numerical failure: "));
  const Outcome summary = voussoir("summary " + folder.path("lost"));
  CAPTURE(summary.text);
  CHECK(has(summary, "run                  lost at 0."));
  CHECK(has(summary, " of 10 s, shaking\n"));
  CHECK(has(summary, " at t = 0."));
  CHECK(has(summary, "figures are those up to there"));
  CHECK(summary.text.find("not finished") == std::string::npos);
  CHECK(has(voussoir("summary --format json " + folder.path("lost")), "\"failure\": \""));
  REQUIRE(voussoir("report " + folder.path("lost")).code == 0);
  const std::string page = shell::text_of(folder.path("lost") + "/report.html");
  CHECK(page.find("\"place\":\"at 0.") != std::string::npos);
  CHECK(page.find(" of 10 s, shaking\",\"failure\":\"") != std::string::npos);
}

TEST_CASE("check counts findings, lists them as JSON, and says that there are no faults only without them") {
  const TempFolder folder;
  const Outcome sound = voussoir("check -j 1 " + written(folder, kBlock));
  CHECK(has(sound, "no faults found"));
  CHECK(has(sound, "by the dashpots at this step, where block \""));
  const Outcome given = voussoir("check -j 1 --set contact.restitution=0.4 " + written(folder, kBlock));
  CHECK(has(given, "restitution              0.4 of free bodies"));
  CHECK(given.text.find("by the dashpots at this step") == std::string::npos);
  const std::string name = written(folder, R"(title = "slips"
gravity.acceleration = [0, 0, 9.8]
gravity.settle = false
joints.default = "l"
[materials.m]
density = 1.8
young = 2000.0
poisson = 0.2
[joint_laws.l]
tension = 0.1
cohesion = 0.1
friction = 0.6
compression = 1e6
[base]
[[block]]
name = "a"
material = "m"
box = [[0, 0, 0], [0.2, 0.2, 0.4]]
[[load]]
block = "a"
force = [1e-3, 0.0, 0.0]
at = [0.1, 0.1, 400.0]
)");
  const Outcome o = voussoir("check -j 1 " + name);
  CHECK(o.code == 0);
  for (const char* part :
       {"density = 1.8 kg/m3 is unusual", "young = 2000 Pa is unusual", "tension = 0.1 Pa is unusual", "does not point down",
        "cohesion = 0.1 Pa is unusual", "friction = 0.6 degrees is unusual", "warnings: 7", "lies 399.6 m", " off block \"a\""})
    CHECK(has(o, part));
  CHECK(o.text.find("no faults found") == std::string::npos);
  const Outcome json = voussoir("check -j 1 --format json " + name);
  CHECK(has(json, "\"findings\": ["));
  CHECK(has(json, "\"faults\": []"));
  CHECK(has(voussoir("view " + name + " -o " + folder.path("page.html")), "warnings: 7"));
}

TEST_CASE("doubts about a file of stones are findings: check does not say that there are no faults") {
  const TempFolder folder;
  std::string stl = "solid a\n";
  for (const char* corners : {"0 0 0 0 1 0 1 0 0", "0 0 0 1 0 0 0 0 1", "1 0 0 0 1 0 0 0 1", "0 1 0 0 0 0 0 0 1"}) {
    stl += "facet normal 0 0 0\nouter loop\n";
    std::istringstream in(corners);
    for (std::string x, y, z; in >> x >> y >> z;) stl += "vertex " + x + " " + y + " " + z + "\n";
    stl += "endloop\nendfacet\n";
  }
  const std::string name = written(folder,
                                   "gravity.settle = false\nmaterials.stone = { density = 2000.0, young = 1e8, poisson = 0.2 }\n[base]\n"
                                   "[[stones]]\nfile = \"a.stl\"\nunit = \"m\"\n");
  folder.write("a.stl", stl + "endsolid a\n");
  CHECK(has(voussoir("check -j 1 " + name), "no faults found"));
  folder.write("a.stl", stl);
  const Outcome check = voussoir("check -j 1 " + name);
  CHECK(check.code == 0);
  CHECK(has(check, "case.toml:5: stones[0].file = \"a.stl\": ends without 'endsolid': it may have been cut"));
  CHECK(has(check, "warnings: 1"));
  CHECK(check.text.find("no faults found") == std::string::npos);
  CHECK(has(voussoir("check -j 1 --format json " + name), "ends without 'endsolid'"));
  const std::string page = folder.path("page.html");
  CHECK(has(voussoir("view " + name + " -o " + page), "warnings: 1"));
  CHECK(shell::text_of(page).find("ends without 'endsolid'") != std::string::npos);
  folder.write("a.stl", stl.substr(0, stl.rfind("facet normal")));  // no longer closed: refused, and why it may be so
  CHECK(has(voussoir("view " + name + " --overwrite -o " + page), "ends without 'endsolid'"));
}

TEST_CASE("check tells of an opening under masonry that nothing carries") {
  const TempFolder folder;
  const auto check = [&](const std::string& opening) {
    return voussoir("check -j 1 " + written(folder, "include = \"flat20n\"\n[house]\nopening = [" + opening + "]\n"));
  };
  const std::string door = "wall = \"front\", from = 1.0, width = 1.2, sill = 0.0, height = ";
  const Outcome bare = check("{ " + door + "2.0 }");
  CHECK(has(bare, "the opening in the front wall, 1.2 m wide, has masonry above it and nothing that carries it"));
  CHECK(has(bare, "warnings: 1"));
  CHECK(has(check("{ " + door + "2.0, lintel = { length = 1.4, height = 0.1, element = 0.2 } }"), "no faults found"));
  CHECK(has(check("{ " + door + "2.4 }"), "no faults found"));  // up to the roof
}
