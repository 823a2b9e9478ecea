// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/io/app/commands/study_table.h"
#include "tests/io/csv_column.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// scripts/study/fragility.py: curves from a study's table. Where its Python's packages are absent this says so and passes.
namespace {

using csv::column;
using shell::code_of;
using shell::text_of;
using study::script;

// What fragility.py reads of a study's table.
const std::string kHead = "run,case,direction,record,scale,options,seed,status,collapsed,damage_grade\n";
constexpr double kQuartile = 0.6744897501960817;  // of the normal distribution

bool can_fit() {
  if (code_of("/usr/bin/python3 -c 'import h5py, matplotlib, scipy' 2>/dev/null") == 0) return true;
  MESSAGE("skipped: no h5py, matplotlib and scipy for /usr/bin/python3; scripts/setup study installs them");
  return false;
}

/// Four houses, two levels: one collapses at the scale 0.5 and all but one at 2.0; all are of grade 2; grade 5 is reached at 2.0 alone,
/// grade 4 from there on.
std::string two_levels(bool seeded, int stands = 3) {
  std::string rows = kHead;
  for (int house = 0; house < 4; ++house) {
    const auto row = [&](const char* scale, bool collapsed, const char* grade) {
      rows += std::string("r,house,LTV,,") + scale + ",," + (seeded ? std::to_string(house) : "") + ",done," + (collapsed ? "1," : "0,") +
              grade + "\n";
    };
    row("0.5", house == 0, "2");
    row("2.0", house != stands, house < 2 ? "5" : "4");
  }
  return rows + "r,house,LTV,,4.0,,0,to be done,,\nr,house,LTV,,4.0,,1,numerical failure,0,0\n";
}

/// The same outcomes, of one house under four records at two levels of PGA.
std::string four_records(const std::string& measure_of_last = "PGA") {
  std::string rows = "run,case,direction,record,scale,intensity,level,options,seed,status,collapsed,damage_grade\n";
  for (int record = 0; record < 4; ++record) {
    const std::string start = "r,house,LTV,record" + std::to_string(record) + ",,";
    rows += start + "PGA,0.5,,,done," + (record == 0 ? "1" : "0") + ",2\n";
    rows += start + (record == 3 ? measure_of_last : "PGA") + ",2.0,,,done," + (record == 3 ? "0" : "1") + ",4\n";
  }
  return rows;
}

/// The table's curves in the folder's out.csv; what it says is in "log".
int fragility(const TempFolder& folder, const std::string& table, const std::string& states) {
  return code_of(script("fragility.py") + folder.write("table.csv", table) + " -o " + folder.path("out.svg") + " --csv " +
                 folder.path("out.csv") + " --states " + states + " >" + folder.path("log") + " 2>&1");
}

}  // namespace

TEST_CASE("fragility: two levels of four runs have a curve through their shares") {
  if (!can_fit()) return;
  const TempFolder folder;
  REQUIRE_MESSAGE(fragility(folder, two_levels(true), "2 4 5 collapse") == 0, text_of(folder.path("log")));
  const std::string out = folder.path("out.csv");
  REQUIRE(column(out, "curve") == std::vector<std::string>(4, "house LTV"));
  // Two levels determine the two parameters: the likelihood is greatest where the curve has the shares 1/4 and 3/4 themselves.
  CHECK(std::stod(column(out, "median").at(3)) == doctest::Approx(std::sqrt(0.5 * 2.0)).epsilon(1e-4));
  CHECK(std::stod(column(out, "dispersion").at(3)) == doctest::Approx(std::log(2.0 / 0.5) / (2 * kQuartile)).epsilon(1e-4));
  CHECK(column(out, "runs") == std::vector<std::string>(4, "8"));
  CHECK(text_of(out).find("always reached: median below 0.5") != std::string::npos);
  CHECK(text_of(out).find("no overlap: median 0.5 to 2") != std::string::npos);
  CHECK(text_of(out).find("mixed at 2 alone") != std::string::npos);
}

TEST_CASE("fragility: bands count a house once that is shaken at every level, and a run without a seed by itself") {
  if (!can_fit()) return;
  // The curve is Phi(a + b ln x), a = 0, b = 1 / dispersion: ln median and ln dispersion have the errors of a and b times the dispersion.
  constexpr double kNormal = 1.959963984540054, kStudent = 3.182446305284263;    // 97.5 %: normal; Student's t, four houses less one
  const double level = std::log(2.0), dispersion = 2 * level / (2 * kQuartile);  // ln x is -level and level
  // Slopes of a run's log-likelihood: (1, ln x) times density / probability of what came out, times -1 where that was no collapse.
  const double density = std::exp(-0.5 * kQuartile * kQuartile) / std::sqrt(2 * 3.141592653589793);
  const double rare = density / 0.25, common = density / 0.75;
  // Fisher's information, diagonal: eight runs, density^2 / (P (1 - P)) each.
  const double of_a = 8 * rare * common, of_b = of_a * level * level;
  const auto check = [&](const std::string& table, const char* bands, double median_reach, double dispersion_reach) {
    const TempFolder folder;
    REQUIRE_MESSAGE(fragility(folder, table, "collapse") == 0, text_of(folder.path("log")));
    const std::string out = folder.path("out.csv");
    CHECK(column(out, "bands") == std::vector<std::string>(1, bands));
    CHECK(std::stod(column(out, "median_high").at(0)) == doctest::Approx(std::exp(median_reach)).epsilon(1e-4));
    CHECK(std::stod(column(out, "dispersion_low").at(0)) == doctest::Approx(dispersion * std::exp(-dispersion_reach)).epsilon(1e-4));
  };
  // Sums over the two runs of a house, of a: rare + common for the one that always collapses, 0 for two, -(rare + common) for the one that
  // stands; of b, over the level: common - rare for the first and the last, 2 common for the two between. G / (G - 1) is 4 / 3.
  const double squares_a = 2 * std::pow(rare + common, 2);
  const double squares_b = (2 * std::pow(common - rare, 2) + 2 * std::pow(2 * common, 2)) * level * level;
  check(two_levels(true), "by seed", kStudent * dispersion * std::sqrt(4.0 / 3.0 * squares_a) / of_a,
        kStudent * dispersion * std::sqrt(4.0 / 3.0 * squares_b) / of_b);
  const double median_reach = kNormal * dispersion / std::sqrt(of_a), dispersion_reach = kNormal * dispersion / std::sqrt(of_b);
  check(two_levels(false), "by run", median_reach, dispersion_reach);
  // The house that collapses at 0.5 alone: all sums of a are 0, and a band by house would have no width at the median.
  check(two_levels(true, 0), "by run", median_reach, dispersion_reach);
}

TEST_CASE("fragility: over levels of intensity, of all records together, bands count a record once") {
  if (!can_fit()) return;
  const TempFolder folder;
  REQUIRE_MESSAGE(fragility(folder, two_levels(true), "collapse") == 0, text_of(folder.path("log")));
  const std::string out = folder.path("out.csv");
  const std::vector<std::string> seeded{column(out, "median").at(0), column(out, "median_high").at(0), column(out, "dispersion_low").at(0)};
  REQUIRE_MESSAGE(fragility(folder, four_records(), "collapse --all-records") == 0, text_of(folder.path("log")));
  CHECK(column(out, "curve") == std::vector<std::string>{"house LTV"});
  CHECK(column(out, "bands") == std::vector<std::string>{"by record"});
  // The outcomes are those of four seeds at two scales, so the numbers are, too.
  CHECK(std::vector<std::string>{column(out, "median").at(0), column(out, "median_high").at(0), column(out, "dispersion_low").at(0)} ==
        seeded);
  CHECK(text_of(folder.path("out.svg")).find(">PGA, m/s²<") != std::string::npos);  // the words of the axis
  REQUIRE(fragility(folder, four_records(), "collapse") == 0);                      // a curve for each record
  CHECK(column(out, "curve").size() == 4);
  CHECK(fragility(folder, four_records("PGV"), "collapse --all-records") == 1);
  CHECK(text_of(folder.path("log")).find("different measures of intensity (PGA, PGV); wanted one") != std::string::npos);
  CHECK(fragility(folder, four_records(), "collapse --peak 3.0") == 1);
  CHECK(text_of(folder.path("log")).find("--peak is for studies over scales") != std::string::npos);
}

TEST_CASE("fragility: its files stand where they are looked for, and never on the table") {
  if (!can_fit()) return;
  const TempFolder folder;
  folder.write("fragility.csv", two_levels(true));  // a name that a table may have, as in cases/catalogue
  std::filesystem::create_symlink("fragility.csv", folder.path("link.csv"));
  const auto fragility_in_folder = [&](const std::string& words) {
    return code_of("cd " + folder.path() + " && " + script("fragility.py") + "fragility.csv " + words + " >log 2>&1");
  };
  for (const char* words : {"--csv fragility.csv", "--csv ./link.csv", "-o fragility.csv"}) {
    CHECK(fragility_in_folder(words) == 1);
    CHECK(text_of(folder.path("log")).find("is the table itself; wanted another file") != std::string::npos);
    CHECK(text_of(folder.path("fragility.csv")) == two_levels(true));
    CHECK_FALSE(std::filesystem::exists(folder.path("fragility.svg")));
  }
  REQUIRE_MESSAGE(fragility_in_folder("") == 0, text_of(folder.path("log")));
  CHECK(column(folder.path("curves.csv"), "state") == std::vector<std::string>{"2", "3", "4", "collapse"});
  CHECK(std::filesystem::exists(folder.path("fragility.svg")));
  CHECK(text_of(folder.path("fragility.csv")) == two_levels(true));
}

TEST_CASE("fragility: runs of two versions are no one table") {
  if (!can_fit()) return;
  const TempFolder folder;
  const std::string table =
      "run,case,direction,record,scale,options,seed,status,collapsed,damage_grade,version\n"
      "a,house,LTV,,0.5,,1,done,0,2,0.1.0 (physics 7)\nb,house,LTV,,2.0,,1,done,1,5,0.1.0 (physics 8)\n";
  folder.write("table.csv", table);
  CHECK(code_of(script("fragility.py") + folder.path("table.csv") + " -o " + folder.path("f.svg") + " --csv " + folder.path("c.csv") +
                " >" + folder.path("log") + " 2>&1") == 1);
  CHECK(text_of(folder.path("log")).find("a run of version 0.1.0 (physics 8), and one of ") != std::string::npos);
}

TEST_CASE("fragility: its tables have the grades of all runs, and the median of each state or where it lies") {
  if (!can_fit()) return;
  const TempFolder folder;
  const std::string table = folder.write("table.csv", two_levels(true));
  const auto made = [&](const char* which) {
    REQUIRE_MESSAGE(code_of(script("fragility_tables.py") + which + " " + table + " >" + folder.path("log") + " 2>&1") == 0,
                    text_of(folder.path("log")));
    return text_of(folder.path("log"));
  };
  CHECK(made("grades") ==
        "| scale of the motion | house |\n|---|---|\n"
        "| 0.5 | 2c, 2, 2, 2 |\n| 2 | 5c, 5c, 4c, 4 |\n");
  const std::string medians = made("medians");
  CHECK(medians.find("| state | house |\n|---|---|\n| grade 2 | below 0.5 |\n| grade 3 | between 0.5 and 2 |\n") == 0);
  CHECK(medians.find("| collapse | 1.00 (") != std::string::npos);
  CHECK(medians.find("); 1.03 |\n") != std::string::npos);  // 2 ln 2 / (2 kQuartile)
  CHECK(code_of(script("fragility_tables.py") + "shares " + table + " >" + folder.path("log") + " 2>&1") == 1);
}

TEST_CASE("fragility: what has no walls has no grades, but may collapse") {
  if (!can_fit()) return;
  const TempFolder folder;
  const std::string rows = "r,arch,,,0.5,,,done,0,-1\nr,arch,,,2.0,,,done,1,-1\n";
  REQUIRE_MESSAGE(fragility(folder, two_levels(true) + rows, "1 2 collapse") == 0, text_of(folder.path("log")));
  const std::string out = folder.path("out.csv"), text = text_of(out);
  CHECK(column(out, "runs") == std::vector<std::string>{"8", "8", "8", "0", "0", "2"});
  CHECK(text.find("arch,2,0,0,,,,,,,,no walls: no grades\n") != std::string::npos);
  CHECK(text.find("arch,collapse,2,1,,,,,,,,no overlap: median 0.5 to 2\n") != std::string::npos);
}

TEST_CASE("fragility: many runs of a known median and dispersion give them back") {
  if (!can_fit()) return;
  const TempFolder folder;
  constexpr double kMedian = 0.8, kDispersion = 0.4;
  constexpr int kRuns = 1000;  // a level, so that shares are within 0.0005 of the probabilities
  std::string rows = kHead;
  for (const double scale : {0.35, 0.5, 0.7, 1.0, 1.4}) {
    const double probability = 0.5 * std::erfc(-std::log(scale / kMedian) / (kDispersion * std::sqrt(2.0)));
    for (int i = 0; i < kRuns; ++i)
      rows += "r,house,,," + std::to_string(scale) + ",,,done," + (i < std::lround(probability * kRuns) ? "1" : "0") + ",0\n";
  }
  REQUIRE_MESSAGE(fragility(folder, rows, "collapse") == 0, text_of(folder.path("log")));
  const std::string out = folder.path("out.csv");
  CHECK(std::stod(column(out, "median").at(0)) == doctest::Approx(kMedian).epsilon(0.002));
  CHECK(std::stod(column(out, "dispersion").at(0)) == doctest::Approx(kDispersion).epsilon(0.01));
  CHECK(column(out, "bands") == std::vector<std::string>{"by run"});
}
