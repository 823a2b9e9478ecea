// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "io/output/results/comparison.h"
#include "tests/io/results_fixture.h"

// Where two results part, and how much of them: of runs that differ from the first row on, have other lengths or other intervals.

namespace voussoir::io {
namespace {

using namespace test;

struct Made {
  std::uint64_t first = 0, rows = 30, every = 1;
  bool other_energy = false;  // from its first row on
  std::string toml = kCase;
};

std::string make(const TempFolder& dir, const std::string& name, const Made& how) {
  std::filesystem::create_directory(dir.file(name));
  ResultsWriter w(dir.file(name), two_cubes(), how.toml, kNames, provenance(1), by_hand());
  for (std::uint64_t i = how.first; i < how.rows; i += how.every) {
    if (how.other_energy) w.energy({.time = time_of(i), .kinetic = -1.0, .strain = 2.0 * static_cast<double>(i)});
    record(w, i);
  }
  w.finish();
  return dir.file(name) + "/run.h5";
}

}  // namespace

TEST_CASE("compare counts datasets and attributes apart: never more that differ than there are") {
  const TempFolder dir;
  const Comparison c = compare_files(make(dir, "one", {}), make(dir, "other", {.first = 1, .rows = 20, .toml = "title = \"else\"\n"}));
  CHECK(c.differing_datasets <= c.datasets);
  CHECK(c.differing_attributes > 0);
  CHECK(c.differing == c.differing_datasets + c.differing_attributes);
  REQUIRE(c.input);
  CHECK(c.input->dataset == "/case");
  CHECK(c.input->what == "attribute toml");
}

TEST_CASE("runs that differ from their first row on part there, though one is shorter than the other") {
  const TempFolder dir;
  const Comparison c = compare_files(make(dir, "one", {}), make(dir, "other", {.rows = 20, .other_energy = true}));
  REQUIRE(c.first);
  CHECK(c.first->dataset.starts_with("/energy/"));
  CHECK(c.first->what == "row 0");
  REQUIRE(c.first->time);
  CHECK(*c.first->time == time_of(0));
  CHECK_FALSE(c.input);
}

TEST_CASE("where two runs wrote at other intervals, rows of one time are compared") {
  const TempFolder dir;
  const std::string fine = make(dir, "fine", {}), coarse = make(dir, "coarse", {.every = 3}),
                    shifted = make(dir, "shifted", {.first = 1, .every = 2});
  const Comparison c = compare_files(fine, coarse);
  // The datasets of the times differ, and the rows of cracks, which are events; all else is the same where both have a row.
  REQUIRE(c.first);
  CHECK(c.first->dataset.starts_with("/cracks/"));
  CHECK(c.differing_datasets <= 5 + 10);
  const Comparison d = compare_files(fine, make(dir, "other", {.every = 3, .other_energy = true}));
  REQUIRE(d.first);
  CHECK(d.first->dataset.starts_with("/energy/"));
  CHECK(d.first->what == "row 0");
  const Comparison e = compare_files(coarse, shifted);  // rows 0, 3, ... of one are at the times 3, 9, ... of the other
  REQUIRE(e.first);
  CHECK(e.differing_datasets <= 5 + 10);
  const Comparison f = compare_files(shifted, make(dir, "more", {.first = 3, .every = 3, .other_energy = true}));
  REQUIRE(f.first);
  CHECK(f.differing_datasets > e.differing_datasets);
}

}  // namespace voussoir::io
