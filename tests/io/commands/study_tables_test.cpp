// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What the scripts beside a study make of its table (scripts/study): effort, outcomes, verdict; the motions of one of its files.
namespace {

using shell::code_of;
using shell::text_of;

std::string script(const char* name) { return "/usr/bin/python3 " + shell::source(std::string("scripts/study/") + name) + " "; }

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
  // Bills that are kept are not made again.
  folder.write("bills/rods.txt", text_of(folder.path("bills/bare.txt")));
  REQUIRE(make(" --bills " + folder.path("bills")) == 0);
  CHECK(text_of(out).find("| rods | other joints alone |") != std::string::npos);
}

TEST_CASE("outcomes: statements by set of options and by what a record is a realisation of, a column each") {
  const TempFolder folder;
  const std::string head =
      "run,case,direction,record,options,status,collapsed,front wall: fallen_mass_fraction,rear wall: fallen_mass_fraction\n";
  const std::string table = folder.write("table.csv", head +
                                                          "a,flat20n,TLV,bam-like#1,,done,0,0.0,0.02\n"
                                                          "b,flat20n,TLV,bam-like#2,,done,1,0.6,0.9\n"
                                                          "c,flat20n,TLV,here/pulse0-1,,done,0,0.0,0.0\n"
                                                          "d,flat20n,TLV,bam-like#1,no_damping,done,0,0.06,0.0\n"
                                                          "e,flat20n,TLV,bam-like#2,no_damping,to be done,,,\n");
  const std::string out = folder.path("table.md"), statement = "| flat20n | TLV | stands (4.1) | ";
  const auto says = [&](const std::string& words, const std::string& columns, const std::string& row) {
    REQUIRE(code_of(script("outcomes.py") + table + words + " >" + out) == 0);
    const std::string text = text_of(out);
    CHECK(text.starts_with("| house | direction | the paper | " + columns + " |\n"));
    CHECK(text.find(statement + row + " |\n") != std::string::npos);
  };
  says(" --by options", "as_it_is | no_damping", "2 of 3 | 0 of 1");
  CHECK(code_of(script("outcomes.py") + table + " --by record >" + out + " 2>&1") == 1);
  CHECK(text_of(out).starts_with("d: the same house, direction and record as a; allowed: each once"));
  CHECK(code_of(script("outcomes.py") + table + " --by seed >" + out + " 2>&1") == 1);
  folder.write("table.csv", head +
                                "a,flat20n,TLV,bam-like#1,,done,0,0.0,0.02\n"
                                "b,flat20n,TLV,bam-like#2,,done,1,0.6,0.9\n"
                                "c,flat20n,TLV,here/pulse0-1,,done,0,0.0,0.0\n"
                                "d,flat20n,TLV,bam-like-1,,done,0,0.0,0.0\n");
  says(" --by record", "bam-like | pulse0 | bam-like-1", "1 of 2 | 1 of 1 | 1 of 1");
}

TEST_CASE("verdict: what an ensemble has in most runs, in some, in none, and which changes make it hold") {
  const TempFolder folder;
  std::string ensemble, model, motion;
  const auto add = [](std::string& table, const std::string& house, const std::string& record, const std::string& options, bool stands,
                      int cracks = 0) {
    if (table.empty())
      table =
          "run,case,direction,record,options,status,collapsed,front wall: fallen_mass_fraction,rear wall: fallen_mass_fraction,"
          "tension,shear,compression\n";
    table += "r," + house + ",TLV," + record + "," + options + ",done," + (stands ? "0,0.0,0.0," : "1,0.6,0.9,") + std::to_string(cracks) +
             ",0,0\n";
  };
  for (int i = 1; i <= 5; ++i) {
    const std::string record = "bam-like#" + std::to_string(i), changed = "here/weak-" + std::to_string(i);
    add(ensemble, "flat20n", record, "", false, 100);
    add(ensemble, "flat40n", record, "", i == 2, 120);
    add(ensemble, "flat20r", record, "", true, 50);
    if (i > 4) continue;
    for (const std::string house : {"flat20n", "flat40n"}) add(model, house, record, "as_it_is", false, 120);
    add(model, "flat20n", record, "wood", true), add(model, "flat20n", record, "springs", i == 1);
    if (i != 2) add(model, "flat20n", record, "dashpots", true);  // one is missing: those that both have count
    if (i > 2) add(model, "flat20n", record, "two", true);        // too few
    add(model, "flat40n", record, "wood", false, 110);            // fewer cracks than as it is, not than Flat20N as it is
    add(model, "flat40n", record, "deep", false, 90);
    add(motion, "flat20n", record, "", false), add(motion, "flat20n", changed, "", true);
  }
  const std::string paths[] = {folder.write("ensemble.csv", ensemble), folder.write("model.csv", model),
                               folder.write("motion.csv", motion)};
  const std::string out = folder.path("table.md");
  const auto holds = [&](const std::string& words, const std::string& row) {
    REQUIRE(code_of(script("verdict.py") + words + " >" + out) == 0);
    const std::string text = text_of(out);
    CAPTURE(text);
    CHECK(text.find("| " + row + " |\n") != std::string::npos);
  };
  const std::string wood = "wood (4 of 4, without 0); dashpots (3 of 3, without 0)", weak = "weak (4 of 4, without 0)";
  const std::string all = paths[0] + " --model " + paths[1] + " --motion " + paths[2];
  holds(paths[0], "flat40n | TLV | stands (4.1) | 1 of 5 | 4 to 62 | not tried | not tried | motion");
  holds(paths[0], "flat20r | TLV | stands (4.1) | 5 of 5 | 57 to 100 | not tried | not tried | agrees");
  holds(paths[0] + " --model " + paths[1], "flat20n | TLV | stands (4.1) | 0 of 5 | 0 to 43 | " + wood + " | not tried | open");
  holds(all, "flat20n | TLV | stands (4.1) | 0 of 5 | 0 to 43 | " + wood + " | " + weak + " | open");
  holds(all, "flat40n | TLV | fewer cracks than Flat20N (4.1) | 0 of 5 | 0 to 43 | deep (4 of 4, without 0) | not tried | open");
  for (int i = 1; i <= 4; ++i) {
    const std::string from = "here/weak-" + std::to_string(i) + ",,done,0,0.0,0.0,";
    motion.replace(motion.find(from), from.size(), "here/weak-" + std::to_string(i) + ",,done,1,0.9,0.9,");
  }
  folder.write("motion.csv", motion);
  holds(all, "flat20n | TLV | stands (4.1) | 0 of 5 | 0 to 43 | " + wood + " | none of 1 | model");
  CHECK(code_of(script("verdict.py") + "--model " + paths[1] + " >" + out + " 2>&1") == 1);
  const std::string single =
      folder.write("single.csv", ensemble.substr(0, ensemble.find('\n') + 1) + "r,flat20n,TLV,lucerne,,done,0,0,0,1,0,0\n");
  CHECK(code_of(script("verdict.py") + single + " >" + out + " 2>&1") == 1);
  CHECK(text_of(out) == "record = \"lucerne\"; allowed: realisations, as bam-like#7 or FOLDER/pulse50-7\n");
}

TEST_CASE("changed motions: half of the pulse is half of the displacement, what is left without it is small, T ends at rest") {
  if (code_of("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) {
    MESSAGE("skipped: no numpy for /usr/bin/python3; scripts/setup study installs it");
    return;
  }
  const TempFolder folder;
  const std::string out = folder.path("peaks.md");
  REQUIRE(code_of("VOUSSOIR=" + shell::kProgram + " " + script("changed_motions") + folder.path("motions") + " 4 >" + out) == 0);
  std::istringstream lines(text_of(out));
  std::map<std::string, std::array<double, 3>> peaks;  // m/s2, m/s, m
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string bar, name, letter;
    std::array<double, 3> p{};
    if (words >> bar >> name >> bar >> letter >> bar >> p[0] >> bar >> p[1] >> bar >> p[2]) peaks[name + " " + letter] = p;
  }
  REQUIRE(peaks.size() == 8);
  const auto displacement = [&](const char* motion) { return peaks.at(motion)[2] / peaks.at("bam-like#4 L")[2]; };
  CHECK(displacement("pulse50-4 L") == doctest::Approx(0.5).epsilon(0.03));
  CHECK(displacement("pulse25-4 L") == doctest::Approx(0.25).epsilon(0.06));
  CHECK(displacement("pulse0-4 L") < 0.15);  // of the short waves
  CHECK(peaks.at("strongT200-4 T")[0] == doctest::Approx(2.0 * peaks.at("bam-like#4 T")[0]).epsilon(0.01));
  CHECK(peaks.at("strongT200-4 T")[1] > 1.7 * peaks.at("bam-like#4 T")[1]);
  // The program reads them: figures of its own agree.
  const std::string figures = folder.path("figures");
  REQUIRE(code_of(shell::kProgram + " motion " + folder.path("motions/pulse50-4") + " >" + figures) == 0);
  CHECK(text_of(figures).find("pulse50-4") != std::string::npos);
}
