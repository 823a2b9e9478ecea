// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "io/input/files/errors.h"
#include "io/input/files/sealed_pages.h"
#include "io/output/replay/run_file.h"
#include "tests/io/results_fixture.h"

/// Results that cannot lie: damage to what is read is an error.
namespace voussoir::io {
namespace {

using test::TempFolder;

std::string contents_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

const std::vector<double> kValues{1.0, 2.0, 3.0};

/// A file with a dataset of two pages and a bit, and a text.
std::string sealed(const TempFolder& dir, std::int64_t schema = 6, bool seal = true) {
  const std::string path = dir.file("run.h5");
  Hdf5File file = Hdf5File::create(path, seal ? kSealBytes : 0);
  file.set_attribute("/", "schema_version", schema);
  file.write_dataset("/values", Hdf5Type::f64, {3}, kValues.data(), {}, {"m", "three numbers"});
  file.write_dataset("/many", Hdf5Type::f64, {1200}, std::vector<double>(1200, 0.5).data());
  file.write_strings("/texts", std::vector<std::string>{"one", "two"});
  file.close();
  if (seal) seal_pages(path);
  return path;
}

void read_all(const std::string& path) {
  const Hdf5File run = open_run(path);
  for (const char* name : {"/values", "/many"}) static_cast<void>(run.read<double>(name));
  static_cast<void>(run.read_strings("/texts"));
  static_cast<void>(run.attribute_text("/values", "description"));
}

}  // namespace

TEST_CASE("no damaged byte changes what is read from a sealed file") {
  const TempFolder dir;
  const std::string path = sealed(dir), right = contents_of(path);
  CHECK(open_run(path).read<double>("/values") == kValues);
  CHECK(check_run(path) == 1);
  std::size_t refused = 0;
  for (std::size_t at = 0; at < right.size(); at += at < 2048 ? 1 : 61) {
    std::string wrong = right;
    wrong[at] = static_cast<char>(wrong[at] ^ 0x10);
    write(path, wrong);
    CHECK_THROWS_AS(static_cast<void>(check_run(path)), FileError);
    try {
      const Hdf5File run = open_run(path);
      // Read first, since CHECK catches what they throw.
      const bool exists = run.exists("/values"), noted = run.has_attribute("/values", "unit");
      const std::vector<double> values = run.read<double>("/values");
      const std::vector<std::string> texts = run.read_strings("/texts");
      CHECK(exists);
      CHECK(noted);
      CHECK(values == kValues);
      CHECK(texts == std::vector<std::string>{"one", "two"});
    } catch (const DamagedFile&) {
      ++refused;
    }
  }
  CHECK(refused > 1000);
}

// HDF5 1.10 crashes if a read fails while it lists a group of many links or an object of many attributes.
TEST_CASE("lists of a file with a damaged page are refused") {
  const TempFolder dir;
  const std::string path = dir.file("run.h5");
  Hdf5File file = Hdf5File::create(path, kSealBytes);
  file.set_attribute("/", "schema_version", std::int64_t{6});
  for (int k = 0; k < 100; ++k) {
    file.write_dataset("/group/number " + std::to_string(k), Hdf5Type::f64, {3}, kValues.data());
    file.set_attribute("/group", "a note of some length, number " + std::to_string(k), std::int64_t{k});
  }
  file.close();
  seal_pages(path);
  const std::string right = contents_of(path);
  CHECK(open_run(path).datasets().size() == 100);
  for (std::size_t at = kSealBytes; at + 4096 < right.size(); at += 4096) {
    std::string wrong = right;
    wrong[at + 100] = static_cast<char>(wrong[at + 100] ^ 0x10);
    write(path, wrong);
    const auto refuses = [&](auto&& list) {
      try {
        list(open_run(path));
        return false;
      } catch (const DamagedFile&) {
        return true;
      }
    };
    CHECK(refuses([](const Hdf5File& run) { return run.datasets(); }));
    CHECK(refuses([](const Hdf5File& run) { return run.children("/group"); }));
    CHECK(refuses([](const Hdf5File& run) { return run.attributes("/group"); }));
  }
}

TEST_CASE("a fault names file and dataset; what is not read is not checked") {
  const TempFolder dir;
  const std::string path = sealed(dir);
  std::string bytes = contents_of(path);
  const double half = 0.5;
  const std::size_t last = bytes.rfind(std::string(reinterpret_cast<const char*>(&half), sizeof half));
  REQUIRE(last != std::string::npos);
  bytes[last] = 1;
  write(path, bytes);
  CHECK_THROWS_WITH_AS(read_all(path), doctest::Contains("run.h5: cannot read /many: is damaged: bytes"), DamagedFile);
  CHECK_THROWS_WITH_AS(static_cast<void>(check_run(path)), doctest::Contains("is damaged"), DamagedFile);
}

TEST_CASE("truncated, longer, without its seal, of a later schema, of an early one") {
  const TempFolder dir;
  const std::string path = sealed(dir), right = contents_of(path);
  for (const std::string& wrong : {right.substr(0, right.size() - 1), right + "x", right.substr(0, 100), std::string()}) {
    write(path, wrong);
    CHECK_THROWS_AS(read_all(path), DamagedFile);
  }
  sealed(dir, 6, false);
  CHECK_THROWS_WITH_AS(read_all(path), doctest::Contains("lost its seal"), FileError);
  sealed(dir, 7);
  CHECK_THROWS_WITH_AS(read_all(path), doctest::Contains("a later program wrote it"), FileError);
  for (const std::int64_t early : {3, 1, 0, -1}) {
    sealed(dir, early, false);
    CHECK_THROWS_WITH_AS(read_all(path), doctest::Contains("this program reads from 4 on"), FileError);
  }
  sealed(dir, 5, false);
  CHECK_NOTHROW(read_all(path));
}

TEST_CASE("a pipe in place of run.h5 is refused at once") {
  const TempFolder dir;
  REQUIRE(::mkfifo(dir.file("run.h5").c_str(), 0600) == 0);
  CHECK_THROWS_WITH_AS(static_cast<void>(open_run(dir.path())), doctest::Contains("is no regular file"), FileError);
}

TEST_CASE("rows are taken from parts of the same folder alone") {
  for (const std::string other : {"/etc/passwd", "../parts/0000.h5", "parts/../0000.h5", "run.h5", "."}) {
    const TempFolder dir;
    const std::string path = dir.file("run.h5");
    Hdf5File file = Hdf5File::create(path);
    file.set_attribute("/", "schema_version", std::int64_t{5});
    file.create_virtual("/rows", Hdf5Type::f64, {}, std::vector<VirtualSource>{{other, "/rows", 2, 2}});
    file.close();
    CHECK_THROWS_WITH_AS(static_cast<void>(open_run(path).read<double>("/rows")), doctest::Contains("only parts/NNNN.h5"), FileError);
  }
}

TEST_CASE("rows of a part that are wider than the run's are refused, whatever reads them") {
  const TempFolder dir;
  std::filesystem::create_directory(dir.file("parts"));
  const std::vector<double> wide(8, 1.0);
  for (const char* name : {"parts/0000.h5", "run.h5"}) {
    Hdf5File file = Hdf5File::create(dir.file(name));
    file.set_attribute("/", "schema_version", std::int64_t{6});
    if (std::string(name) == "run.h5")
      file.create_virtual("/rows", Hdf5Type::f64, {2}, std::vector<VirtualSource>{{"parts/0000.h5", "/rows", 2, 2}});
    else
      file.write_dataset("/rows", Hdf5Type::f64, {2, 4}, wide.data(), {}, {});
    file.close();
  }
  const Hdf5File run = Hdf5File::open(dir.file("run.h5"));
  CHECK_THROWS_WITH_AS(static_cast<void>(run.read<double>("/rows")), doctest::Contains("has not the rows that"), FileError);
  std::vector<double> rows(8);  // room for what would be read
  CHECK_THROWS_WITH_AS(run.read_rows("/rows", Hdf5Type::f64, 0, 2, rows.data()), doctest::Contains("has not the rows that"), FileError);
  CHECK(rows == std::vector<double>(8, 0.0));
}

TEST_CASE("check reads the parts of a run that goes on") {
  const TempFolder dir;
  ResultsWriter w(dir.path(), test::two_cubes(), test::kCase, test::kNames, {});
  for (std::uint64_t i = 0; i < 3; ++i) test::record(w, i);
  w.flush();
  CHECK(check_run(dir.path()) == 2);
  std::string part = contents_of(dir.file("parts/0000.h5"));
  part[part.size() / 2] = static_cast<char>(part[part.size() / 2] ^ 1);
  write(dir.file("parts/0000.h5"), part);
  CHECK_THROWS_WITH_AS(static_cast<void>(check_run(dir.path())), doctest::Contains("0000.h5"), DamagedFile);
}

}  // namespace voussoir::io
