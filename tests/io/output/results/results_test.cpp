// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <map>
#include <stdexcept>

#include "io/input/files/errors.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;
namespace fs = std::filesystem;

constexpr std::uint64_t kAnyRows = ~0ULL;

/// The interface table for two cubes and two histories: path, unit, shape (kAnyRows: as many as there are).
struct Promise {
  const char *path, *unit;
  Shape shape;
};

std::vector<Promise> promises() {
  std::vector<Promise> p{{"/model/element/material", "1", {2}},
                         {"/model/element/tag", "1", {2}},
                         {"/model/element/kind", "1", {2}},
                         {"/model/element/mass", "kg", {2}},
                         {"/model/element/inertia", "kg m2", {2, 3}},
                         {"/model/origin", "m", {3}},
                         {"/model/element/position0", "m", {2, 3}},
                         {"/model/vertex", "m", {16, 3}},
                         {"/model/cells", "1", {2, 8}},
                         {"/model/cell_type", "1", {2}},
                         {"/model/element/first_vertex", "1", {2}},
                         {"/model/face/element", "1", {12}},
                         {"/model/face/normal", "1", {12, 3}},
                         {"/model/face/distance", "m", {12}},
                         {"/model/face/area", "m2", {12}},
                         {"/model/face/first_corner", "1", {12}},
                         {"/model/face/corners", "1", {48}},
                         {"/model/joint/element_a", "1", {1}},
                         {"/model/joint/element_b", "1", {1}},
                         {"/model/joint/face_a", "1", {1}},
                         {"/model/joint/face_b", "1", {1}},
                         {"/model/joint/law", "1", {1}},
                         {"/model/joint/area", "m2", {1}},
                         {"/model/joint/centre", "m", {1, 3}},
                         {"/model/joint/normal", "1", {1, 3}},
                         {"/history/time", "s", {kAnyRows}},
                         {"/energy/time", "s", {kAnyRows}},
                         {"/energy/residual", "1", {kAnyRows}},
                         {"/forces/time", "s", {kAnyRows}},
                         {"/forces/base_shear", "N", {kAnyRows, 3}},
                         {"/forces/base_moment", "N m", {kAnyRows, 3}},
                         {"/damage/time", "s", {kAnyRows}},
                         {"/cracks/time", "s", {kAnyRows}},
                         {"/cracks/joint", "1", {kAnyRows}},
                         {"/cracks/element_a", "1", {kAnyRows}},
                         {"/cracks/element_b", "1", {kAnyRows}},
                         {"/cracks/position", "m", {kAnyRows, 3}},
                         {"/cracks/normal", "1", {kAnyRows, 3}},
                         {"/cracks/area", "m2", {kAnyRows}},
                         {"/cracks/mode", "1", {kAnyRows}},
                         {"/cracks/first_mode", "1", {kAnyRows}},
                         {"/cracks/first_time", "s", {kAnyRows}},
                         {"/frames/time", "s", {kAnyRows}},
                         {"/frames/displacement", "m", {kAnyRows, 2, 3}},
                         {"/frames/quaternion", "1", {kAnyRows, 2, 4}},
                         {"/frames/broken", "1", {kAnyRows, 2}}};
  for (const char* e : {"/energy/kinetic", "/energy/strain", "/energy/contact", "/energy/gravity", "/energy/input", "/energy/dashpot",
                        "/energy/friction", "/energy/fracture", "/energy/damping"})
    p.push_back({e, "J", {kAnyRows}});
  for (const char* d : {"/damage/bonded", "/damage/slipped", "/damage/tension", "/damage/shear", "/damage/compression",
                        "/damage/first_tension", "/damage/first_shear", "/damage/first_compression"})
    p.push_back({d, "1", {kAnyRows}});
  for (const char* h : {"/history/top/", "/history/corner 2, 50 % %s/"}) {
    static std::set<std::string> kept;  // Promise holds no text of its own
    p.push_back({kept.insert(std::string(h) + "displacement").first->c_str(), "m", {kAnyRows, 3}});
    p.push_back({kept.insert(std::string(h) + "velocity").first->c_str(), "m/s", {kAnyRows, 3}});
    p.push_back({kept.insert(std::string(h) + "rotation").first->c_str(), "rad", {kAnyRows, 3}});
  }
  return p;
}

void check_promises(const std::string& run, std::uint64_t rows) {
  const Hdf5File file = Hdf5File::open(run);
  for (const Promise& p : promises()) {
    CAPTURE(p.path);
    REQUIRE(file.exists(p.path));
    Shape shape = p.shape;
    if (shape[0] == kAnyRows) shape[0] = std::string(p.path).starts_with("/cracks/") ? 2 * rows : rows;
    CHECK(file.shape(p.path) == shape);
    CHECK(file.attribute_text(p.path, "unit") == p.unit);
    CHECK(file.attribute_text(p.path, "description").size() > 3);
    if (std::string(p.path).starts_with("/frames/") && std::string(p.path) != "/frames/time") CHECK(file.type(p.path) == Hdf5Type::f32);
  }
  CHECK(file.attribute_texts("/cracks/mode", "names") == std::vector<std::string>{"none", "tension", "shear", "compression"});
  CHECK(file.attribute_text("/case", "toml") == kCase);
}

ResultsWriter writer(const std::string& folder, const ResultsOptions& options = by_hand()) {
  return {folder, two_cubes(), kCase, kNames, provenance(3), options};
}

}  // namespace

TEST_CASE("every dataset of the interface stands in run.h5 at every stage") {
  const TempFolder dir;
  const std::string run = dir.file("run.h5");
  ResultsWriter w = writer(dir.path());
  check_promises(run, 0);
  record(w, 0);
  w.flush();
  record(w, 1);
  w.flush();
  check_promises(run, 2);
  REQUIRE(w.finish());
  check_promises(run, 2);
}

TEST_CASE("rows come back as written, through parts and after merging") {
  const TempFolder dir;
  const std::string run = dir.file("run.h5");
  ResultsWriter w = writer(dir.path());
  CHECK(check_rows(run) == 0);
  std::uint64_t row = 0;
  for (std::uint64_t part = 1; part <= 12; ++part) {
    for (std::uint64_t i = 0; i < part; ++i) record(w, row++);
    w.flush();
    CHECK(check_rows(run) == row);
  }
  w.flush();  // nothing new, no part
  CHECK(w.parts() == 12);
  record(w, row++);
  CHECK(check_rows(run) == row - 1);  // buffered
  CHECK(w.rows() == RowCounts{row, row, row, row, 2 * row, row});
  REQUIRE(w.finish());
  CHECK(check_rows(run) == row);
  CHECK(files_in(dir.path()) == std::set<std::string>{"run.h5"});
}

TEST_CASE("without merging the rows stay in parts") {
  const TempFolder dir;
  ResultsOptions options = by_hand();
  SUBCASE("off") { options.merge = false; }
  SUBCASE("too much") { options.merge_limit = 10; }
  {
    ResultsWriter w = writer(dir.path(), options);
    record(w, 0);
    CHECK_FALSE(w.finish());
  }
  CHECK(check_rows(dir.file("run.h5")) == 1);
  CHECK(files_in(dir.path()) == std::set<std::string>{"parts/0000.h5", "run.h5"});
  CHECK(Hdf5File::open(dir.file("run.h5")).attribute_int("/summary", "finished") == 1);
}

TEST_CASE("a writer that is destroyed leaves no row behind") {
  const TempFolder dir;
  {
    ResultsWriter w = writer(dir.path());
    record(w, 0);
  }
  CHECK(check_rows(dir.file("run.h5")) == 1);
}

TEST_CASE("parts are made by time and by size") {
  const TempFolder dir;
  ResultsOptions options = by_hand();
  std::size_t least = 6;  // at every call
  SUBCASE("time") {
    options.interval = 0;
    least = 1;  // the others wait for a twentieth of the run so far, which on a slow disk is longer than a call takes
  }
  SUBCASE("size") { options.bytes = 1; }
  ResultsWriter w = writer(dir.path(), options);
  record(w, 0);
  CHECK(w.parts() >= least);
  CHECK(w.parts() <= 6);
  CHECK(check_rows(dir.file("run.h5")) == 1);
}

TEST_CASE("a folder of results can be moved") {
  const TempFolder dir;
  fs::create_directory(dir.file("a"));
  ResultsWriter w = writer(dir.file("a"));
  record(w, 0);
  w.flush();
  fs::rename(dir.file("a"), dir.file("b"));
  CHECK(check_rows(dir.file("b/run.h5")) == 1);
  fs::rename(dir.file("b"), dir.file("a"));
}

TEST_CASE("a part that is lost is an error, not rows of fill values") {
  const TempFolder dir;
  ResultsWriter w = writer(dir.path());
  record(w, 0);
  w.flush();
  fs::remove(dir.file("parts/0000.h5"));
  const Hdf5File file = Hdf5File::open(dir.file("run.h5"));
  CHECK_THROWS_WITH_AS(static_cast<void>(file.read<double>("/history/top/displacement")), doctest::Contains("0000.h5: is missing"),
                       FileError);
  CHECK_THROWS_AS(static_cast<void>(file.read<float>("/frames/displacement")), FileError);
  CHECK_THROWS_AS(static_cast<void>(file.read<std::int64_t>("/damage/bonded")), FileError);
}

TEST_CASE("rows keep their order in time and are not doubled") {
  const TempFolder dir;
  ResultsWriter w = writer(dir.path());
  w.energy({.time = 1.0, .kinetic = 5});
  w.energy({.time = 1.0, .kinetic = 6});
  w.flush();
  w.energy({.time = 1.0, .kinetic = 7});
  CHECK_THROWS_AS(w.energy({.time = 0.5}), std::logic_error);
  w.flush();
  CHECK(Hdf5File::open(dir.file("run.h5")).read<double>("/energy/kinetic") == std::vector<double>{5});
  CHECK_THROWS_AS(w.history(2.0, {}), std::logic_error);
  CHECK_THROWS_AS(w.frame({}), std::logic_error);
  w.finish();
  CHECK_THROWS_AS(w.energy({.time = 3.0}), std::logic_error);
}

TEST_CASE("histories need names of their own") {
  const auto with = [](std::vector<std::string> names) {
    const TempFolder dir;
    ResultsWriter(dir.path(), two_cubes(), kCase, names, provenance(1));
  };
  for (const std::string bad : {"", "time", "a/b", ".", "..", "a\nb"}) CHECK_THROWS_AS(with({bad}), std::invalid_argument);
  CHECK_THROWS_WITH_AS(with({"a", "b", "a"}), "history \"a\": the name is given twice", std::invalid_argument);
  CHECK_NOTHROW(with({}));
}

TEST_CASE("results of another run are not written over") {
  const TempFolder dir;
  { ResultsWriter w = writer(dir.path()); }
  CHECK_THROWS_AS(writer(dir.path()), FileError);
}

TEST_CASE("summary, provenance and a long case") {
  const TempFolder dir;
  const std::string long_case(300000, 'x');
  ResultsWriter w(dir.path(), two_cubes(), long_case, kNames, provenance(3), by_hand());
  CHECK(Hdf5File::open(dir.file("run.h5")).attribute_int("/summary", "finished") == 0);
  solver::Summary s;
  s.collapsed = true;
  s.fallen_mass_fraction = 0.75;
  s.first_crack_time = 1.5;
  s.tension = 10, s.shear = 20, s.compression = 30, s.slipped = 40;
  s.first = {11, 87, 2};
  s.peak_base_shear = 1e5, s.peak_speed = 4, s.worst_residual = 1e-7, s.end_time = 10;
  w.summary(s);
  w.state_hash(0xabcdef);
  w.finish();
  const Hdf5File file = Hdf5File::open(dir.file("run.h5"));
  CHECK(file.attribute_text("/summary", "state_hash") == "0000000000abcdef");
  CHECK(file.attribute_text("/case", "toml") == long_case);
  const std::map<std::string, double> expected{{"collapsed", 1},
                                               {"settled", 1},
                                               {"fallen_mass_fraction", 0.75},
                                               {"first_crack_time", 1.5},
                                               {"tension", 10},
                                               {"shear", 20},
                                               {"compression", 30},
                                               {"slipped", 40},
                                               {"first_tension", 11},
                                               {"first_shear", 87},
                                               {"first_compression", 2},
                                               {"peak_speed", 4},
                                               {"peak_base_shear", 1e5},
                                               {"worst_residual", 1e-7},
                                               {"end_time", 10},
                                               {"finished", 1}};
  for (const auto& entry : expected) CHECK_MESSAGE(file.attribute_double("/summary", entry.first) == entry.second, entry.first);
  CHECK(file.attribute_int("/provenance", "threads") == 3);
  CHECK(file.attribute_text("/provenance", "started").size() == 20);
  CHECK(file.attribute_text("/provenance", "ended") >= file.attribute_text("/provenance", "started"));
  CHECK(file.attribute_double("/provenance", "wall_clock") > 0);
  for (const char* name : {"version", "compiler", "flags", "cpu"}) {
    CHECK(file.attribute_text("/provenance", name) != "");
    if (std::string(name) != "cpu") CHECK(file.attribute_text("/provenance", name).find('/') == std::string::npos);
  }
}

TEST_CASE("provenance keeps no paths") {
  CHECK(without_paths("-O3  -I/home/someone/x -march=native -fmap=a/b=.") == "-O3 -march=native");
  CHECK(utc_now().back() == 'Z');
}

TEST_CASE("a failed write is told with its path and leaves what was there") {
  const TempFolder dir;
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 1;
    try {
      ResultsWriter w = writer(dir.path());
      for (std::uint64_t i = 0; i < 10; ++i) record(w, i);
      w.flush();
      for (std::uint64_t i = 10; i < 20000; ++i) record(w, i);
      // No file may grow above 64 kB: the system says so like a full disk.
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{65536, 65536};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      try {
        w.flush();
      } catch (const FileError& e) {
        const std::string what = e.what();
        code = what.find("parts/0001.h5") != std::string::npos && what.find("File too large") != std::string::npos ? 0 : 2;
      }
    } catch (...) {
      code = 3;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(check_rows(dir.file("run.h5")) == 10);
  CHECK(files_in(dir.path()) == std::set<std::string>{"parts/0000.h5", "run.h5"});
}

TEST_CASE("a list of no texts is an attribute too") {
  const TempFolder dir;
  Hdf5File file = Hdf5File::create(dir.file("a.h5"));
  file.set_attribute("/", "names", std::vector<std::string>{"a", "b"});
  file.set_attribute("/", "names", std::vector<std::string>{});
  CHECK(file.attribute_texts("/", "names").empty());
}

TEST_CASE("a file that is no HDF5, or lacks an object, is an error that says so") {
  const TempFolder dir;
  CHECK_THROWS_AS(Hdf5File::open(dir.file("none.h5")), FileError);
  Hdf5File file = Hdf5File::create(dir.file("a.h5"));
  CHECK_THROWS_WITH_AS(static_cast<void>(file.shape("/nothing/here")), doctest::Contains("/nothing/here"), FileError);
  CHECK_THROWS_WITH_AS(Hdf5File::create(dir.file("no/b.h5")), doctest::Contains("No such file or directory"), FileError);
}

}  // namespace voussoir::io
