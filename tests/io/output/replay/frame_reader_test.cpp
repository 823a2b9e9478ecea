// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/frame_reader.h"

#include <array>
#include <cmath>

#include "io/output/report/report_frames.h"
#include "io/output/results/results_parts.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;

TEST_CASE("a page shows all frames of a house, and of a street so many that 40 million places of elements are not passed by much") {
  CHECK(frames_apart(4'263, 501) == 1);
  CHECK(frames_apart(0, 0) == 1);
  for (const std::uint64_t elements : {std::uint64_t{100'000}, std::uint64_t{1'065'750}}) {
    const std::uint64_t every = frames_apart(elements, 501);
    CHECK(every > 1);
    CHECK(elements * 501 / every <= 40'000'000);
    CHECK(elements * 501 / (every - 1) > 40'000'000);
  }
}

TEST_CASE("a reader of every third frame gives the first, those, and the last, as a reader of all does") {
  const TempFolder folder;
  ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, by_hand());
  for (std::uint64_t i = 0; i < 40; ++i) record(results, i);
  results.finish();
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  const FrameReader all(run);
  REQUIRE(all.frames() > 8);
  for (const std::uint64_t every : {std::uint64_t{3}, all.frames() - 1, all.frames() + 5}) {
    CAPTURE(every);
    const FrameReader some(run, every);
    std::vector<std::uint64_t> rows;
    for (std::uint64_t row = 0; row < all.frames(); row += every) rows.push_back(row);
    if (rows.back() != all.frames() - 1) rows.push_back(all.frames() - 1);
    REQUIRE(some.frames() == rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      CHECK(some.times()[k] == all.times()[rows[k]]);
      CHECK(some.displacement(k) == all.displacement(rows[k]));
      CHECK(some.row("quaternion", k, 4) == all.row("quaternion", rows[k], 4));
    }
  }
}

/// A file as programs before schema 5 wrote it: positions in the axes of the case, no origin.
void write_old(const std::string& path) {
  const std::vector<double> start{1000.05, 0.05, 0.05, 1000.15, 0.05, 0.05}, time{0.0, 0.5};
  const std::vector<float> position{1000.05F, 0.05F, 0.05F, 1000.15F, 0.05F, 0.05F, 1000.05F, 0.05F, 0.05F, 1000.65F, 0.05F, -0.95F};
  const std::vector<float> quaternion{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, broken{0, 0, 0, 1};
  write_file(path, [&](Hdf5File& f) {
    f.write_dataset("/model/element/position0", Hdf5Type::f64, {2, 3}, start.data());
    f.write_dataset("/frames/time", Hdf5Type::f64, {2}, time.data());
    f.write_dataset("/frames/position", Hdf5Type::f32, {2, 2, 3}, position.data());
    f.write_dataset("/frames/quaternion", Hdf5Type::f32, {2, 2, 4}, quaternion.data());
    f.write_dataset("/frames/broken", Hdf5Type::f32, {2, 2}, broken.data());
  });
}

TEST_CASE("frames of files before schema 5, which hold positions, are read") {
  const TempFolder folder;
  write_old(folder.file("run.h5"));
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  CHECK(origin_of_run(run) == Vec3{});
  const FrameReader frames(run);
  REQUIRE(frames.frames() == 2);
  constexpr double kFloat = 1e-4;  // m, of coordinates of 1000 m as float32
  const std::vector<double> u = frames.displacement(1), x = frames.position(1);
  for (std::size_t i = 0; i < 6; ++i) CHECK(std::abs(u[i] - std::array{0.0, 0.0, 0.0, 0.5, 0.0, -1.0}[i]) < kFloat);
  for (std::size_t i = 0; i < 6; ++i) CHECK(x[i] == double(std::array{1000.05F, 0.05F, 0.05F, 1000.65F, 0.05F, -0.95F}[i]));
}

TEST_CASE("frames hold displacements to a micrometre, however far off the model stands") {
  const TempFolder folder;
  cases::Model m = two_cubes();
  m.origin = {9999990, -4820000, 312};
  ResultsWriter results(folder.path(), m, kCase, kNames, {}, by_hand());
  const std::array<float, 6> moved{1e-6F, 0, 0, 8.0F, -3e-6F, -1};
  results.frame({0.0, moved, std::array<float, 8>{1, 0, 0, 0, 1, 0, 0, 0}, std::array<float, 2>{}});
  results.finish();
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  CHECK(origin_of_run(run) == m.origin);
  const FrameReader frames(run);
  const std::vector<double> u = frames.displacement(0), x = frames.position(0), start = frames.start();
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(u[i] == double(moved[i]));
    CHECK(x[i] == start[i] + u[i]);  // relative to the origin
  }
}

}  // namespace
}  // namespace voussoir::io
