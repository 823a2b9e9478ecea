// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/travel_bound.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/kernels/flying_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// \param together  elements of a batch have one bound
void check_travel(bool together) {
  CAPTURE(together);
  Flying f;
  Noise noise(11);
  for (int k = 0; k < 10; ++k) f.step();
  const std::array<std::vector<double>, 25> before = f.columns;
  const kernels::SearchedPoses at{before[0].data(), before[1].data(), before[2].data(), before[3].data(),
                                  before[4].data(), before[5].data(), before[6].data(), f.radius.data()};
  constexpr double kLimit = 2e-2, kMargin = 1e-3;  // m
  std::vector<double> safe(kCount), batch_bound(f.principal.size()), batch_safe(f.principal.size()), largest(f.principal.size());
  for (std::size_t i = 0; i < kCount; ++i) {
    double& radius = largest[i / kernels::kBatch];
    radius = std::max(radius, f.radius[i]);
  }
  std::vector<double> reach(kCount);  // some elements may go farther than others
  for (std::size_t i = 0; i < kCount; ++i) reach[i] = kLimit * (i % 7 == 0 ? 3.0 : 1.0) + kMargin;
  const std::vector<std::uint8_t> active(f.principal.size(), together ? 0 : 1);
  const kernels::TravelView travel{.at = at,
                                   .dt = kStep,
                                   .reach = reach.data(),
                                   .margin = kMargin,
                                   .element = {f.travel.data(), safe.data()},
                                   .active = active.data(),
                                   .batch = {batch_bound.data(), batch_safe.data()},
                                   .largest_radius = largest.data()};
  double most = 0.0, tightest = 1e300;
  int looks = 0, within = 0;
  for (int k = 0; k < 400; ++k) {
    f.step();
    const std::vector<double> known = together ? batch_safe : safe;
    most = kernels::advance_travel(f.view(), travel, 0, kCount);
    double plain = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) {
      const double moved = kernels::displacement_since_search(f.view(), at, static_cast<std::int64_t>(i));
      if (moved > reach[i] - kMargin) plain = std::max(plain, moved);
    }
    REQUIRE(most == doctest::Approx(plain).epsilon(1e-14));
    if (plain > 0.0) continue;
    ++within;
    looks += (together ? batch_safe : safe) != known;
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
      CHECK(moved <= kernels::displacement_since_search(f.view(), at, static_cast<std::int64_t>(i)));
      const double bound = together ? batch_bound[i / kernels::kBatch] : f.travel[i];
      CHECK(moved <= bound);
      tightest = std::min(tightest, bound / moved);
    }
  }
  CHECK(most > 5e-3);     // as far as what a search waits for
  CHECK(tightest < 1.2);  // a bound is of use where it is not far off
}

}  // namespace

TEST_CASE("no point of an element moves farther than its displacement and its travel bound say; lanes agree with the plain form") {
  check_travel(false);
  check_travel(true);
}
