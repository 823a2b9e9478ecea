// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/travel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/kernels/flying_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// \param together  elements of a batch have one way
void check_ways(bool together) {
  CAPTURE(together);
  Flying f;
  Noise noise(11);
  for (int k = 0; k < 10; ++k) f.step();
  const std::array<std::vector<double>, 25> before = f.columns;
  const kernels::SearchedPoses at{before[0].data(), before[1].data(), before[2].data(), before[3].data(),
                                  before[4].data(), before[5].data(), before[6].data(), f.radius.data()};
  constexpr double kLimit = 2e-2;  // m
  std::vector<double> until(kCount), batch_path(f.principal.size()), batch_until(f.principal.size()), largest(f.principal.size());
  for (std::size_t i = 0; i < kCount; ++i) {
    double& radius = largest[i / kernels::kBatch];
    radius = std::max(radius, f.radius[i]);
  }
  const std::vector<std::uint8_t> active(f.principal.size(), together ? 0 : 1);
  const kernels::Moves moves{.at = at,
                             .dt = kStep,
                             .limit = kLimit,
                             .element = {f.path.data(), until.data()},
                             .active = active.data(),
                             .batch = {batch_path.data(), batch_until.data()},
                             .largest_radius = largest.data()};
  double most = 0.0, tightest = 1e300;
  int looks = 0, within = 0;
  for (int k = 0; k < 400; ++k) {
    f.step();
    const std::vector<double> known = together ? batch_until : until;
    most = kernels::measure_moves(f.view(), moves, 0, kCount);
    double plain = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) plain = std::max(plain, kernels::move_of(f.view(), at, static_cast<std::int64_t>(i)));
    REQUIRE(most == doctest::Approx(plain > kLimit ? plain : 0.0).epsilon(1e-14));
    if (plain > kLimit) continue;
    ++within;
    looks += (together ? batch_until : until) != known;
  }
  CHECK(within > 50);
  CHECK(looks < within / 2);
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto turn = [&](const std::array<std::vector<double>, 25>& c, Vec3 arm) {
      return Vec3{c[0][i], c[1][i], c[2][i]} + rotation({c[3][i], c[4][i], c[5][i], c[6][i]}) * arm;
    };
    for (int point = 0; point < 20; ++point) {
      Vec3 arm = noise.vector(1.0);
      arm = (f.radius[i] / norm(arm)) * arm;
      const double moved = norm(turn(f.columns, arm) - turn(before, arm));
      CHECK(moved <= kernels::move_of(f.view(), at, static_cast<std::int64_t>(i)));
      const double path = together ? batch_path[i / kernels::kBatch] : f.path[i];
      CHECK(moved <= path);
      tightest = std::min(tightest, path / moved);
    }
  }
  CHECK(most > 5e-3);     // as far as what a search waits for
  CHECK(tightest < 1.2);  // a bound is of use where it is not far off
}

}  // namespace

TEST_CASE("no point of an element moves farther than what is said of its move and of its way; lanes agree with the plain form") {
  check_ways(false);
  check_ways(true);
}
