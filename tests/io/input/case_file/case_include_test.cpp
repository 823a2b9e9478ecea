// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>

#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"
#include "tests/io/temp_folder.h"

using namespace voussoir;
namespace fs = std::filesystem;

namespace {

std::string refusal(const std::string& path) {
  try {
    io::load_case(path);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "nothing was refused";
}

/// A case that names a file of each kind, for reading alone.
constexpr const char* kAllPaths = R"([motion]
V = "v.csv"
[[stones]]
file = "sub.obj"
unit = "m"
material = "adobe"
[[stones]]
file = "more.obj"
unit = "m"
material = "adobe"
[[block]]
name = "a"
material = "adobe"
box = [[0, 0, 0], [1, 1, 1]]
fixed = true
motion = { file = "m.csv" }
[[load]]
block = "a"
history = "push.csv"
[[base.part]]
wall = "rear"
level = 0.2
motion = { file = "sinks.csv" }
)";

}  // namespace

TEST_CASE("a source of motion takes the place of the included one; two in one file are refused") {
  const TempFolder folder;
  folder.write("house.toml", "[motion]\nrecord = \"bam-like\"\ndirection = \"TLV\"\nscale = 0.5\nunit = \"g\"\n");
  const cases::Motion axes =
      *io::load_case(folder.write("axes.toml", "include = \"house.toml\"\n[motion]\nx = \"a.csv\"\ny = \"b.csv\"\n")).value.motion;
  CHECK_FALSE(axes.record);
  CHECK(axes.xyz[1] == "b.csv");
  CHECK(axes.direction == "LTV");
  CHECK_FALSE(axes.unit);  // of the files that have given way
  CHECK(axes.scale[0] == 0.5);
  const cases::Motion parts = *io::load_case(folder.write("parts.toml", "include = \"axes.toml\"\n[motion]\nT = \"t.csv\"\n")).value.motion;
  CHECK_FALSE(parts.xyz[0]);
  CHECK_FALSE(parts.record);
  CHECK(io::load_case(folder.write("back.toml", "include = \"parts.toml\"\n[motion]\nrecord = \"r\"\n")).value.motion->record == "r");
  const std::string both = folder.write("both.toml", "include = \"house.toml\"\n[motion]\nx = \"a\"\nT = \"b\"\n");
  CHECK(refusal(both).find("motion.T = \"b\" does not go with motion.x") != std::string::npos);
}

TEST_CASE("an included name without .toml is that of a ready case, else of a file beside the including one") {
  const TempFolder folder;
  folder.write("parts/common", "title = \"beside\"\n");
  CHECK(io::load_case(folder.write("parts/case.toml", "include = \"common\"\n")).value.title == "beside");
}

TEST_CASE("a case lies over what it includes, key by key; arrays are replaced") {
  const TempFolder folder;
  folder.write(
      "parts/base.toml",
      "title = \"base\"\n[house]\nheight = 1.2\nroof = { kind = \"flat\", element = 0.3 }\n[[output.history]]\nname = \"a\"\npoint = "
      "[0,0,0]\n[[output.history]]\nname = \"b\"\npoint = [1,0,0]\n");
  folder.write("parts/tall.toml", "include = \"base.toml\"\n[house]\nheight = 3.6\nmaterial = \"brick\"\n");
  const std::string path = folder.write("house.toml",
                                        "title = \"mine\"\ninclude = [\"parts/base.toml\", \"parts/tall.toml\"]\n[house]\nmaterial = "
                                        "\"stone\"\nroof = { element = 0.4 }\n[[output.history]]\nname = \"c\"\npoint = [2,0,0]\n");
  const cases::Case c = io::load_case(path, {"house.joint=lime"}).value;
  CHECK(c.title == "mine");
  CHECK(c.house->height == 3.6);
  CHECK(c.house->material == "stone");
  CHECK(c.house->joint == "lime");
  CHECK(c.house->roof.kind == cases::RoofKind::flat);
  CHECK(c.house->roof.element == 0.4);
  REQUIRE(c.output.history.size() == 1);
  CHECK(c.output.history[0].name == "c");
  CHECK(c.folder == folder.path());
}

TEST_CASE("an empty array takes away what was included: tables, arrays of tables, single values") {
  const TempFolder folder;
  const auto read = [&](const std::string& text) {
    return io::load_case(folder.write("mine.toml", "include = \"flat20r\"\n" + text)).value;
  };
  const cases::Case as_it_is = read("");
  REQUIRE(as_it_is.house->reinforcement);
  REQUIRE(as_it_is.house->openings.size() == 2);
  const cases::Case c = read(
      "gravity = []\n[damping]\nratio = []\nfrequency = []\n[output]\nhistory = []\n[house]\nopening = []\nreinforcement = []\nheight = "
      "[]\n");
  CHECK_FALSE(c.house->reinforcement);
  CHECK(c.house->openings.empty());
  CHECK(c.output.history.empty());
  CHECK(c.damping.ratio == 0.0);
  CHECK_FALSE(c.damping.frequency);
  CHECK(c.house->height == cases::House{}.height);
  CHECK(refusal(folder.write("no.toml", "include = \"flat20r\"\n[materials.adobe]\nyoung = []\n")).find("materials.adobe.young") !=
        std::string::npos);
}

TEST_CASE("files that an included case names lie beside it") {
  const TempFolder folder;
  folder.write("parts/house.toml",
               "[motion]\nx = \"x.csv\"\ny = \"/data/y.csv\"\n[[block]]\nname = \"a\"\nmaterial = \"adobe\"\nbox = "
               "[[0,0,0],[1,1,1]]\nfixed = true\nmotion = { file = \"../m.csv\" }\n");
  const cases::Case c = io::load_case(folder.write("mine/case.toml", "include = \"../parts/house.toml\"\n[motion]\nz = \"z.csv\"\n")).value;
  CHECK(c.motion->xyz[0] == folder.path("parts/x.csv"));
  CHECK(c.motion->xyz[1] == "/data/y.csv");
  CHECK(c.motion->xyz[2] == "z.csv");
  CHECK(c.blocks.at(0).motion->file == folder.path("m.csv"));
  folder.write("parts/record.toml", "[motion]\nrecord = \"bam-like\"\n");
  CHECK(io::load_case(folder.write("mine/other.toml", "include = \"../parts/record.toml\"\n")).value.motion->record == "bam-like");
}

TEST_CASE("every kind of file that an included case names lies beside it") {
  const TempFolder folder;
  folder.write("parts/part.toml", kAllPaths);
  const cases::Case c = io::load_case(folder.write("mine/case.toml", "include = \"../parts/part.toml\"\n")).value;
  CHECK(c.stones.at(0).file == folder.path("parts/sub.obj"));
  CHECK(c.stones.at(1).file == folder.path("parts/more.obj"));
  CHECK(c.loads.at(0).history == folder.path("parts/push.csv"));
  CHECK(c.base->parts.at(0).motion->file == folder.path("parts/sinks.csv"));
  CHECK(c.blocks.at(0).motion->file == folder.path("parts/m.csv"));
  CHECK(c.motion->ltv[2] == folder.path("parts/v.csv"));
}

TEST_CASE("a case with absolute paths, or with the names of files alone, has all of them so") {
  const TempFolder folder;
  const std::string path = folder.write("case.toml", kAllPaths);
  const std::string whole = io::resolved_toml(io::anchored(io::load_case(path).value));
  const std::string bare = io::resolved_toml(io::without_folders(io::anchored(io::load_case(path).value)));
  const std::string place = fs::canonical(folder.path()).string() + "/";
  for (const std::string name : {"sub.obj", "more.obj", "push.csv", "sinks.csv", "m.csv", "v.csv"}) {
    CAPTURE(name);
    CHECK(whole.find('"' + place + name + '"') != std::string::npos);
    CHECK(bare.find('"' + name + '"') != std::string::npos);
  }
}

TEST_CASE("a case may include one of the catalogue") {
  const TempFolder folder;
  const std::string path = folder.write("mine.toml", "include = \"flat20r\"\n[house]\nbearing_wall = 0.3\n");
  const cases::Case c = io::load_case(path).value;
  CHECK(c.house->bearing_wall == 0.3);
  CHECK(c.house->openings.size() == 2);
  CHECK(c.house->reinforcement->bearing.size() == 6);
}

TEST_CASE("a fault is reported where it was written") {
  const TempFolder folder;
  const std::string part = folder.write("part.toml", "\n[time]\nduration = -1\n");
  CHECK(refusal(folder.write("a.toml", "include = \"part.toml\"\n")).starts_with(part + ":3: time.duration = -1 s"));
  const std::string broken = folder.write("broken.toml", "[time\n");
  CHECK(refusal(folder.write("b.toml", "include = \"broken.toml\"\n")).starts_with(broken + ":1:"));
  folder.write("d.toml", "[house]\nmaterial = \"x\"\n");
  const io::LoadedCase c = io::load_case(folder.write("c.toml", "include = \"d.toml\"\n[house]\nheight = 2\n"));
  CHECK(c.describe({"house.material", "is unknown"}).starts_with(folder.path("d.toml") + ":2: house.material"));
}

TEST_CASE("includes that cannot be followed name the place") {
  const TempFolder folder;
  folder.write("x.toml", "include = \"y.toml\"\n");
  folder.write("y.toml", "include = \"x.toml\"\n");
  CHECK(refusal(folder.path("x.toml")).find("leads back to itself") != std::string::npos);
  CHECK(refusal(folder.write("a.toml", "\ninclude = \"none.toml\"\n")).find("a.toml:2: include") != std::string::npos);
  CHECK(refusal(folder.write("b.toml", "include = \"flat99\"\n")).find("neither in the catalogue") != std::string::npos);
  CHECK(refusal(folder.write("c.toml", "include = 3\n")).find("wanted the name of a case") != std::string::npos);
  CHECK(refusal(folder.write("d.toml", "include = [\"\"]\n")).find("wanted the name of a case") != std::string::npos);
}
