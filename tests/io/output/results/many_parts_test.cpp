// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <numeric>
#include <random>
#include <thread>

#include "io/input/files/errors.h"
#include "io/output/replay/run_file.h"
#include "tests/io/results_fixture.h"

/// A run that goes on for days: parts become one where they are many.
namespace voussoir::io {
namespace {

using namespace test;
namespace fs = std::filesystem;

ResultsOptions few_parts(std::size_t most) {
  ResultsOptions options = by_hand();
  options.most_parts = most;
  return options;
}

ResultsWriter writer(const std::string& folder, std::size_t most) {
  return {folder, two_cubes(), kCase, kNames, provenance(1), few_parts(most)};
}

ResultsWriter go_on(const std::string& folder, double until, std::size_t most) {
  ResultsOptions options = few_parts(most);
  options.earlier = EarlierRows{until, {}};
  return {folder, two_cubes(), kCase, kNames, provenance(1), options};
}

/// Rows, each with a part of its own.
void write_rows(ResultsWriter& w, std::uint64_t first, std::uint64_t end) {
  for (std::uint64_t i = first; i < end; ++i) {
    record(w, i);
    w.flush();
  }
}

/// Resident memory of this process, MB.
double memory() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

std::size_t parts_in(const std::string& folder) { return files_in(folder).size() - 1; }  // beside run.h5

}  // namespace

TEST_CASE("a run with hundreds of checkpoints has few parts, a small run.h5 and no more memory than at first") {
  constexpr std::size_t kMost = 16;
  const TempFolder dir;
  ResultsWriter w = writer(dir.path(), kMost);
  std::size_t parts = 0, files = 0;
  std::uintmax_t run = 0;
  const auto most_after = [&](std::uint64_t first, std::uint64_t end) {
    parts = files = run = 0;
    for (std::uint64_t row = first; row < end; ++row) {
      write_rows(w, row, row + 1);
      parts = std::max(parts, w.parts());
      files = std::max(files, parts_in(dir.path()));
      run = std::max(run, fs::file_size(dir.file("run.h5")));
    }
  };
  most_after(0, 40);
  const double memory_at_first = memory();
  const auto run_at_first = run;
  most_after(40, 240);
  CHECK(parts <= kMost);
  CHECK(files <= 2 * kMost + 2);
  CHECK(run <= run_at_first + 4096);
  CHECK(memory() < memory_at_first + 8);  // 200 parts take 60 MB where they stay
  CHECK(check_rows(dir.file("run.h5")) == 240);
  CHECK(check_run(dir.path()) == w.parts() + 1);
  CHECK(w.finish());
  CHECK(check_rows(dir.file("run.h5")) == 240);
  CHECK(files_in(dir.path()) == std::set<std::string>{"run.h5"});
}

TEST_CASE("which parts become one: few bytes for many parts, so that rows are seldom copied") {
  const RowSchema schema = row_schema(kNames, 2, {}, 0);
  const auto of_rows = [](const std::vector<std::uint64_t>& rows) {
    std::vector<Part> parts;
    for (const std::uint64_t n : rows) parts.emplace_back().rows[0] = n;
    return parts;
  };
  const std::uint64_t row = row_bytes(schema, of_rows({1})[0]);
  CHECK(row == 8 + 2 * 9 * 8);
  const auto chosen = [&](const std::vector<std::uint64_t>& rows, std::uint64_t limit = 1000000) {
    const std::optional<PartRange> r = parts_to_merge(schema, of_rows(rows), limit * row);
    return r ? std::pair(r->first, r->count) : std::pair<std::size_t, std::size_t>(0, 0);
  };
  using Range = std::pair<std::size_t, std::size_t>;
  CHECK(chosen({1, 1, 1}) == Range(0, 3));
  CHECK(chosen({90, 2, 1, 1, 30}) == Range(1, 3));
  CHECK(chosen({8, 8, 8, 8, 1, 1}) == Range(0, 6));
  CHECK(chosen({90, 90, 90, 1, 1}) == Range(3, 2));
  CHECK(chosen({1, 1, 1}, 2) == Range(0, 2));
  CHECK(chosen({2, 2, 2}, 3) == Range(0, 0));
  CHECK(chosen({1}) == Range(0, 0));

  std::vector<std::uint64_t> rows;
  std::uint64_t copied = 0;
  constexpr std::uint64_t kRows = 5000;  // each a part
  for (std::uint64_t i = 0; i < kRows; ++i) {
    rows.push_back(1);
    if (rows.size() <= 64) continue;
    const auto [first, count] = chosen(rows);
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(first), to = from + static_cast<std::ptrdiff_t>(count);
    const std::uint64_t sum = std::accumulate(from, to, std::uint64_t{0});
    copied += sum;
    *from = sum;
    rows.erase(from + 1, to);
  }
  CHECK(copied < 2 * kRows);
}

TEST_CASE("readers of a run.h5 whose parts have become one can end; the files are gone with the next part, and at the end") {
  const TempFolder dir;
  {
    ResultsWriter w = writer(dir.path(), 4);
    write_rows(w, 0, 4);
    fs::copy_file(dir.file("run.h5"), dir.file("before.h5"));
    write_rows(w, 4, 5);
    CHECK(w.parts() == 1);
    CHECK(fs::exists(dir.file("parts/0000.h5")));
    CHECK(check_rows(dir.file("before.h5")) == 4);
    write_rows(w, 5, 6);
    CHECK_FALSE(fs::exists(dir.file("parts/0000.h5")));
    CHECK_THROWS_WITH_AS(check_rows(dir.file("before.h5")), doctest::Contains("parts/0000.h5: is missing (4 of 4 parts are)"), FileError);
    fs::remove(dir.file("before.h5"));
    write_rows(w, 6, 9);
    CHECK(w.parts() < 4);
    CHECK(parts_in(dir.path()) > w.parts());
  }
  CHECK(check_rows(dir.file("run.h5")) == 9);
  CHECK(check_run(dir.path()) == parts_in(dir.path()) + 1);
}

TEST_CASE("a resume goes on from parts that have become one, also within one, and removes those that a kill has left") {
  const TempFolder dir, left;
  {
    ResultsWriter w = writer(dir.path(), 4);
    write_rows(w, 0, 4);
    fs::copy(dir.file("parts"), left.file("parts"));
    write_rows(w, 4, 12);
  }
  fs::copy(left.file("parts"), dir.file("parts"), fs::copy_options::skip_existing);
  std::uint64_t keep = 12;
  SUBCASE("all of it") {}
  SUBCASE("within a part of several") { keep = 2; }
  ResultsWriter w = go_on(dir.path(), time_of(keep - 1), 4);
  CHECK(w.rows()[0] == keep);
  CHECK(parts_in(dir.path()) == w.parts());
  CHECK(check_rows(dir.file("run.h5")) == keep);
  write_rows(w, keep, 30);
  CHECK(w.parts() <= 4);
  CHECK(check_rows(dir.file("run.h5")) == 30);
  CHECK(w.finish());
  CHECK(check_rows(dir.file("run.h5")) == 30);
}

TEST_CASE("a run goes on with many parts where none can be written in their place") {
  const TempFolder dir;
  ResultsWriter w = writer(dir.path(), 6);
  write_rows(w, 0, 6);
  fs::create_directories(dir.file("parts/0007.h5.tmp/busy"));  // what would become of the first seven
  write_rows(w, 6, 7);
  CHECK(w.parts() == 7);
  CHECK(check_rows(dir.file("run.h5")) == 7);
  fs::remove_all(dir.file("parts/0007.h5.tmp"));
  write_rows(w, 7, 20);
  CHECK(w.parts() <= 6);
  CHECK(check_rows(dir.file("run.h5")) == 20);
}

TEST_CASE("after a kill while parts become one, run.h5 opens and holds the first rows, and a resume goes on from there") {
  std::mt19937 random(66);
  std::uint64_t most = 0;
  for (int trial = 0; trial < 15 || (most < 10 && trial < 40); ++trial) {
    const TempFolder dir;
    const int patience = trial < 15 ? 1 : 20;  // on a machine so busy that nothing was ever written
    const auto wait = patience * std::chrono::microseconds(std::uniform_int_distribution(2000, 300000)(random));
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      ResultsWriter w = writer(dir.path(), 2);  // at every second part
      write_rows(w, 0, 1000000);
      ::_exit(0);
    }
    std::this_thread::sleep_for(wait);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    if (!fs::exists(dir.file("run.h5"))) continue;  // killed before it was there
    const std::uint64_t rows = check_rows(dir.file("run.h5"));
    CHECK(check_run(dir.path()) > 0);
    most = std::max(most, rows);
    ResultsWriter w = go_on(dir.path(), 1e9, 2);
    REQUIRE(w.rows()[0] == rows);
    write_rows(w, rows, rows + 3);
    CHECK(w.finish());
    CHECK(check_rows(dir.file("run.h5")) == rows + 3);
    CHECK(files_in(dir.path()) == std::set<std::string>{"run.h5"});
  }
  CHECK(most >= 10);
}

}  // namespace voussoir::io
