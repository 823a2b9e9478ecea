// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "io/input/case_file/case_file.h"
#include "io/input/case_file/catalogue.h"
#include "io/input/files/errors.h"

using namespace voussoir;
using io::read_case;

namespace {

const std::string kTwoBlocks =
    "[[block]]\nname = \"a\"\nmaterial = \"m\"\nbox = [[0,0,0],[1,1,1]]\n[[block]]\nname = \"b\"\nmaterial = \"m\"\nbox = "
    "[[1,0,0],[2,1,1]]\n";

cases::Case with(const std::string& text, const std::vector<std::string>& overrides) {
  return read_case({"test.toml", text}, overrides).value;
}

std::string refusal(const std::string& text, const std::vector<std::string>& overrides) {
  try {
    with(text, overrides);
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

/// A folder of cases that VOUSSOIR_CATALOGUE names as long as this lives.
struct UserCatalogue {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / "voussoir_catalogue_test";
  UserCatalogue() {
    std::filesystem::create_directories(folder);
    setenv("VOUSSOIR_CATALOGUE", folder.c_str(), 1);
  }
  ~UserCatalogue() {
    unsetenv("VOUSSOIR_CATALOGUE");
    std::filesystem::remove_all(folder);
  }
  UserCatalogue(const UserCatalogue&) = delete;
  UserCatalogue& operator=(const UserCatalogue&) = delete;
  void add(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
};

}  // namespace

TEST_CASE("overrides: values of all kinds") {
  const cases::Case c = with("[time]\nduration = 3\n", {"time.duration=7", "time.step=auto", "house.bond=running", "gravity.settle=false",
                                                        "gravity.acceleration=[0, 0, -1.5]", "title=Two words, plain", "source=\"5\"",
                                                        "house.roof={kind = \"flat\", element = 0.1}", "damping.alpha = 1.5e0"});
  CHECK(c.time.duration == 7.0);
  CHECK(c.house->bond == cases::Bond::running);
  CHECK(!c.gravity.settle);
  CHECK(c.gravity.acceleration == Vec3{0.0, 0.0, -1.5});
  CHECK(c.title == "Two words, plain");
  CHECK(c.source == "5");
  CHECK(c.house->roof.kind == cases::RoofKind::flat);
  CHECK(c.house->roof.element == 0.1);
  CHECK(c.damping.alpha == 1.5);
}

TEST_CASE("overrides: the last one of a key holds") { CHECK(with("", {"time.duration=7", "time.duration=8"}).time.duration == 8.0); }

TEST_CASE("overrides: a later assignment replaces a whole table") {
  const cases::Case c = with("[house]\nheight = 3\nturn = 90\n", {"house={height = 2.0}"});
  CHECK(c.house->height == 2.0);
  CHECK(c.house->turn == 0.0);
}

TEST_CASE("overrides: arrays by bracket and by dot") {
  CHECK(with(kTwoBlocks, {"block[1].fixed=true"}).blocks[1].fixed);
  CHECK(with(kTwoBlocks, {"block.1.fixed=true"}).blocks[1].fixed);
  CHECK(!with(kTwoBlocks, {"block.1.fixed=true"}).blocks[0].fixed);
  CHECK((*with(kTwoBlocks, {"block[0].box[1][2]=4"}).blocks[0].box)[1].z == 4.0);
  const std::string openings =
      "[[house.opening]]\nwall=\"front\"\nfrom=1\nwidth=1\nheight=1\n[[house.opening]]\nwall=\"rear\"\nfrom=1\nwidth=1\nheight=1\n";
  CHECK(with(openings, {"house.opening[1].width=0.75"}).house->openings[1].width == 0.75);
  CHECK(with(openings, {"house.opening[1].width=0.75"}).house->openings[0].width == 1.0);
}

TEST_CASE("overrides: missing tables and the next element are made") {
  CHECK(with("", {"house.roof.kind=vault"}).house->roof.kind == cases::RoofKind::vault);
  CHECK(with("", {"output.history[0].name=e", "output.history[0].point=[1,2,3]"}).output.history.at(0).point == Vec3{1.0, 2.0, 3.0});
  const cases::Case c = with(kTwoBlocks, {"block[2]={name = \"c\", material = \"m\", box = [[2,0,0],[3,1,1]]}"});
  REQUIRE(c.blocks.size() == 3);
  CHECK(c.blocks[2].name == "c");
  CHECK(with("", {"materials.\"a b\".density=1", "materials.\"a b\".young=1", "materials.'a b'.poisson=0"}).materials.at("a b").density ==
        1.0);
}

TEST_CASE("overrides: an empty value takes a key away") {
  const std::string text = "[motion]\nrecord = \"bam-like\"\n[damping]\nratio = 0.02\nfrequency = 6\n[base]\n" + kTwoBlocks;
  CHECK(!with(text, {"motion="}).motion);
  CHECK(!with(text, {"base="}).base);
  CHECK(with(text, {"motion.record=", "motion.x=f.csv"}).motion->xyz[0] == "f.csv");
  CHECK(with(text, {"damping.ratio=", "damping.frequency=", "damping.alpha=2"}).damping.alpha == 2.0);
  CHECK(with(text, {"block[0]="}).blocks.size() == 1);
  CHECK(with(text, {"block[0]="}).blocks[0].name == "b");
  CHECK(with(text, {"motion=", "motion.record=other"}).motion->record == "other");
  CHECK(!with("", {"motion.record="}).motion);
  CHECK(refusal(text, {"motion.recrod="}).find("--set motion.recrod=: motion.recrod: unknown key; did you mean \"record\"?") !=
        std::string::npos);
  CHECK(refusal(text, {"materials.m=", "tiem.step="}).starts_with("--set tiem.step=: tiem: unknown key"));
  CHECK(refusal("[materials.m]\ndensity=1\nyoung=1\npoisson=0\n", {"materials.m.young="}).find("materials.m.young is missing") !=
        std::string::npos);
}

TEST_CASE("overrides: faults name the override") {
  CHECK(refusal("", {"house.height=-1"}) == "--set house.height=-1: house.height = -1 m: must be > 0");
  CHECK(refusal("", {"house.height=abc"})
            .starts_with("--set house.height=abc: house.height = \"abc\": found a string in quotes, wanted a number"));
  CHECK(refusal("", {"house.hight=2"}).starts_with("--set house.hight=2: house.hight: unknown key; did you mean \"height\"?"));
  CHECK(refusal("", {"title=caf\xe9"}) == "--set title=caf\xe9: is not in UTF-8");
  CHECK(with("", {"title=caf\xc3\xa9"}).title == "caf\xc3\xa9");
  CHECK(refusal("", {"house.height"}) == "--set house.height: no '='; wanted key=value");
  CHECK(refusal("", {"=3"}) == "--set =3: an empty name in the key");
  CHECK(refusal("", {""}) == "--set : wanted key=value");
  CHECK(refusal("", {"a..b=3"}) == "--set a..b=3: an empty name in the key");
  CHECK(refusal("", {"block[x].fixed=true"}) == "--set block[x].fixed=true: [x] is no index; write key[0]");
  CHECK(refusal("", {"block[0.fixed=true"}).find("no closing ]") != std::string::npos);
  CHECK(refusal("", {"[0].fixed=true"}) != "accepted");
  CHECK(refusal(kTwoBlocks, {"block[3].fixed=true"}).find("[3] is past the end: the array has 2 values") != std::string::npos);
  CHECK(refusal(kTwoBlocks, {"block[99999999999999999999].fixed=true"}).find("is no index") != std::string::npos);
  CHECK(refusal(kTwoBlocks, {"block.fixed=true"}).find("\"block\" is an array; write block[0].fixed") != std::string::npos);
  CHECK(refusal("title = \"a\"", {"title.a=1"}).find("\"title\" is no table") != std::string::npos);
  CHECK(refusal("[time]\n", {"time[0]=1"}).find("\"time\" is no array") != std::string::npos);
  CHECK(refusal("", {"time.duration=1\ntitle = \"x\""}).find("found a string") != std::string::npos);
  CHECK(refusal("", {"time.duration=nan"}) == "--set time.duration=nan: time.duration = nan s: must be finite");
  std::string deep = "a";
  for (int i = 0; i < 100000; ++i) deep += ".a";
  CHECK(refusal("", {deep + "=1"}).find("the key is too deep") != std::string::npos);
}

TEST_CASE("catalogue: every ready case reads, and its text survives being built in") {
  for (const io::CatalogueEntry& entry : io::catalogue()) {
    CAPTURE(entry.name);
    CHECK(!entry.title.empty());
    const io::LoadedCase loaded = io::load_case(entry.name);
    CHECK(loaded.value.title == entry.title);
    std::ifstream in(VOUSSOIR_SOURCE_DIR "/cases/catalogue/" + entry.name + ".toml", std::ios::binary);
    CHECK(entry.text == std::string(std::istreambuf_iterator<char>(in), {}));
    const std::string resolved = io::resolved_toml(loaded.value);
    CHECK(io::resolved_toml(read_case({"resolved.toml", resolved}).value) == resolved);
  }
}

TEST_CASE("catalogue: each file of the folder is listed in io/CMakeLists.txt") {
  std::set<std::string> names;
  for (const io::CatalogueEntry& entry : io::catalogue()) names.insert(entry.name);
  for (const auto& file : std::filesystem::directory_iterator(VOUSSOIR_SOURCE_DIR "/cases/catalogue")) {
    if (file.path().extension() != ".toml") continue;
    CAPTURE(file.path().string());
    CHECK(names.contains(file.path().stem().string()));
  }
}

TEST_CASE("catalogue: a folder of the user comes on top") {
  const std::size_t built_in = io::catalogue().size();
  const UserCatalogue user;
  user.add("mine.toml", "title = \"My case\"\n[time]\nduration = 2\n");
  user.add("broken.toml", "title = = 3\n");
  user.add("notes.txt", "not a case");
  const std::vector<io::CatalogueEntry> entries = io::catalogue();
  REQUIRE(entries.size() == built_in + 2);
  const io::LoadedCase mine = io::load_case("mine", {"time.duration=5"});
  CHECK(mine.value.title == "My case");
  CHECK(mine.value.time.duration == 5.0);
  CHECK(mine.value.folder == user.folder.string());
  CHECK(mine.describe({"title", "is odd"}) == (user.folder / "mine.toml").string() + ":1: title = \"My case\" is odd");
  for (const io::CatalogueEntry& entry : entries) {
    if (entry.name == "broken") CHECK(entry.title.starts_with("cannot be parsed: line 1"));
  }
  CHECK_THROWS_AS(io::load_case("broken"), io::CaseFileError);
}

TEST_CASE("catalogue: an unknown name lists the known ones") {
  const UserCatalogue user;
  user.add("flat99.toml", "title = \"x\"");
  std::string message;
  try {
    io::load_case("flta99");
  } catch (const io::CaseFileError& e) {
    message = e.what();
  }
  CHECK(message.starts_with("case \"flta99\" is neither in the catalogue nor a file; did you mean \"flat99\"? The catalogue: "));
  CHECK(message.find("flat99") != std::string::npos);
  CHECK_THROWS_AS(io::load_case("flta99.toml"), io::FileError);
}

TEST_CASE("catalogue: a name whose ending was forgotten") {
  const UserCatalogue user;
  user.add("mine.toml", "title = \"x\"");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(user.folder);
  unsetenv("VOUSSOIR_CATALOGUE");  // "mine" is then no name of the catalogue
  std::string message;
  try {
    io::load_case("mine");
  } catch (const io::CaseFileError& e) {
    message = e.what();
  }
  std::filesystem::current_path(before);
  CHECK(message.starts_with("case \"mine\" is neither in the catalogue nor a file; did you mean \"mine.toml\"? The catalogue: "));
}

TEST_CASE("catalogue: a folder that is not there is a file error") {
  setenv("VOUSSOIR_CATALOGUE", "/nowhere/at/all", 1);
  CHECK_THROWS_AS(io::catalogue(), io::FileError);
  unsetenv("VOUSSOIR_CATALOGUE");
}
