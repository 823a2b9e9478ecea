// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/frame_reader.h"

#include "io/output/report/report_frames.h"
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

}  // namespace
}  // namespace voussoir::io
