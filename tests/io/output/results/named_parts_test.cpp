// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <hdf5.h>

#include <fstream>
#include <sstream>

#include "io/input/files/errors.h"
#include "io/input/files/sealed_pages.h"
#include "io/output/replay/run_file.h"
#include "tests/io/results_fixture.h"

/// run.h5 names its parts with their seals.
namespace voussoir::io {
namespace {

using namespace test;
namespace fs = std::filesystem;

constexpr std::uint64_t kRows = 5;  // in a part

/// A run of three parts that has not ended.
void write_parts(const std::string& folder, std::uint64_t first = 0) {
  ResultsWriter w(folder, two_cubes(), kCase, kNames, provenance(1), by_hand());
  for (std::uint64_t i = first; i < first + 3 * kRows; ++i) {
    record(w, i);
    if (i % kRows == kRows - 1) w.flush();
  }
}

ResultsWriter go_on(const std::string& folder, double until) {
  ResultsOptions options = by_hand();
  options.earlier = EarlierRows{until, {}};
  return {folder, two_cubes(), kCase, kNames, provenance(1), options};
}

void put(const std::string& from, const std::string& to) { fs::copy_file(from, to, fs::copy_options::overwrite_existing); }

/// Makes a sealed file one of schema 5.
void unseal(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  const std::size_t contents = std::stoul(bytes.str().substr(std::string(kSealedHdf5).size()));
  std::ofstream(path, std::ios::binary) << bytes.str().substr(kSealBytes, contents);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), attribute = H5Aopen(file, "schema_version", H5P_DEFAULT);
  const std::int64_t version = kSealedSchema - 1;
  REQUIRE(H5Awrite(attribute, H5T_NATIVE_INT64, &version) >= 0);
  H5Aclose(attribute);
  if (H5Aexists(file, "part_seals") > 0) H5Adelete(file, "part_seals");
  H5Fclose(file);
}

}  // namespace

TEST_CASE("a part of another run, or of another time, is refused by readers and by a resume") {
  const TempFolder dir, other;
  write_parts(dir.path());
  write_parts(other.path(), 100);
  CHECK(check_run(dir.path()) == 4);
  const std::string second = dir.file("parts/0001.h5");
  put(second, dir.file("right.h5"));
  for (const std::string& wrong : {other.file("parts/0001.h5"), dir.file("parts/0000.h5")}) {
    put(wrong, second);
    const Hdf5File run = open_run(dir.path());
    CHECK_THROWS_WITH_AS(static_cast<void>(run.read<double>("/energy/time")), doctest::Contains("parts/0001.h5: is not the part that"),
                         FileError);
    CHECK_THROWS_WITH_AS(static_cast<void>(check_run(dir.path())), doctest::Contains("parts/0001.h5: is not the part that"), FileError);
    CHECK_THROWS_WITH_AS(go_on(dir.path(), 1e9), doctest::Contains("parts/0001.h5: is not the part that"), FileError);
  }
  put(dir.file("right.h5"), second);
  CHECK(check_rows(dir.file("run.h5")) == 3 * kRows);
}

TEST_CASE("a resume that was killed after it had cut a part can be made again") {
  const TempFolder dir;
  write_parts(dir.path());
  put(dir.file("run.h5"), dir.file("before.h5"));
  for (const std::uint64_t row : {kRows + 3, kRows + 1}) {  // the second time the part has been cut already
    const double until = time_of(row) + 1e-6;
    CHECK(go_on(dir.path(), until).rows()[0] == row + 1);
    put(dir.file("before.h5"), dir.file("run.h5"));
    CHECK_THROWS_WITH_AS(static_cast<void>(check_run(dir.path())), doctest::Contains("parts/0001.h5: is not the part that"), FileError);
  }
  CHECK(go_on(dir.path(), 1e9).rows()[0] == kRows + 2);
  CHECK(check_rows(dir.file("run.h5")) == kRows + 2);
}

TEST_CASE("of a copy without some parts the rest is read, and it says how many are missing") {
  const TempFolder dir;
  write_parts(dir.path());
  fs::remove(dir.file("parts/0001.h5"));
  const Hdf5File run = open_run(dir.path());
  CHECK(missing_parts(run) == std::vector<std::string>{"parts/0001.h5"});
  CHECK(run.read<double>("/model/element/mass").size() == 2);
  std::vector<double> rows(kRows);
  run.read_rows("/energy/time", Hdf5Type::f64, 2 * kRows, kRows, rows.data());
  CHECK(rows.back() == time_of(3 * kRows - 1));
  CHECK_THROWS_WITH_AS(static_cast<void>(run.read<double>("/energy/time")),
                       doctest::Contains("parts/0001.h5: is missing (1 of 3 parts are)"), FileError);
  CHECK_THROWS_WITH_AS(static_cast<void>(check_run(dir.path())), doctest::Contains("(1 of 3 parts are)"), FileError);
}

TEST_CASE("a resume seals parts of an earlier version, which run.h5 could not name") {
  const TempFolder dir;
  write_parts(dir.path());
  for (const char* file : {"run.h5", "parts/0000.h5", "parts/0001.h5", "parts/0002.h5"}) unseal(dir.file(file));
  CHECK(go_on(dir.path(), 1e9).rows()[0] == 3 * kRows);
  CHECK(check_run(dir.path()) == 4);
  CHECK(check_rows(dir.file("run.h5")) == 3 * kRows);
  CHECK(Hdf5File::open(dir.file("parts/0000.h5")).sealed());
}

TEST_CASE("a resume refuses parts whose times do not rise") {
  const TempFolder dir;
  write_parts(dir.path());
  for (const char* file : {"run.h5", "parts/0000.h5", "parts/0001.h5", "parts/0002.h5"}) unseal(dir.file(file));
  const hid_t file = H5Fopen(dir.file("parts/0001.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT),
              time = H5Dopen2(file, "/frames/time", H5P_DEFAULT);
  const std::vector<double> equal(kRows, 0.5);
  REQUIRE(H5Dwrite(time, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, equal.data()) >= 0);
  H5Dclose(time);
  H5Fclose(file);
  CHECK_THROWS_WITH_AS(go_on(dir.path(), 1e9), doctest::Contains("parts/0001.h5: /frames/time: row 1 holds 0.5"), FileError);
}

TEST_CASE("a part holds its rows itself") {
  const TempFolder dir;
  write_parts(dir.path());
  for (const char* file : {"run.h5", "parts/0000.h5"}) unseal(dir.file(file));
  fs::create_directory(dir.file("parts/parts"));
  put(dir.file("parts/0001.h5"), dir.file("parts/parts/0000.h5"));
  put(dir.file("run.h5"), dir.file("parts/0000.h5"));  // whose rows are in parts/parts/
  CHECK_THROWS_WITH_AS(static_cast<void>(open_run(dir.path()).read<double>("/energy/time")), doctest::Contains("not followed from a part"),
                       FileError);
}

}  // namespace voussoir::io
