// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "tests/io/app/commands/study_table.h"
#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// Statements of the paper that one row or two answer (scripts/study/statements.py), by outcomes.py.
namespace {

using study::collapsed_at;
using study::kStands;
using study::Table;
using study::walls;
using study::with;

/// What outcomes.py says of the tables' statements.
std::string outcomes(const TempFolder& folder, const Table& table) {
  const std::string path = folder.write("table.csv", table.text()), out = folder.path("table.md");
  REQUIRE(shell::code_of(study::script("outcomes.py") + path + " >" + out) == 0);
  return shell::text_of(out);
}

void says(const std::string& text, const std::string& row) {
  CAPTURE(row);
  CAPTURE(text);
  CHECK(text.find("\n| " + row + " |") != std::string::npos);
}

Table::Values ends_at(const char* time, Table::Values values) { return with(std::move(values), {{"end_time", time}}); }

}  // namespace

TEST_CASE("statements: walls of the vaults that fall or lose bricks; undecided where a run ended before they could") {
  const TempFolder folder;
  Table table;
  table.add("vault20w", "bam-like#1", walls("0.6", "0.3"));
  table.add("vault20w", "bam-like#2", walls("0.6", "0.2"));
  table.add("vault20w", "bam-like#3", ends_at("3.0", walls("0.6", "0.2")));
  table.add("vault20r", "bam-like#1", walls("0.16", "0.0"));
  table.add("vault20r", "bam-like#2", walls("0.14", "0.2"));
  table.add("vault20r", "bam-like#3", ends_at("3.0", walls("0.14", "0.2")));
  table.add("vault40n", "bam-like#1", with(kStands, {{"right wall: fallen_mass_fraction", "0.15"}}));
  table.add("vault40n", "bam-like#2", kStands);
  table.add("vault40n", "bam-like#3", ends_at("3.0", kStands));
  const std::string text = outcomes(folder, table);
  says(text, "vault20w | TLV | both bearing walls fall (4.2) | 1 of 2 | 50 | 9 to 91 | 1");
  says(text, "vault20r | TLV | the front wall loses bricks (4.2) | 1 of 2 | 50 | 9 to 91 | 1");
  says(text, "vault40n | TLV | a side wall loses bricks (implied, 4.2) | 1 of 2 | 50 | 9 to 91 | 1");
}

TEST_CASE("statements: side walls that stay; bricks in their corners may fall with the wall next to them") {
  const TempFolder folder;
  Table table;
  table.add("flat40n", "bam-like#1", with(kStands, {{"left wall: fallen_mass_fraction", "0.12"}}));
  table.add("flat40n", "bam-like#2", with(kStands, {{"left wall: fallen_mass_fraction", "0.15"}}));
  table.add("flat40n", "bam-like#3", ends_at("3.0", kStands));
  table.add("flat40n", "bam-like#4", ends_at("3.0", walls("0.0", "0.0", "0.8")));
  says(outcomes(folder, table), "flat40n | TLV | side walls stay (implied, Figs. 20 and 21) | 1 of 3 | 33 | 6 to 79 | 1");
}

TEST_CASE("statements: a wall that leans by more than its thickness at the end falls, though it has not lost its mass") {
  const TempFolder folder;
  Table table;
  const auto leaning = [](const char* front, const char* rear) {
    return with(kStands, {{"direction", "LTV"}, {"front wall: residual_drift", front}, {"rear wall: residual_drift", rear}});
  };
  table.add("flat20n", "bam-like#1", leaning("0.084", "-0.084"));  // 0.2 m of 2.4 m are 0.0833
  table.add("flat20n", "bam-like#2", leaning("0.083", "-0.084"));
  table.add("flat20n", "bam-like#3", ends_at("3.0", leaning("0.084", "-0.084")));
  table.add("flat20n", "bam-like#4", leaning("0.084", ""));        // the rear wall has lost its top, and not its mass
  table.add("flat40n", "bam-like#1", leaning("0.166", "-0.166"));  // 0.4 m are 0.1667
  table.add("flat40n", "bam-like#2", leaning("0.168", "0.0"));
  table.add("flat40n", "bam-like#3", leaning("", "0.0"));
  table.add("flat40n", "bam-like#4", ends_at("3.0", leaning("0.168", "0.0")));
  table.add("flat40n", "bam-like#5", with(leaning("0.0", "0.0"), {{"left wall: residual_drift", "0.084"}}));
  const std::string text = outcomes(folder, table);
  says(text, "flat20n | LTV | both bearing walls fall (4.1) | 2 of 4 | 50 | 15 to 85 | 0 | –");
  says(text, "flat40n | LTV | stands (4.1) | 2 of 5 | 40 | 12 to 77 | 0 | –");
  says(text, "flat40n | LTV | side walls stay (implied, Figs. 20 and 21) | 3 of 4 | 75 | 30 to 95 | 1 | –");
}

TEST_CASE("statements: what opens before anything shakes is there however early a run ends") {
  const TempFolder folder;
  Table table;
  table.add("vault20n", "bam-like#1", with(collapsed_at(2.0, 3.0), {{"settling_cracks", "0"}}));
  table.add("vault20n", "bam-like#2", with(collapsed_at(2.0, 3.0), {{"settling_cracks", "4"}}));
  table.add("vault20n", "bam-like#3", collapsed_at(2.0, 10.0));  // of a version that does not count them
  says(outcomes(folder, table), "vault20n | TLV | nothing cracks before the motion begins (4.2) | 1 of 2 | 50 | 9 to 91 | 1");
}

TEST_CASE("statements: debris is compared where both houses collapsed, and both runs went to their end") {
  const TempFolder folder;
  Table table;
  const auto add = [&](const char* record, const Table::Values& mine, const char* area, const Table::Values& other,
                       const char* other_area) {
    table.add("flat20w", record, with(mine, {{"direction", "LTV"}, {"debris_area", area}}));
    table.add("flat20n", record, with(other, {{"direction", "LTV"}, {"debris_area", other_area}}));
  };
  const Table::Values whole = collapsed_at(5.0, 10.0), early = collapsed_at(5.0, 6.0);
  add("bam-like#1", whole, "30.0", whole, "20.0");
  add("bam-like#2", whole, "20.0", whole, "30.0");
  add("bam-like#3", early, "30.0", whole, "20.0");
  add("bam-like#4", whole, "30.0", early, "20.0");
  add("bam-like#5", kStands, "3.0", whole, "20.0");
  add("bam-like#6", whole, "30.0", kStands, "0.0");
  add("bam-like#7", whole, "30.0", whole, "");
  says(outcomes(folder, table), "flat20w | LTV | if both roofs fall, debris covers more than Flat20N's (4.4) | 1 of 2 | 50 | 9 to 91 | 5");
}
