// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "tests/io/app/commands/study_table.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What the scripts beside a study make of its table (scripts/study): effort, outcomes, collapses, measure, verdict.
namespace {

using shell::code_of;
using shell::text_of;
using study::collapsed_at;
using study::kStands;
using study::script;
using study::Table;
using study::walls;
using study::with;

}  // namespace

TEST_CASE("effort: what a measure takes more than the bare house, beside grade and fallen mass by run") {
  const TempFolder folder;
  const std::string house =
      "[materials.adobe]\ndensity = 1800.0\nyoung = 1e8\npoisson = 0.25\n[joint_laws.normal]\ntension = 1e5\ncohesion = 1e5\n"
      "friction = 32.0\ncompression = 1e6\n[base]\nz = 0.0\n[house]\ninner_size = [1.6, 1.2]\nheight = 0.8\nbrick = [0.4, 0.2, 0.2]\n";
  folder.write("bare.toml", house);
  folder.write("rods.toml",
               house + "[[house.tie]]\nname = \"rods\"\nkind = \"along\"\nwalls = [\"front\"]\nheights = [0.3, 0.5]\narea = 1e-4\n");
  folder.write("piers.toml", house + "[[house.pier]]\nwall = \"rear\"\nfrom = 0.8\nwidth = 0.4\ndepth = 0.4\nheight = 0.4\n");
  const std::string study = folder.write("study.toml", "cases = [\"bare.toml\", \"rods.toml\", \"piers.toml\"]\n");
  const std::string table = folder.write("table.csv",
                                         "run,case,direction,record,scale,status,damage_grade,fallen_mass_fraction\n"
                                         "a,bare,TLV,bam-like,0.5,done,4,0.284\n"
                                         "b,bare,LTV,bam-like,0.5,done,2,0.1\n"
                                         "c,rods,TLV,bam-like,0.5,done,3,0.012\n"
                                         "d,rods,LTV,bam-like,0.5,to be done,,\n"
                                         "e,piers,TLV,bam-like,0.5,done,5,0.5\n"
                                         "f,piers,LTV,bam-like,0.5,done,2,0.0\n");
  const std::string out = folder.path("table.md");
  const auto make = [&](const std::string& words) {
    return code_of("VOUSSOIR=" + shell::kProgram + " " + script("effort.py") + study + " " + table + words + " >" + out);
  };
  REQUIRE(make(" --bills " + folder.path("bills")) == 0);
  CHECK(text_of(out) ==
        "| measure | effort | TLV, bam-like, x0.5 | LTV, bam-like, x0.5 | mean (without) |\n|---|---|---|---|---|\n"
        "| bare | none | G4 28.4 | G2 10.0 | – |\n"
        "| rods | 4 anchors, 4.00 m of rod | G3 1.2 | – | G3.0 (G4.0), 1.2 (28.4), 1 of 2 |\n"
        "| piers | +0.06 m3 of adobe brick | G5 50.0 | G2 0.0 | G3.5 (G3.0), 25.0 (19.2), 2 of 2 |\n");
  REQUIRE(make(" --record bam-like#1 --bills " + folder.path("bills")) == 0);
  CHECK(text_of(out).starts_with("| measure | effort | mean (without) |\n"));  // none of it is done
  REQUIRE(make(" --record bam-like --bills " + folder.path("bills")) == 0);
  CHECK(text_of(out).starts_with("| measure | effort | TLV, x0.5 | LTV, x0.5 | mean (without) |\n"));
  const std::string levels = folder.write("levels.csv",
                                          "run,case,direction,record,scale,intensity,level,status,damage_grade,fallen_mass_fraction\n"
                                          "a,bare,TLV,bam-like,,PGA,2.0,done,2,0.0\nb,bare,TLV,bam-like,,PGA,4.0,done,4,0.2\n");
  REQUIRE(code_of("VOUSSOIR=" + shell::kProgram + " " + script("effort.py") + study + " " + levels + " --bills " + folder.path("bills") +
                  " >" + out) == 0);
  CHECK(text_of(out).starts_with("| measure | effort | TLV, bam-like, PGA = 2.0 | TLV, bam-like, PGA = 4.0 | mean (without) |\n"));
  CHECK(text_of(out).find("| bare | none | G2 0.0 | G4 20.0 | – |\n") != std::string::npos);
  // Bills that are kept are not made again.
  folder.write("bills/rods.txt", text_of(folder.path("bills/bare.txt")));
  REQUIRE(make(" --bills " + folder.path("bills")) == 0);
  CHECK(text_of(out).find("| rods | other joints alone |") != std::string::npos);
}

TEST_CASE("outcomes: statements by set of options and by what a record is a realisation of, a column each") {
  const TempFolder folder;
  Table table;
  table.add("flat20n", "bam-like#1", kStands);
  table.add("flat20n", "bam-like#2", collapsed_at(4.0, 5.0));
  table.add("flat20n", "here/pulse0-1", kStands);
  table.add("flat20n", "bam-like#1", with(walls("0.16", "0.0"), {{"options", "no_damping"}}));
  table.add("flat20n", "bam-like#2", {{"options", "no_damping"}, {"status", "to be done"}});
  const std::string path = folder.write("table.csv", table.text());
  const std::string out = folder.path("table.md"), statement = "| flat20n | TLV | stands (4.1) | ";
  const auto says = [&](const std::string& words, const std::string& columns, const std::string& row) {
    REQUIRE(code_of(script("outcomes.py") + path + words + " >" + out) == 0);
    const std::string text = text_of(out);
    CHECK(text.starts_with("| house | direction | the paper | " + columns + " |\n"));
    CHECK(text.find(statement + row + " |\n") != std::string::npos);
  };
  says(" --by options", "as_it_is | no_damping", "2 of 3 | 0 of 1");
  CHECK(text_of(out).ends_with("\n4 of 5 runs are finished.\n"));
  CHECK(code_of(script("outcomes.py") + path + " --by record >" + out + " 2>&1") == 1);
  CHECK(text_of(out).starts_with(
      "r3: the same house, direction and record as r0; they differ in options (, no_damping); allowed: one run of each\n"));
  // A run that is in two tables counts once.
  Table shared;
  shared.add("flat20n", "bam-like#1", with(kStands, {{"identity", "0a"}}));
  const std::string first = folder.write("shared.csv", shared.text()), second = folder.write("again.csv", shared.text());
  REQUIRE(code_of(script("outcomes.py") + first + " " + second + " >" + out) == 0);
  CHECK(text_of(out).find(statement + "yes | – |\n") != std::string::npos);
  CHECK(code_of(script("outcomes.py") + path + " --by seed >" + out + " 2>&1") == 1);
  CHECK(code_of(script("outcomes.py") + folder.path("none.csv") + " >" + out + " 2>&1") == 1);
  CHECK(text_of(out) == folder.path("none.csv") + ": No such file or directory\n");
  Table motions;
  motions.add("flat20n", "bam-like#1", kStands);
  motions.add("flat20n", "bam-like#2", collapsed_at(4.0, 5.0));
  motions.add("flat20n", "here/pulse0-1", kStands);
  motions.add("flat20n", "bam-like-1", kStands);
  motions.add("flat20n", "bam-like#3", {{"status", "numerical failure"}});
  folder.write("table.csv", motions.text());
  says(" --by record", "bam-like | pulse0 | bam-like-1", "1 of 2 | 1 of 1 | 1 of 1");
  CHECK(text_of(out).ends_with("\n5 of 5 runs are finished, 1 by a numerical failure.\n"));
}

TEST_CASE("measure: one of a study's measures by set of options and house; the ends of its range where runs differ") {
  const TempFolder folder;
  Table table;
  table.add("vault20n", "bam-like#1", {{"settling_cracks", "1218"}, {"peak_drift", "0.25"}});
  table.add("vault20n", "bam-like#2", {{"settling_cracks", "1218"}, {"peak_drift", "1.5e-3"}});
  table.add("flat20w", "bam-like#1", {{"settling_cracks", "7"}, {"peak_drift", ""}});
  table.add("flat20w", "bam-like#1", {{"options", "rim"}, {"settling_cracks", "0"}});
  table.add("vault20n", "bam-like#1", {{"options", "rim"}, {"settling_cracks", "5"}, {"status", "to be done"}});
  const std::string path = folder.write("table.csv", table.text()), out = folder.path("table.md"),
                    head = "| options | flat20w | vault20n |\n|---|---|---|\n";
  REQUIRE(code_of(script("measure.py") + path + " settling_cracks >" + out) == 0);
  CHECK(text_of(out) == head + "| – | 7 | 1,218 |\n| rim | 0 | – |\n");
  REQUIRE(code_of(script("measure.py") + path + " peak_drift >" + out) == 0);
  CHECK(text_of(out) == head + "| – | – | 0.0015 to 0.25 |\n| rim | – | – |\n");
  CHECK(code_of(script("measure.py") + path + " drift >" + out + " 2>&1") == 1);
  CHECK(text_of(out).find("drift: no such column in ") == 0);
  CHECK(code_of(script("measure.py") + path + " run >" + out + " 2>&1") == 1);
  CHECK(text_of(out) == "run: r0 is no number; allowed: columns of numbers, as settling_cracks\n");
  CHECK(code_of(script("measure.py") + path + " >" + out + " 2>&1") == 1);
  CHECK(text_of(out).find("usage: measure.py") != std::string::npos);
}

TEST_CASE("collapses: how many runs lose their roof under motions of one name, and when; houses in the paper's order") {
  const TempFolder folder;
  Table table;
  table.add("walls-20", "bam-like#1", kStands);
  table.add("flat20n", "bam-like#1", with(collapsed_at(4.16, 5.0), {{"identity", "0a"}}));
  table.add("flat20n", "bam-like#2", collapsed_at(4.0, 5.0));
  table.add("flat20n", "bam-like#3", kStands);
  table.add("flat20n", "here/pulse0-1", with(collapsed_at(6.0, 7.0), {{"options", "rim"}, {"scale", "0.5"}}));
  table.add("flat20n", "here/pulse0-2", {{"status", "to be done"}});
  table.add("flat20w", "here/pulse0-1", with(collapsed_at(7.01, 8.0), {{"direction", "LTV"}}));
  table.add("flat20w", "here/pulse0-2", with(collapsed_at(6.99, 8.0), {{"direction", "LTV"}}));
  table.add("flat20n", "here/pulse0-3", with(collapsed_at(5.0, 6.0), {{"intensity", "PGV"}, {"level", "0.3"}}));
  const std::string path = folder.write("table.csv", table.text());
  Table known;  // the first of them, in another study too
  known.add("flat20n", "bam-like#1", with(collapsed_at(4.16, 5.0), {{"identity", "0a"}, {"scale", ""}}));
  const std::string out = folder.path("table.md");
  REQUIRE(code_of(script("collapses.py") + path + " " + folder.write("known.csv", known.text()) + " >" + out) == 0);
  CHECK(text_of(out) ==
        "| motion | flat20w LTV | flat20n TLV | walls-20 TLV |\n|---|---|---|---|\n"
        "| `bam-like` | – | 2 of 3, 4.0 to 4.2 | 0 of 1 |\n"
        "| `pulse0`, scale 0.5, rim | – | 1 of 1, 6.0 | – |\n"
        "| `pulse0` | 2 of 2, 7.0 | – | – |\n"
        "| `pulse0`, PGV = 0.3 | – | 1 of 1, 5.0 | – |\n");
  CHECK(code_of(script("collapses.py") + " >" + out + " 2>&1") == 1);
}

TEST_CASE("outcomes: a run that ended early, or in which the thing asked for did not happen, is undecided") {
  const TempFolder folder;
  Table table;
  const auto times = [](const std::string& bearing, const std::string& side) {
    const std::string quarter = " wall: quarter_fallen_time";
    return Table::Values{{"front" + quarter, bearing}, {"rear" + quarter, "-1.0"}, {"left" + quarter, side}, {"right" + quarter, "-1.0"}};
  };
  // Side walls have lost bricks in one run; one ended before they could.
  table.add("flat20w", "bam-like#1", with(collapsed_at(4.0, 5.0), {{"right wall: fallen_mass_fraction", "0.2"}}));
  table.add("flat20w", "bam-like#2", collapsed_at(4.0, 5.0));
  table.add("flat20w", "bam-like#3", kStands);
  // A quarter of a wall: bearing walls first, a side wall first, neither (no wall falls), both in one frame.
  table.add("vault20n", "bam-like#1", with(collapsed_at(2.2, 10.0), times("2.2", "3.0")));
  table.add("vault20n", "bam-like#2", with(collapsed_at(3.2, 6.2), times("3.0", "2.8")));
  table.add("vault20n", "bam-like#3", with(kStands, times("-1.0", "-1.0")));
  table.add("vault20n", "bam-like#4", with(collapsed_at(2.3, 5.3), times("2.2", "2.2")));
  // Later only where both fall, and not in one frame.
  table.add("vault40n", "bam-like#1", collapsed_at(2.5, 10.0));
  table.add("vault40n", "bam-like#2", collapsed_at(2.6, 10.0));
  table.add("vault40n", "bam-like#3", collapsed_at(2.6, 10.0));
  table.add("vault40n", "bam-like#4", collapsed_at(2.3, 10.0));
  table.add("vault20n", "bam-like#5", with(collapsed_at(3.0, 10.0), {{"front wall: fallen_mass_fraction", "0.1"}}));
  table.add("vault40n", "bam-like#5", collapsed_at(3.5, 10.0));
  // Alike in both directions.
  for (const char* record : {"bam-like#1", "bam-like#2"}) table.add("vault20w", record, collapsed_at(0.5, 10.0));
  table.add("vault20w", "bam-like#1", with(collapsed_at(0.9, 10.0), {{"direction", "LTV"}}));
  table.add("vault20w", "bam-like#2", with(collapsed_at(1.2, 10.0), {{"direction", "LTV"}}));
  // Fewer cracks: of a run that ended early, what it has is the least that it would have had.
  const auto cracked = [](const char* extent) {
    return Table::Values{{"front wall: opened_extent", extent}, {"rear wall: opened_extent", "0.0"}};
  };
  table.add("flat20n", "bam-like#1", with(collapsed_at(4.0, 5.0), cracked("9.0")));
  table.add("flat40n", "bam-like#1", with(kStands, cracked("5.0")));
  table.add("flat20n", "bam-like#2", with(collapsed_at(4.0, 5.0), cracked("4.0")));
  table.add("flat40n", "bam-like#2", with(kStands, cracked("5.0")));
  table.add("flat20n", "bam-like#3", with(kStands, cracked("4.0")));
  table.add("flat40n", "bam-like#3", with(collapsed_at(4.0, 5.0), cracked("5.0")));
  // By the limit reached first.
  const auto first = [](const char* tension, const char* shear, const char* time) {
    return Table::Values{{"first_tension", tension}, {"first_shear", shear}, {"first_compression", "0"}, {"first_crack_time", time}};
  };
  table.add("flat20s", "bam-like#1", with(kStands, first("160", "0", "3.4")));
  table.add("flat20s", "bam-like#2", with(kStands, first("160", "2", "3.6")));
  table.add("flat20s", "bam-like#3", with(kStands, first("0", "0", "-1.0")));
  const std::string path = folder.write("table.csv", table.text()), out = folder.path("table.md");
  REQUIRE(code_of(script("outcomes.py") + path + " >" + out) == 0);
  const std::string text = text_of(out);
  const auto says = [&](const std::string& row) {
    CAPTURE(row);
    CAPTURE(text);
    CHECK(text.find("\n| " + row + " |") != std::string::npos);
  };
  says("flat20w | TLV | side walls lose bricks (4.1) | 1 of 2 | 50 | 9 to 91 | 1");
  says("flat20w | TLV | stands (4.1) | 1 of 3 | 33 | 6 to 79 | 0 | –");  // no run of LTV
  says("vault20n | TLV | a bearing wall falls before a side wall (4.2) | 1 of 2 | 50 | 9 to 91 | 3");
  says("vault20n | TLV | both bearing walls fall (4.2) | 3 of 5 | 60 | 23 to 88 | 0");
  says("vault20n | TLV | the roof falls before the strong motion (4.2) | 2 of 5 | 40 | 12 to 77 | 0");
  says("vault40n | TLV | if both roofs fall, later than Vault20N's (4.2) | 2 of 3 | 67 | 21 to 94 | 2");
  says("vault20w | TLV | collapses within 0.5 s of LTV (4.2) | 1 of 2 | 50 | 9 to 91 | 0 | 1 of 2");
  says("vault20w | TLV | collapses as soon as the motion begins (4.2) | 2 of 2 | 100 | 34 to 100 | 0 | 2 of 2");
  says("vault40n | TLV | both bearing walls stay (4.2) | 0 of 5 | 0 | 0 to 43 | 0");
  says("flat40n | TLV | bearing walls less cracked than Flat20N's (4.1) | 1 of 2 | 50 | 9 to 91 | 1");
  says("flat20s | TLV | if it cracks, first by 3.5 s, while L rules (4.1) | 1 of 2 | 50 | 9 to 91 | 1");
  says("flat20s | TLV | springs fail in tension alone (4.1, 4.2) | 1 of 2 | 50 | 9 to 91 | 1");
}

TEST_CASE("outcomes: one run of each house says yes, no or undecided; what is no table of a study is refused") {
  const TempFolder folder;
  Table table;
  table.add("flat20n", "bam", kStands);
  table.add("flat40n", "bam", collapsed_at(6.0, 10.0));
  table.add("flat20r", "bam", with(kStands, {{"end_time", "3.0"}}));  // what stands at 3 s may fall by 10 s
  table.add("flat20n", "bam", with(kStands, {{"direction", "LTV"}}));
  Table drifts;  // a table that has what the first one lacks
  drifts.add("flat40n", "bam", with(kStands, {{"direction", "LTV"}, {"front wall: peak_drift", "0.1"}, {"rear wall: peak_drift", "0.1"}}));
  const std::string path = folder.write("table.csv", table.text()), out = folder.path("table.md");
  REQUIRE(code_of(script("outcomes.py") + path + " " + folder.write("drifts.csv", drifts.text()) + " >" + out) == 0);
  const std::string text = text_of(out);
  CHECK(text.find("| flat40n | LTV | bearing walls lean less than Flat20N's (4.1) | undecided | undecided |\n") !=
        std::string::npos);  // no drift
  CHECK(text.starts_with("| house | direction | the paper | here | directions exchanged |\n|---|---|---|---|---|\n"));
  CHECK(text.find("| flat20n | TLV | stands (4.1) | yes | yes |\n") != std::string::npos);
  CHECK(text.find("| flat40n | TLV | stands (4.3) | no | yes |\n") != std::string::npos);
  CHECK(text.find("| flat20r | TLV | stands (implied, 4.1) | undecided | – |\n") != std::string::npos);
  const std::string odd = folder.write("odd.csv", "run,median\na,1.0\n");
  CHECK(code_of(script("outcomes.py") + odd + " >" + out + " 2>&1") == 1);
  CHECK(text_of(out) == odd + ": no column \"case\"; allowed: the table.csv of a study\n");
}

TEST_CASE("verdict: what an ensemble has in most runs, in some, in none, and which changes make it hold") {
  const TempFolder folder;
  Table ensemble, model, motion;
  const auto stands = [](bool yes, const std::string& options = "", const std::string& cracks = "") {
    Table::Values values = yes ? kStands : collapsed_at(4.0, 10.0);
    for (const char* wall : {"front wall: opened_extent", "rear wall: opened_extent"}) values[wall] = cracks;
    return with(values, {{"options", options}});
  };
  for (int i = 1; i <= 5; ++i) {
    const std::string record = "bam-like#" + std::to_string(i), changed = "here/weak-" + std::to_string(i);
    ensemble.add("flat20n", record, stands(false, "", "1.0"));
    ensemble.add("flat40n", record, stands(i == 2, "", "1.2"));
    ensemble.add("flat20r", record, stands(true, "", "0.5"));
    for (const char* direction : {"LTV", "TLV"}) ensemble.add("flat20w", record, with(kStands, {{"direction", direction}}));
    if (i > 4) continue;
    for (const char* direction : {"LTV", "TLV"})
      model.add("flat20w", record, with(kStands, {{"direction", direction}, {"options", "as_it_is"}}));
    model.add("flat20w", record, with(stands(false, "wood"), {{"direction", "LTV"}}));  // its TLV is missing
    for (const std::string house : {"flat20n", "flat40n"}) model.add(house, record, stands(false, "as_it_is", "1.2"));
    model.add("flat20n", record, stands(true, "wood")), model.add("flat20n", record, stands(i == 1, "springs"));
    if (i != 2) model.add("flat20n", record, stands(true, "dashpots"));  // one is missing: those that both have count
    if (i > 2) model.add("flat20n", record, stands(true, "two"));        // too few
    model.add("flat40n", record, stands(false, "wood", "1.1"));          // fewer cracks than as it is, not than Flat20N as it is
    model.add("flat40n", record, stands(false, "deep", "0.9"));
    model.add("flat40n", record, stands(i == 3, "chance_1", "1.2"));
    motion.add("flat20n", record, stands(false, "", "1.0")), motion.add("flat20n", changed, stands(true, "", "2.0"));
    motion.add("flat40n", record, stands(false, "", "1.2")), motion.add("flat40n", changed, stands(false, "", "1.5"));
  }
  const std::string paths[] = {folder.write("ensemble.csv", ensemble.text()), folder.write("model.csv", model.text()),
                               folder.write("motion.csv", motion.text())};
  const std::string out = folder.path("table.md");
  const auto holds = [&](const std::string& words, const std::string& row) {
    REQUIRE(code_of(script("verdict.py") + words + " >" + out) == 0);
    const std::string text = text_of(out);
    CAPTURE(text);
    CAPTURE(row);
    CHECK(text.find("| " + row + " |\n") != std::string::npos);
  };
  const std::string wood = "wood (4 of 4, without 0); dashpots (3 of 3, without 0)", weak = "weak (4 of 4, without 0)";
  const std::string all = paths[0] + " --model " + paths[1] + " --motion " + paths[2],
                    none = "flat20n | TLV | stands (4.1) | 0 of 5 | 0 to 43 | ";
  holds(paths[0], "flat40n | TLV | stands (4.3) | 1 of 5 | 4 to 62 | not tried | not tried | – | motion");
  holds(all, "flat40n | TLV | stands (4.3) | 1 of 5 | 4 to 62 | none of 2 | none of 1 | 1 of 4 | motion or chance");
  holds(paths[0], "flat20r | TLV | stands (implied, 4.1) | 5 of 5 | 57 to 100 | not tried | not tried | – | agrees");
  holds(paths[0], none + "not tried | not tried | – | open: no change was tried");
  holds(paths[0] + " --model " + paths[1],
        none + wood + " | not tried | – | open: a choice of the model makes it hold, no changed motion was tried");
  holds(all, none + wood + " | " + weak + " | – | open: a motion with other figures makes it hold");
  // A house with a changed model under LTV is not compared with the unchanged one under TLV.
  holds(all,
        "flat20w | LTV | falls, and under TLV it stands (4.1) | 0 of 5 | 0 to 43 | not tried | not tried | – | open: no change was tried");
  // With the model changed the other house is that of the ensemble; under a changed motion it is under that motion, too.
  holds(all,
        "flat40n | TLV | bearing walls less cracked than Flat20N's (4.1) | 0 of 5 | 0 to 43 | deep (4 of 4, without 0) | "
        "weak (4 of 4, without 0) | 0 of 4 | open: a motion with other figures makes it hold");
  // In brief: what agrees or has no answer is counted only.
  holds(all + " --brief", "stands (4.3) | flat40n TLV 1/5 | motion or chance");
  holds(all + " --brief", "stands (4.1) | flat20n TLV 0/5 | open: a motion with other figures makes it hold");
  CHECK(text_of(out).find("flat20r") == std::string::npos);
  CHECK(text_of(out).find("no change was tried") == std::string::npos);
  Table still;
  for (int i = 1; i <= 4; ++i) {
    still.add("flat20n", "bam-like#" + std::to_string(i), stands(false));
    still.add("flat20n", "here/weak-" + std::to_string(i), stands(i == 4));
  }
  folder.write("motion.csv", still.text());
  holds(all, none + wood + " | none of 1 (nearest: weak, 1 of 4, without 0) | – | model");
  // Of a house at rest one run with a change tells, and no motion does.
  const auto cracked = [](const std::string& record, const std::string& options, const std::string& cracks) {
    return Table::Values{{"direction", record.empty() ? "" : "TLV"}, {"options", options}, {"settling_cracks", cracks}};
  };
  Table weights, shaken;
  for (const char* record : {"bam-like#1", "bam-like#2", "bam-like#3", "bam-like#4"})
    shaken.add("vault20n", record, cracked(record, "", "9"));
  weights.add("vault20n", "", cracked("", "as_it_is", "9")), weights.add("vault20n", "", cracked("", "rim", "8"));
  const std::string of_weights = folder.write("shaken.csv", shaken.text()) + " --motion " + paths[2] + " --model ",
                    at_rest = "vault20n | TLV | nothing cracks before the motion begins (4.2) | 0 of 4 | 0 to 49 | ";
  holds(of_weights + folder.write("weights.csv", weights.text()),
        at_rest + "none of 1 | cannot change it | – | open: nothing that was tried makes it hold");
  weights.add("vault20n", "", cracked("", "softening", "0"));
  holds(of_weights + folder.write("weights.csv", weights.text()), at_rest + "softening (1 of 1, without 0) | cannot change it | – | model");
  weights.add("vault20n", "", cracked("", "no_shear", "")),
      weights.add("vault20n", "", cracked("", "chance", "0"));  // does not tell; is no choice
  holds(of_weights + folder.write("weights.csv", weights.text()), at_rest + "softening (1 of 1, without 0) | cannot change it | – | model");
  weights.add("vault20n", "", cracked("", "rim", "0"));
  CHECK(code_of(script("verdict.py") + of_weights + folder.write("weights.csv", weights.text()) + " >" + out + " 2>&1") == 1);
  CHECK(text_of(out) == "r5: a second run of vault20n at rest with the options rim beside r1; allowed: one of each\n");
  folder.write("motion.csv", Table().text());
  const auto refuses = [&](const std::string& words, const std::string& message) {
    CHECK(code_of(script("verdict.py") + words + " >" + out + " 2>&1") == 1);
    CHECK(text_of(out) == message);
  };
  CHECK(code_of(script("verdict.py") + "--model " + paths[1] + " >" + out + " 2>&1") == 1);
  Table odd;
  odd.add("flat20n", "bam-like-1", kStands);
  refuses(folder.write("odd.csv", odd.text()), "record = \"bam-like-1\"; allowed: realisations, as bam-like#7 or FOLDER/pulse50-7\n");
  Table twice;
  twice.add("flat20n", "bam-like#1", kStands), twice.add("flat20n", "here/weak-1", kStands);
  refuses(folder.write("twice.csv", twice.text()), "r1: a second run of realisation 1 beside r0; allowed: one of each\n");
}

TEST_CASE("compare_options: what sets of the same seeds have is exchanged within each seed, of other seeds all is divided") {
  const TempFolder folder;
  std::string rows = "run,case,seed,options,status,fallen_mass_fraction,peak_drift\n";
  for (int seed = 1; seed <= 6; ++seed) {
    const auto row = [&](const std::string& options, int of_seed, int fallen) {
      const std::string drift = seed == 3 && options == "one" ? "" : std::to_string(fallen);  // a value that one run lacks
      rows += "r,hut," + std::to_string(of_seed) + "," + options + ",done," + std::to_string(fallen / 100.0) + "," + drift + "\n";
    };
    row("one", seed, seed), row("two", 7 - seed, seed + 9), row("other", seed + 1, seed + 9);
  }
  const std::string table = folder.write("table.csv", rows), out = folder.path("table.md");
  REQUIRE(code_of(script("compare_options.py") + table + " one two other >" + out) == 0);
  // All of one set lie below all of the other: D = 1. So they do in 2 of 2^6 exchanges, and in 2 of 924 divisions of 12.
  const std::string text = text_of(out);
  CAPTURE(text);
  CHECK(text.starts_with("| | one, 6 runs | two, 6 runs | other, 6 runs | two: D, p (by seed) | other: D, p (divided) |\n"));
  CHECK(text.find("\n| fallen mass, % | 4 (2 to 5) | 13 (11 to 14) | 13 (11 to 14) | 1.00, 0.03 | 1.00, 0.00 |\n") != std::string::npos);
  CHECK(text.find("\n| peak drift | 4 (2 to 5) | 13 (11 to 14) | 13 (11 to 14) | 1.00, 0.03 | 1.00, 0.00 |\n") != std::string::npos);

  // Three seeds at two levels are six places, too.
  std::string levels = "run,case,intensity,level,seed,options,status,fallen_mass_fraction\n";
  for (int place = 1; place <= 6; ++place) {
    const std::string at = ",hut,PGA," + std::string(place > 3 ? "4.0," : "2.0,") + std::to_string((place - 1) % 3 + 1);
    levels += "a" + at + ",one,done,0.0" + std::to_string(place) + "\nb" + at + ",two,done,0.1" + std::to_string(place) + "\n";
  }
  REQUIRE(code_of(script("compare_options.py") + folder.write("levels.csv", levels) + " one two >" + out) == 0);
  CHECK(text_of(out).starts_with("| | one, 6 runs | two, 6 runs | two: D, p (by seed) |\n"));
  CHECK(text_of(out).find("| fallen mass, % | 4 (2 to 5) | 14 (12 to 15) | 1.00, 0.03 |\n") != std::string::npos);
}
