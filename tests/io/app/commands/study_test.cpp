// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/io/csv_column.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// scripts/study on a study of two runs of a second. Without Snakemake the script runs its jobs itself.
namespace {

using csv::column;
using shell::code_of;
using shell::text_of;

const std::string kCase = "cases = [\"" VOUSSOIR_SOURCE_DIR "/tests/faults/data/wall.toml\"]\n";

std::string script(const char* name) { return "/usr/bin/python3 " + shell::source(std::string("scripts/study/") + name) + " "; }

bool can_study() {
  if (code_of("/usr/bin/python3 -c 'import h5py, matplotlib' 2>/dev/null") == 0) return true;
  MESSAGE("skipped: no h5py and matplotlib for /usr/bin/python3; scripts/setup plots installs them");
  return false;
}

/// The study in the folder's "study", or another; what it says is in "log".
int study(const TempFolder& folder, const std::string& file, const std::string& words = "--cores 2", const std::string& name = "study") {
  return code_of("VOUSSOIR=" + shell::kProgram + " " + script("run") + file + " -o " + folder.path(name) + " " + words + " >" +
                 folder.path("log") + " 2>&1");
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
      {"[intensity]\nmeasure = \"Sa\"\nlevels = [1.0]\n", "intensity.period = null; allowed: a table [intensity]: "},
      {"[intensity]\nmeasure = \"PGA\"\nlevels = [2.0, 1.0, 2.0]\n", "intensity.levels = [2.0, 1.0, 2.0]"},
      {"[intensity]\nmeasure = [\"PGA\"]\nlevels = [1.0]\n", "intensity.measure = [\"PGA\"]"},
      {"[intensity]\nmeasure = \"PGA\"\nlevels = [1.0]\ncomponents = \"rotd50\"\n", "intensity.components = \"rotd50\""},
      {"scales = [1.0]\n[intensity]\nmeasure = \"PGA\"\nlevels = [1.0]\n", "scales = [1.0]; allowed: none beside [intensity]"},
      {"set = [\"motion.intensity={level=2}\"]\n[intensity]\nmeasure = \"PGA\"\nlevels = [1.0]\n", "has no effect beside `intensity`"},
      {"set = [\"motion.intensity.level=2\"]\n[intensity]\nmeasure = \"PGA\"\nlevels = [1.0]\n", "has no effect beside `intensity`"},
      {"set = [\"house.brik=1\"]\n", "house.brik"},
      {"records = [\"${NO_SUCH_NAME}/rinaldi\"]\n", "NO_SUCH_NAME is not set"},
      {"records = [{ name = \"r\", L = 3 }]\n", "records[0] = {\"name\": \"r\", \"L\": 3}; allowed: \"bam-like\""},
      {"records = [{ name = \"r\", L = \"none.AT2\", T = \"none.AT2\" }]\n", "none.AT2: no such file"},
      {"[options]\na = \"b=1\"\n", "options.a = \"b=1\""},
      {"records = [\"bam-like\"]\n[options]\na = []\nb = [\"b.c=1\"]\n", "-b: voussoir: --set b.c=1"},              // the second option's
      {"records = [\"bam-like\", \"bam-like#0\", \"bam-like#x\"]\n[options]\na = []\nb = []\n", "\"bam-like#0\""},  // the first of two
  };
  for (const auto& fault : faults) {
    const std::string file = folder.write("faulty.toml", kCase + fault[0]);
    CHECK(study(folder, file) == 2);
    const std::string said = text_of(folder.path("log"));
    CHECK_MESSAGE(said.find("faulty.toml: ") != std::string::npos, said);
    CHECK_MESSAGE(said.find(fault[1]) != std::string::npos, said);
    CHECK_FALSE(std::filesystem::exists(folder.path("study")));
  }
  // Of two cases the second.
  const std::string other = folder.write("other.toml", "[houze]\n");
  CHECK(study(folder, folder.write("faulty.toml", kCase.substr(0, kCase.size() - 2) + ", \"" + other + "\"]\n")) == 2);
  CHECK_MESSAGE(text_of(folder.path("log")).find("houze") != std::string::npos, text_of(folder.path("log")));
}

/// Height of the picture of a study's last frames, px, and whether there is something in the last picture of each of its rows.
std::string last_frames(const TempFolder& folder, int rows, const std::string& name = "study", const std::string& words = "") {
  const std::string sheet = folder.path("ends.png"), said = folder.path("drawn");
  const std::string look = folder.write("look.py",
                                        "import numpy, sys\nfrom PIL import Image\n"
                                        "shade = numpy.asarray(Image.open(sys.argv[1]).convert('L'))\n"
                                        "pictures = numpy.array_split(shade[24:, -80:], int(sys.argv[2]))\n"
                                        "print(shade.shape[0] - 24, *[int((p[len(p) // 3:] < 200).any()) for p in pictures])\n");
  if (code_of(script("last_frames.py") + folder.path(name) + " --width 80 -o " + sheet + words) != 0) return "refused";
  if (code_of("/usr/bin/python3 " + look + " " + sheet + " " + std::to_string(rows) + " >" + said) != 0) return "unreadable";
  return text_of(said);
}

/// The folder's "options": its "study" as if the two runs had differed by options, "low" and "high".
void options_in_place_of_scales(const TempFolder& folder) {
  std::string plan = text_of(folder.path("study/plan.json"));
  const auto replace = [&](const std::string& old, const std::string& now) {
    const std::size_t at = plan.find(old);
    REQUIRE(at != std::string::npos);
    plan.replace(at, old.size(), now);
  };
  for (const auto& [scale, options] : {std::pair{"0.0", "low"}, {"1.0", "high"}}) {
    replace("\"scale\": " + std::string(scale), "\"scale\": null");
    replace("\"options\": \"\"", "\"options\": \"" + std::string(options) + "\"");
  }
  std::filesystem::create_directory(folder.path("options"));
  std::filesystem::create_directory_symlink(folder.path("study/runs"), folder.path("options/runs"));
  folder.write("options/plan.json", plan);
}

TEST_CASE(
    "a study over levels of intensity: each record reaches each level, in place of the case's own, and the table says by which factor") {
  if (!can_study()) return;
  const TempFolder folder;
  // The second case has an intensity of its own, with a period that goes with no PGA.
  const std::string wall = VOUSSOIR_SOURCE_DIR "/tests/faults/data/wall.toml";
  folder.write("own.toml", "include = \"" + wall + "\"\n[motion.intensity]\nmeasure = \"Sa\"\nlevel = 3.0\nperiod = 0.2\n");
  const std::string file = folder.write("levels.toml", "cases = [\"" + wall + "\", \"own.toml\"]\n" +
                                                           "records = [\"bam-like\", \"bam-like#2\"]\nduration = 0.2\n"
                                                           "[intensity]\nmeasure = \"PGA\"\nlevels = [1, 2.0]\ncomponents = \"larger\"\n");
  REQUIRE_MESSAGE(study(folder, file) == 0, text_of(folder.path("log")));
  const std::string table = folder.path("study/table.csv");
  CHECK(text_of(folder.path("study/runs/wall-bam-like-PGA_1/case.toml")).find("components = \"larger\"") != std::string::npos);
  using Values = std::vector<std::string>;
  CHECK(column(table, "run") == Values{"wall-bam-like-PGA_1", "wall-bam-like-PGA_2", "wall-bam-like_2-PGA_1", "wall-bam-like_2-PGA_2",
                                       "own-bam-like-PGA_1", "own-bam-like-PGA_2", "own-bam-like_2-PGA_1", "own-bam-like_2-PGA_2"});
  CHECK(column(table, "intensity") == Values(8, "PGA"));
  CHECK(column(table, "level") == Values{"1.0", "2.0", "1.0", "2.0", "1.0", "2.0", "1.0", "2.0"});
  std::vector<double> factor;
  for (const std::string& text : column(table, "motion_factor")) factor.push_back(std::stod(text));
  REQUIRE(factor.size() == 8);
  CHECK(factor[1] == doctest::Approx(2.0 * factor[0]).epsilon(1e-12));
  CHECK(factor[2] != factor[0]);                                          // another record
  for (std::size_t i = 0; i < 4; ++i) CHECK(factor[i + 4] == factor[i]);  // the same record under the other case
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
  CHECK(column(table, "damage_grade") == Values{"-1", "-1"});  // a wall of free blocks is no house
  CHECK(column(table, "debris_reach").size() == 2);
  CHECK(text_of(folder.path("study/index.html")).find("2 of 2 runs done") != std::string::npos);

  const std::string both = last_frames(folder, 2);
  CHECK_MESSAGE(both.find(" 1 1\n") != std::string::npos, both);
  options_in_place_of_scales(folder);
  CHECK(last_frames(folder, 2, "options") == both);
  const std::string beside = last_frames(folder, 1, "options", " --columns options");  // the two runs in one row
  CHECK_MESSAGE(2 * std::stoi(beside) == std::stoi(both), beside);
  CHECK_MESSAGE(beside.find(" 1\n") != std::string::npos, beside);

  const std::string hash = column(table, "state_hash").at(1);
  std::filesystem::remove(folder.path("study/runs/wall-x1/done.json"));  // as if killed at the end of its run
  REQUIRE(study(folder, file) == 0);
  CHECK(text_of(table) == first);

  std::filesystem::remove_all(folder.path("study/runs/wall-x1"));  // a table of what is there does not stand for what is not
  std::filesystem::remove_all(folder.path("study/plots"));         // as in a study that has not come to its plots yet
  REQUIRE(study(folder, file, "--table") == 0);
  CHECK(text_of(folder.path("study/index.html")).find("1 of 2 runs done") != std::string::npos);
  CHECK(text_of(folder.path("study/index.html")).find("data:image/svg+xml") != std::string::npos);  // the plots
  CHECK(column(table, "status") == Values{"done", "to be done"});
  const std::string one = last_frames(folder, 1);
  CHECK_MESSAGE(2 * std::stoi(one) == std::stoi(both), one);  // half as high: the run that is not done has no row
  REQUIRE(study(folder, file) == 0);
  CHECK(column(table, "status") == Values{"done", "done"});
  CHECK(column(table, "state_hash").at(1) == hash);

  // Elsewhere, the table is enough: what it says of a run that is the same is not found out again.
  const auto elsewhere = [&](const std::string& other) { return study(folder, file, "--cores 2 --known " + other, "elsewhere"); };
  const std::size_t second = first.rfind("\nwall-x1") + 1, its_identity = first.find(column(table, "identity").at(1), second);
  std::string known = first;
  known[its_identity] = known[its_identity] == '0' ? '1' : '0';  // of another run
  REQUIRE_MESSAGE(elsewhere(folder.write("known.csv", known)) == 0, text_of(folder.path("log")));
  CHECK(text_of(folder.path("elsewhere/table.csv")).substr(0, second) == first.substr(0, second));
  CHECK(column(folder.path("elsewhere/table.csv"), "state_hash") == column(table, "state_hash"));
  CHECK_FALSE(std::filesystem::exists(folder.path("elsewhere/runs/wall-x0")));
  CHECK(std::filesystem::exists(folder.path("elsewhere/runs/wall-x1")));

  // A run is known by what it is, not by the study that it was in. Three tables, of which the one in the middle has the runs.
  const std::string of_another = folder.write("options.toml", kCase + "scales = [0, 1]\nduration = 0.6\n[options]\nas_it_is = []\n");
  const std::string none = folder.write("none.csv", "run,identity,status\nwall-x0,0,done\n");
  REQUIRE_MESSAGE(study(folder, of_another, "--cores 2 --known " + none + " --known " + table + " --known " + none, "other") == 0,
                  text_of(folder.path("log")));
  const std::string taken = folder.path("other/table.csv");
  CHECK(column(taken, "run") == Values{"wall-x0-as_it_is", "wall-x1-as_it_is"});
  CHECK(column(taken, "options") == Values{"as_it_is", "as_it_is"});
  CHECK(column(taken, "state_hash") == column(table, "state_hash"));
  CHECK_FALSE(std::filesystem::exists(folder.path("other/runs")));
  std::string earlier = text_of(table);
  for (std::size_t at = 0; (at = earlier.find("physics 14", at)) != std::string::npos;) earlier.replace(at, 10, "physics 13");
  CHECK(study(folder, file, "--cores 2 --known " + folder.write("earlier.csv", earlier), "earlier") == 0);  // see versions.py
  CHECK_FALSE(std::filesystem::exists(folder.path("earlier/runs")));
  std::string other = text_of(table);
  other.replace(other.find("physics "), 8, "physics 1");
  CHECK(elsewhere(folder.write("known.csv", other)) == 2);
  CHECK(text_of(folder.path("log")).find("known.csv: holds runs of version 0.1.0 (physics 1") != std::string::npos);
  CHECK(elsewhere(folder.write("known.csv", "run,status\na,done\n")) == 2);
  CHECK(text_of(folder.path("log")).find("known.csv: no column identity") != std::string::npos);

  const std::string made_by = folder.path("study/runs/wall-x0/version"), version = text_of(made_by);
  folder.write("study/runs/wall-x0/version", "0.1.0 (physics 1)\n");
  CHECK(study(folder, file) == 2);
  CHECK(text_of(folder.path("log")).find("wall-x0: is a run of version 0.1.0 (physics 1), and this is 0.1.0 (physics ") !=
        std::string::npos);
  folder.write("study/runs/wall-x0/version", version);

  folder.write("two.toml", kCase + "scales = [0.0, 1.0]\nduration = 0.7\n");  // other runs under the same names
  CHECK(study(folder, file) == 2);
  CHECK(text_of(folder.path("log")).find("wall-x0: holds a run of the same name") != std::string::npos);
}

namespace {

/// The plan of a study of two runs, which a program of the test's own makes. The program begins no results of "bad"; those of "broken" are
/// no HDF5 file.
void write_plan(const TempFolder& folder) {
  const std::string program = folder.write("program",
                                           "#!/bin/sh\n[ \"$1\" = summary ] && { echo \"cannot be read\" >&2; exit 3; }\n"
                                           "[ \"$2\" = broken ] && echo none >runs/broken/run.h5\necho 'numerical failure'; exit 1\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const auto run = [](const std::string& name) {
    return R"({"name": ")" + name + R"(", "case": ")" + name + R"(", "axes": {"case": ")" + name + R"("}, "set": [], "identity": "0a"})";
  };
  folder.write("plan.json", R"({"voussoir": ")" + program + R"(", "version": "0.1.0", "threads": 1, "checkpoint_every": 300, "stills": [],
    "report": false, "known": {}, "runs": [)" +
                                run("bad") + ", " + run("broken") + "]}");
}

}  // namespace

TEST_CASE("a study: what ends before it has results is no numerical failure; results that cannot be read leave their row empty") {
  if (!can_study()) return;
  const TempFolder folder;
  write_plan(folder);
  const auto here = [&](const std::string& words) { return code_of("cd " + folder.path() + " && " + words + " >log 2>&1"); };
  CHECK(here(script("job.py") + "plan.json bad") == 1);
  CHECK(text_of(folder.path("log")) == "bad: numerical failure (exit code 1; runs/bad/program.log)\n");
  CHECK_FALSE(std::filesystem::exists(folder.path("runs/bad/done.json")));
  CHECK(here(script("job.py") + "plan.json broken") == 0);
  CHECK(text_of(folder.path("runs/broken/done.json")) == "{\"status\": \"numerical failure\"}\n");
  // The rest of the table is there all the same.
  CHECK(here(script("gather.py") + "plan.json table.csv") == 0);
  CHECK(text_of(folder.path("log")) == "warning: runs/broken: cannot be read; its row is left empty; remove runs/broken to run it anew\n");
  CHECK(column(folder.path("table.csv"), "run") == std::vector<std::string>{"bad", "broken"});
  CHECK(column(folder.path("table.csv"), "status") == std::vector<std::string>{"to be done", "to be done"});
}

TEST_CASE("a study: a table that is made beside another leaves the other's alone") {
  if (!can_study()) return;
  const TempFolder folder;
  write_plan(folder);
  const std::string other = folder.write("table.csv.tmp", "half of a tab");
  CHECK(code_of("cd " + folder.path() + " && " + script("gather.py") + "plan.json table.csv") == 0);
  CHECK(text_of(other) == "half of a tab");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
  CHECK(files == 4);  // the program, the plan, the table, and the other's
}

TEST_CASE("a table in Markdown has the runs that are done, in figures for people") {
  const TempFolder folder;
  const std::string head =
      "run,status,damage_grade,first_crack_time,first_fallen_wall,first_fallen_time,roof_fallen_mass_fraction,collapsed,collapse_time,"
      "fallen_mass_fraction,peak_drift,debris_area,debris_reach,free_volume,first_tension,first_shear,first_compression,tension,shear,"
      "compression,slipped,peak_base_shear,"
      "worst_residual,core_hours,front wall: quarter_fallen_time,rear wall: quarter_fallen_time,settling_cracks\n";
  const std::string rows =
      "fell,done,5,0.0371,front "
      "wall,2.6,1.0,1,3.3,0.8577,0.764,48.25,4.21,0.334,9,487379,100,487252,0,236,0,110200.4,4.1e-05,0.52,3.1,2.98,15936\n"
      "stood,done,0,-1.0,,-1.0,0.0,0,-1.0,0.0,0.0104,0.0,0.0,0.999,0,12,0,0,0,0,12,358800.0,4.4e-08,0.06,-1.0,-1.0,0\n"
      "arch,done,-1,0.5,,-1.0,,0,-1.0,0.25,,1.0,0.5,,,,,7,0,0,0,1000.0,1e-06,0.01,,,\n"
      "waits,to be done,,,,,,,,,,,,,,,,,,,,,,0,,,\n";
  const std::string table = folder.write("table.csv", head + rows), out = folder.path("table.md");
  REQUIRE(code_of(script("markdown.py") + table + " >" + out) == 0);
  const std::string text = text_of(out);
  const auto has = [&](const char* line) { return text.find(line) != std::string::npos; };
  CHECK(std::count(text.begin(), text.end(), '\n') == 5);
  CHECK(
      has("\n| fell | G5 | 0.04 (15,936 by weight) | rear, 2.98 | 100.0, 3.30 | 85.8 | 76.4 | 48.2; 4.2 | 33.4 | 9 / 487,379 / 100 | "
          "487,252 / 0 / 236 | 0 | 110 | 4.1e-05 | 0.52 |\n"));
  CHECK(has("\n| stood | G0 | never | none | 0.0 | 0.0 | 1.0 | 0.0; 0.0 | 99.9 | 0 / 12 / 0 | 0 / 0 / 0 | 12 | 359 | 4.4e-08 | 0.06 |\n"));
  CHECK(has("\n| arch | – | 0.50 | none | – | 25.0 | – | 1.0; 0.5 | – | – | 7 / 0 / 0 | 0 | 1 | 1.0e-06 | 0.01 |\n"));
  CHECK_FALSE(has("waits"));
  CHECK(code_of(script("markdown.py") + table + " run 'roof fallen' grade >" + out) == 0);
  CHECK(text_of(out).find("| run | grade | roof fallen, %; collapse, s |\n|---|---|---|\n| fell | G5 | 100.0, 3.30 |\n") == 0);
  CHECK(code_of(script("markdown.py") + table + " roofs 2>" + out) == 1);
  CHECK(text_of(out).find("roofs: no column begins so; allowed: run; grade; ") == 0);
}
