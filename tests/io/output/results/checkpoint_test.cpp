// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <hdf5.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <random>
#include <thread>

#include "io/app/session/session.h"
#include "io/output/results/checkpoints.h"
#include "io/output/results/comparison.h"
#include "tests/io/bytes_of.h"
#include "tests/io/results_fixture.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

namespace voussoir::io {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// A wall that has begun to crack, ready to be saved.
struct Cracked {
  cases::Case c = testing::small_wall(2, 4);
  cases::Model m = cases::build_model(c);
  cases::GroundMotion g = testing::strong_shaking();
  solver::Simulation sim{c, m, g, {}};
  solver::RunState plan;
  testing::RowHash rows;

  Cracked() {
    g.axis[1].name = "a saw";
    g.factor = {0.75, 1.5, 2.5};
    solver::run(sim, plan, c, 1.0, rows, [](const solver::RunStatus& s) { return s.step < 1500; });
  }
  [[nodiscard]] CheckpointFacts facts() const {
    CheckpointFacts f = facts_of(sim, "title = \"wall\"\n# ä\n", g, true);
    f.supports = {{{0.0, 0.5}, {Vec3{0, 0, 0}, Vec3{0.1, 0.2, 0.3}}, true, "gone.csv", "", {Vec3{}, Vec3{0.0, 0.7, 0.0}}}};
    f.origin = {650001, -4820000, 312};
    f.time = 0.25;
    f.rows = {1, 2, 3, 4, 5, 6};
    return f;
  }
};

/// Why a checkpoint in memory is refused; empty if it is taken.
std::string refusal(std::span<const std::byte> bytes) {
  try {
    parse_checkpoint("c.h5", bytes);
  } catch (const DamagedFile& e) {
    return e.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a checkpoint is read as it was written, and HDF5's tools find the file behind its header") {
  const TempFolder dir;
  Cracked w;
  write_checkpoint(dir.file("c.h5"), w.facts(), solver::fields(w.sim, w.plan));
  const Checkpoint read = read_checkpoint(dir.file("c.h5"));
  const CheckpointFacts f = w.facts(), &g = read.facts;
  CHECK(g.case_toml == f.case_toml);
  CHECK(g.motion.axis[1].acceleration == f.motion.axis[1].acceleration);
  CHECK(g.motion.axis[1].name == "a saw");
  CHECK(g.motion.factor == std::array{0.75, 1.5, 2.5});
  CHECK(g.motion.axis[2].dt == f.motion.axis[2].dt);
  REQUIRE(g.supports.size() == 1);
  CHECK(g.supports[0].time == f.supports[0].time);
  CHECK(g.supports[0].displacement[1].z == 0.3);
  CHECK(g.supports[0].rotation == f.supports[0].rotation);
  CHECK(g.supports[0].open_ended);
  CHECK(g.origin == f.origin);
  CHECK(g.step == w.sim.dt());
  CHECK(g.reference_kernels);
  CHECK(g.program == f.program);
  CHECK(g.model_hash == solver::model_hash(w.sim.world()));
  CHECK(g.time == 0.25);
  CHECK(g.rows == f.rows);
  const solver::SavedState state = solver::save(w.sim, w.plan);
  REQUIRE(read.state.size() == state.size());
  for (const auto& entry : state) {  // clang 14 cannot capture a structured binding
    CAPTURE(entry.first);
    const solver::SavedField &field = entry.second, &other = read.state.at(entry.first);
    CHECK((other.type == field.type && other.count == field.count && other.columns == field.columns));
    CHECK(other.bytes == field.bytes);
  }
  const Hdf5File plain = Hdf5File::open(dir.file("c.h5"));
  CHECK(plain.attribute_text("/", "format") == "voussoir checkpoint");
  CHECK(plain.read<double>("/state/ux").size() == w.sim.world().elements.ux.size());
}

TEST_CASE("a checkpoint that is cut off or changed in a single bit, anywhere, is known as damaged") {
  const TempFolder dir;
  Cracked w;
  write_checkpoint(dir.file("c.h5"), w.facts(), solver::fields(w.sim, w.plan));
  const std::vector<std::byte> good = bytes_of(dir.file("c.h5"));
  REQUIRE(refusal(good) == "");
  CHECK(refusal({}).find("is empty") != std::string::npos);
  for (const std::size_t size : {std::size_t{1}, std::size_t{30}, kSealBytes - 1, kSealBytes, kSealBytes + 1, good.size() - 1}) {
    CAPTURE(size);
    CHECK(refusal(std::span(good).first(size)) != "");
  }
  std::vector<std::byte> longer = good;
  longer.push_back(std::byte{0});
  CHECK(refusal(longer).find("were written") != std::string::npos);
  std::mt19937 random(5);
  const auto spoilt = [&](std::size_t at) {
    std::vector<std::byte> bad = good;
    bad[at] ^= std::byte(1U << std::uniform_int_distribution(0, 7)(random));
    return refusal(bad) != "";
  };
  std::size_t seen = 0;
  for (std::size_t at = 0; at < kSealBytes; ++at) seen += spoilt(at) ? 1 : 0;
  for (int i = 0; i < 500; ++i) seen += spoilt(std::uniform_int_distribution<std::size_t>(kSealBytes, good.size() - 1)(random)) ? 1 : 0;
  CHECK(seen == kSealBytes + 500);
}

TEST_CASE("large fields that are zero in most places are read as they were written") {
  struct Pair {
    double a = 0.0, b = 0.0;
  };
  const TempFolder dir;
  Cracked w;
  std::vector<double> row(400'000, 0.0);
  std::vector<Pair> pairs(300'000);
  for (const std::size_t i : {std::size_t{5}, std::size_t{131'072}, std::size_t{250'001}})
    row[i] = 1.0 + static_cast<double>(i), pairs[i].b = -row[i];
  const std::vector<solver::Field> fields{{"row", "m", "element", solver::FieldType::f64, row.data(), row.size()},
                                          {.name = "b",
                                           .unit = "m",
                                           .shape = "pair",
                                           .type = solver::FieldType::f64,
                                           .data = &pairs[0].b,
                                           .count = pairs.size(),
                                           .stride = sizeof(Pair)}};
  write_checkpoint(dir.file("c.h5"), w.facts(), fields);
  const Checkpoint read = read_checkpoint(dir.file("c.h5"));
  for (const solver::Field& f : fields) CHECK(read.state.at(f.name).bytes == packed(f));
}

TEST_CASE("a damaged file on disk is known, too; one that was never sealed leaves nothing") {
  const TempFolder dir;
  Cracked w;
  const std::string path = dir.file("c.h5");
  write_checkpoint(path, w.facts(), solver::fields(w.sim, w.plan));
  CHECK(fs::file_size(path) == bytes_of(path).size());
  REQUIRE_NOTHROW(read_checkpoint(path));
  const std::vector<std::byte> good = bytes_of(path);
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    std::vector<std::byte> bad = good;
    if (i % 2 == 0) {
      bad[std::uniform_int_distribution<std::size_t>(0, bad.size() - 1)(random)] ^= std::byte{1};
    } else {
      bad.resize(std::uniform_int_distribution<std::size_t>(0, bad.size() - 1)(random));
    }
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bad.data()), static_cast<std::streamsize>(bad.size()));
    CHECK_THROWS_AS(read_checkpoint(path), DamagedFile);
  }
  { SealedFile dropped(dir.file("dropped.h5"), 1000); }
  CHECK_THROWS_AS(SealedFile(dir.file("none/c.h5"), 1000), FileError);
  CHECK(std::distance(fs::directory_iterator(dir.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("foreign files and other versions are refused by name") {
  const TempFolder dir;
  std::ofstream(dir.file("text")) << "voussoir checkpoint of somebody else\n";
  CHECK_THROWS_WITH_AS(read_checkpoint(dir.file("text")), doctest::Contains("makes no sense"), DamagedFile);
  Hdf5File::create(dir.file("foreign.h5")).close();
  CHECK_THROWS_WITH_AS(read_checkpoint(dir.file("foreign.h5")), doctest::Contains("is no voussoir checkpoint"), DamagedFile);
  CHECK_THROWS_AS(read_checkpoint(dir.path()), FileError);
  CHECK_THROWS_AS(read_checkpoint(dir.file("none")), FileError);

  const auto sealed = [&](std::int64_t version, std::int64_t physics, const char* format) {
    SealedFile file(dir.file("x.h5"), 0);
    file.contents().set_attribute("/", "format", std::string(format));
    file.contents().set_attribute("/", "physics_version", physics);
    file.seal("voussoir checkpoint", version);
    return dir.file("x.h5");
  };
  const std::int64_t physics = solver::kPhysicsVersion;
  for (const std::int64_t version : {kOldestCheckpointSchema - 1, kCheckpointSchema + 1}) {
    const std::string other = sealed(version, physics, "voussoir checkpoint");
    CHECK_THROWS_WITH_AS(read_checkpoint(other), doctest::Contains(("has version " + std::to_string(version) + " of the layout").c_str()),
                         FileError);
  }
  for (std::int64_t version = kOldestCheckpointSchema; version <= kCheckpointSchema; ++version) {  // read on, to the next fault
    const std::string other = sealed(version, physics + 1, "voussoir checkpoint");
    CHECK_THROWS_WITH_AS(read_checkpoint(other), doctest::Contains(("version " + std::to_string(physics + 1) + " of the physics").c_str()),
                         FileError);
  }
  CHECK_THROWS_AS(read_checkpoint(sealed(kCheckpointSchema, physics, "something")), DamagedFile);
  CHECK_THROWS_AS(read_checkpoint(sealed(kCheckpointSchema, physics, "voussoir checkpoint")), FileError);  // nothing else in it
}

TEST_CASE("what no run can have saved is refused, though the seal holds") {
  const TempFolder dir;
  Cracked w;
  CheckpointFacts f = w.facts();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::string why;
  SUBCASE("no step") { f.step = 0.0, why = "attribute step"; }
  SUBCASE("a step without value") { f.step = nan, why = "attribute step"; }
  SUBCASE("endless time") { f.time = -std::numeric_limits<double>::infinity(), why = "attribute time"; }
  SUBCASE("samples without a step") { f.motion.axis[1].dt = 0.0, why = "attribute dt of /motion/y"; }
  SUBCASE("a step of samples without value") { f.motion.axis[0].dt = nan, why = "attribute dt of /motion/x"; }
  SUBCASE("a sample without value") { f.motion.axis[2].acceleration[7] = nan, why = "/motion/z holds"; }
  SUBCASE("a displacement without value") { f.supports[0].displacement[1].y = nan, why = "/support/0/displacement holds"; }
  SUBCASE("a rotation without value") { f.supports[0].rotation[1].y = nan, why = "/support/0/rotation holds"; }
  SUBCASE("time that stands still") { f.supports[0].time = {0.5, 0.5}, why = "does not rise"; }
  SUBCASE("a single sample") { f.supports[0].time = {0.5}, f.supports[0].displacement = {{}}, why = "single sample"; }
  CAPTURE(why);
  write_checkpoint(dir.file("c.h5"), f, solver::fields(w.sim, w.plan));
  CHECK(refusal(bytes_of(dir.file("c.h5"))).find(why) != std::string::npos);
}

TEST_CASE("three numbers in place of one do not overflow") {
  const TempFolder dir;
  const std::string path = dir.file("three.h5");
  const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t three = 3;
  const hid_t space = H5Screate_simple(1, &three, nullptr),
              attribute = H5Acreate2(id, "step", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
  const double values[] = {1.0, 2.0, 3.0};
  REQUIRE(H5Awrite(attribute, H5T_NATIVE_DOUBLE, values) >= 0);
  H5Aclose(attribute), H5Sclose(space), H5Fclose(id);
  const Hdf5File three_numbers = Hdf5File::open(path);
  CHECK_THROWS_WITH_AS(static_cast<void>(three_numbers.attribute_double("/", "step")), doctest::Contains("step of / is not one number"),
                       FileError);
  CHECK_THROWS_WITH_AS(static_cast<void>(three_numbers.attribute_int("/", "step")), doctest::Contains("step of / is not one number"),
                       FileError);
}

TEST_CASE("the newest two checkpoints are kept; the schedule is by wall-clock, by simulated time, and before the last step") {
  const TempFolder dir;
  Cracked w;
  Checkpoints all(dir.path(), w.facts(), {.wall_clock = 1e9, .simulated = 0.1});
  solver::RunStatus s;
  CHECK(all.due(s));
  for (int i = 0; i < 4; ++i) all.save(w.sim, w.plan, {});
  CHECK(files_in(dir.path()) == std::set<std::string>{"checkpoint-000002.h5", "checkpoint-000003.h5"});
  CHECK(checkpoint_files(dir.path()).front() == dir.file("checkpoint-000003.h5"));
  s.time = w.sim.time() + 0.05;
  CHECK_FALSE(all.due(s));
  s.last = true;
  CHECK(all.due(s));
  s.last = false;
  s.time = w.sim.time() + 0.11;
  CHECK(all.due(s));
  // Numbers go on, and other files are left alone.
  std::ofstream(dir.file("checkpoint-x.h5")) << "mine";
  Checkpoints later(dir.path(), w.facts(), {.wall_clock = 0.02, .simulated = std::nullopt});
  later.save(w.sim, w.plan, {});
  CHECK(files_in(dir.path()) == std::set<std::string>{"checkpoint-000003.h5", "checkpoint-000004.h5", "checkpoint-x.h5"});
  std::this_thread::sleep_for(std::chrono::milliseconds(25));
  CHECK(later.due({}));
  later.save_failed(w.sim, w.plan, {});
  CHECK(checkpoint_files(dir.path()).size() == 2);
}

TEST_CASE("a checkpoint that cannot be written leaves the older ones") {
  const TempFolder dir;
  Cracked w;
  Checkpoints all(dir.path(), w.facts(), {});
  all.save(w.sim, w.plan, {});
  fs::create_directory(dir.file("checkpoint-000001.h5.tmp"));  // in the way
  CHECK_THROWS_AS(all.save(w.sim, w.plan, {}), FileError);
  CHECK(checkpoint_files(dir.path()).size() == 1);
  fs::remove(dir.file("checkpoint-000001.h5.tmp"));
  all.save(w.sim, w.plan, {});
  CHECK(checkpoint_files(dir.path()).size() == 2);
}

TEST_CASE("compare names the dataset, row and time in which two results part first") {
  const TempFolder dir;
  const auto write = [&](const std::string& name, auto change, std::uint64_t rows = 30) {
    fs::create_directory(dir.file(name));
    ResultsWriter w(dir.file(name), two_cubes(), kCase, kNames, provenance(1), by_hand());
    for (std::uint64_t i = 0; i < rows; ++i) {
      change(w, i);
      record(w, i);
    }
    w.finish();
    return dir.file(name) + "/run.h5";
  };
  const std::string one = write("one", [](auto&, auto) {});
  const std::string same = write("same", [](auto& w, auto i) {
    if (i % 7 == 0) w.flush();  // other parts, the same rows
  });
  CHECK(compare_files(one, same).differing == 0);
  CHECK(compare_files(one, same).datasets > 50);
  const std::string other = write("other", [](auto& w, auto i) {
    // Rows of their own times come before those of record(), which are left out as repeated.
    if (i == 20) w.energy({.time = time_of(20), .kinetic = 20, .strain = -1});
    if (i == 25) w.damage({.time = time_of(25), .bonded = -1, .first = {}});
  });
  const Comparison c = compare_files(one, other);
  REQUIRE(c.first);
  CHECK(c.first->what == "row 20");
  CHECK(c.first->dataset.find("/energy/") == 0);
  CHECK(*c.first->time == time_of(20));
  CHECK(c.differing > 5);
  const Comparison less = compare_files(one, write(
                                                 "less", [](auto&, auto) {}, 25));
  REQUIRE(less.first);
  CHECK(less.first->what == "60 rows and 50");  // of cracks, two a time
  CHECK(*less.first->time == time_of(25));
  CHECK_THROWS_AS(compare_files(one, dir.file("none.h5")), FileError);
}

}  // namespace voussoir::io
