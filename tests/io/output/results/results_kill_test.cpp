// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include "io/input/files/errors.h"
#include "tests/io/results_fixture.h"

/// Kills at any moment, and going on afterwards.
namespace voussoir::io {
namespace {

using namespace test;
namespace fs = std::filesystem;

ResultsWriter go_on(const std::string& folder, double until) {
  ResultsOptions options = by_hand();
  options.earlier = EarlierRows{until, {}};
  return {folder, two_cubes(), kCase, kNames, provenance(1), options};
}

/// Runs `work` in a child and kills it after a while.
template <class Work>
void kill_after(std::chrono::microseconds wait, Work work) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    try {
      work();
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  std::this_thread::sleep_for(wait);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK_FALSE((WIFEXITED(status) && WEXITSTATUS(status) == 1));
}

void write_some(const std::string& folder, std::uint64_t parts) {
  ResultsWriter w(folder, two_cubes(), kCase, kNames, provenance(1), by_hand());
  for (std::uint64_t i = 0; i < 10 * parts; ++i) {
    record(w, i);
    if (i % 10 == 9) w.flush();
  }
}

}  // namespace

TEST_CASE("after a kill at any moment run.h5 opens and holds the first rows, and a resume goes on from there") {
  std::mt19937 random(20);
  std::uint64_t most = 0;
  for (int trial = 0; trial < 20 || (most == 0 && trial < 40); ++trial) {
    const TempFolder dir;
    const int patience = trial < 20 ? 1 : 20;  // on a machine so busy that nothing was ever written
    const auto wait = patience * std::chrono::microseconds(std::uniform_int_distribution(2000, 150000)(random));
    kill_after(wait, [&] {
      ResultsWriter w(dir.path(), two_cubes(), kCase, kNames, provenance(1), by_hand());
      for (std::uint64_t i = 0;; ++i) {
        record(w, i);
        if (i % 5 == 4) w.flush();
      }
    });
    if (!fs::exists(dir.file("run.h5"))) continue;  // killed before it was there
    const std::uint64_t rows = check_rows(dir.file("run.h5"));
    CHECK(rows % 5 == 0);
    most = std::max(most, rows);
    // A part may be there that run.h5 did not learn of any more.
    ResultsWriter w = go_on(dir.path(), 1e9);
    const std::uint64_t kept = w.rows()[0];
    CHECK(kept >= rows);
    CHECK(kept <= rows + 5);
    record(w, kept);
    CHECK(w.finish());
    CHECK(check_rows(dir.file("run.h5")) == kept + 1);
    CHECK(files_in(dir.path()) == std::set<std::string>{"run.h5"});
  }
  CHECK(most > 0);
}

TEST_CASE("a kill while a run finishes loses nothing") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const TempFolder dir;
    write_some(dir.path(), 3);
    kill_after(std::chrono::microseconds(std::uniform_int_distribution(0, 60000)(random)), [&] { go_on(dir.path(), 1e9).finish(); });
    CHECK(check_rows(dir.file("run.h5")) == 30);
  }
}

TEST_CASE("parts that a kill left beside a merged file are harmless") {
  const TempFolder dir;
  const TempFolder copy;
  write_some(dir.path(), 3);
  fs::copy(dir.file("parts"), copy.file("parts"), fs::copy_options::recursive);
  CHECK(go_on(dir.path(), 1e9).finish());
  fs::copy(copy.file("parts"), dir.file("parts"), fs::copy_options::recursive);
  CHECK(check_rows(dir.file("run.h5")) == 30);
  ResultsWriter w = go_on(dir.path(), 1e9);
  CHECK(w.parts() == 1);
  record(w, 30);
  w.flush();
  CHECK(check_rows(dir.file("run.h5")) == 31);
}

TEST_CASE("a resume drops rows after its time") {
  const TempFolder dir;
  write_some(dir.path(), 4);
  std::uint64_t keep = 0;
  SUBCASE("at the end of a part") { keep = 20; }
  SUBCASE("within a part") { keep = 25; }
  SUBCASE("all") { keep = 40; }
  SUBCASE("none") { keep = 0; }
  SUBCASE("of a finished run") {
    keep = 13;
    CHECK(go_on(dir.path(), 1e9).finish());
  }
  ResultsWriter w = go_on(dir.path(), keep == 0 ? -1.0 : time_of(keep - 1));
  CHECK(check_rows(dir.file("run.h5")) == keep);
  CHECK(w.rows() == RowCounts{keep, keep, keep, keep, 2 * keep, keep});
  if (keep > 0) {
    w.energy({.time = time_of(keep - 1), .kinetic = -1});  // there already
    CHECK(w.rows()[1] == keep);
  }
  for (std::uint64_t i = keep; i < 50; ++i) record(w, i);
  w.flush();
  CHECK(check_rows(dir.file("run.h5")) == 50);
  CHECK(w.finish());
  CHECK(check_rows(dir.file("run.h5")) == 50);
}

TEST_CASE("rows that changed on disk are told before a run goes on, and at its end") {
  const TempFolder dir;
  write_some(dir.path(), 3);
  const std::string part = dir.file("parts/0001.h5");
  const auto spoil = [&part] {  // a bit of the times of row 15
    std::ifstream in(part, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const double time = time_of(15);
    const std::string mark(reinterpret_cast<const char*>(&time), sizeof time);
    std::size_t found = 0;
    for (std::size_t at = bytes.find(mark); at != std::string::npos; at = bytes.find(mark, at + 1), ++found) bytes[at] ^= 4;
    REQUIRE(found > 0);
    std::ofstream(part, std::ios::binary) << bytes;
  };
  const auto wanted = doctest::Contains("0001.h5: cannot read");
  SUBCASE("before it goes on") {
    spoil();
    CHECK_THROWS_WITH_AS(go_on(dir.path(), 1e9), wanted, FileError);
  }
  SUBCASE("while it goes on") {
    ResultsWriter w = go_on(dir.path(), 1e9);
    spoil();
    CHECK_THROWS_WITH_AS(w.finish(), wanted, FileError);
    CHECK(fs::exists(dir.file("parts/0002.h5")));
  }
}

TEST_CASE("a resume refuses results of something else") {
  const TempFolder dir;
  write_some(dir.path(), 1);
  ResultsOptions options = by_hand();
  options.earlier = EarlierRows{1e9, {}};
  const std::vector<std::string> names{"top", "elsewhere"};
  CHECK_THROWS_AS(ResultsWriter(dir.path(), two_cubes(), kCase, names, provenance(1), options), FileError);
  cases::Model one = two_cubes();
  one.blocks.pop_back();
  one.assembly.elements.pop_back();
  CHECK_THROWS_AS(ResultsWriter(dir.path(), one, kCase, kNames, provenance(1), options), FileError);
  CHECK(check_rows(dir.file("run.h5")) == 10);
}

}  // namespace voussoir::io
