// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/joint_openings.h"

#include "io/input/files/hdf5_file.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;

TEST_CASE("a joint is open when the springs of half of it are broken, those of one face or of both") {
  const TempFolder folder;
  const cases::Model m = two_cubes();
  ResultsWriter results(folder.path(), m, kCase, kNames, {}, by_hand());
  const auto crack = [&](double time, std::int32_t from, double share) {
    solver::CrackRow row;
    row.time = time, row.joint = 0, row.element_a = from, row.element_b = 1 - from, row.area = share * m.assembly.joints[0].area;
    results.cracks(std::array{row});
  };
  crack(0.1, 0, 0.25);
  crack(0.2, 1, 0.125);
  crack(0.3, 1, 0.125);
  results.finish();
  CHECK(joint_opening_times(Hdf5File::open(folder.file("run.h5"))).at(0) == 0.3);
}

}  // namespace
}  // namespace voussoir::io
