// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/moves.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "kernels/rows.h"
#include "tests/kernels/side_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr std::size_t kCount = 4 * kernels::kLanes;
constexpr double kStep = 5e-5;  // s

/// Free elements that fly and spin.
struct Flying {
  std::array<std::vector<double>, 29> columns;
  std::vector<double> radius, pose, twist, wrench, path;

  Flying()
      : pose(kCount * kernels::kPoseStride), twist(kCount * kernels::kTwistStride), wrench(kCount * kernels::kWrenchStride), path(kCount) {
    Noise noise(7);
    for (auto& c : columns) c.assign(kCount, 0.0);
    for (int c = 0; c < 29; ++c) {
      const bool moves = c < 3 || (c >= 7 && c < 16);  // m, m/s, kg m2/s, rad/s
      for (double& x : columns[static_cast<std::size_t>(c)]) x = moves ? 0.5 * noise() : 0.0;
    }
    for (std::size_t i = 0; i < kCount; ++i) {
      columns[3][i] = 1.0;
      for (const std::size_t inverse : {23U, 24U, 25U}) columns[inverse][i] = 20.0;
      radius.push_back(0.1 + 0.1 * std::abs(noise()));
    }
  }
  kernels::ElementsView view() {
    const auto c = [this](std::size_t k) { return columns[k].data(); };
    return {c(0),  c(1),  c(2),  c(3),  c(4),  c(5),  c(6),  c(7),  c(8),  c(9),  c(10), c(11), c(12), c(13), c(14),
            c(15), c(16), c(17), c(18), c(19), c(20), c(21), c(22), c(23), c(24), c(25), c(26), c(27), c(28)};
  }
  void step() { kernels::drift(view(), wrench.data(), pose.data(), twist.data(), kStep, 0, kCount); }
};

}  // namespace

TEST_CASE("no point of an element moves farther than what is said of its move and of its way; lanes agree with the plain form") {
  Flying f;
  Noise noise(11);
  for (int k = 0; k < 10; ++k) f.step();
  const std::array<std::vector<double>, 29> before = f.columns;
  const kernels::SearchedPoses at{before[0].data(), before[1].data(), before[2].data(), before[3].data(),
                                  before[4].data(), before[5].data(), before[6].data(), f.radius.data()};
  double most = 0.0, tightest = 1e300;
  for (int k = 0; k < 400; ++k) {
    f.step();
    most = kernels::measure_moves(f.view(), at, kStep, f.path.data(), 0, kCount);
    double plain = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) plain = std::max(plain, kernels::move_of(f.view(), at, static_cast<std::int64_t>(i)));
    REQUIRE(most == doctest::Approx(plain).epsilon(1e-14));
  }
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto turn = [&](const std::array<std::vector<double>, 29>& c, Vec3 arm) {
      return Vec3{c[0][i], c[1][i], c[2][i]} + rotation({c[3][i], c[4][i], c[5][i], c[6][i]}) * arm;
    };
    for (int point = 0; point < 20; ++point) {
      Vec3 arm = noise.vector(1.0);
      arm = (f.radius[i] / norm(arm)) * arm;
      const double moved = norm(turn(f.columns, arm) - turn(before, arm));
      CHECK(moved <= kernels::move_of(f.view(), at, static_cast<std::int64_t>(i)));
      CHECK(moved <= f.path[i]);
      tightest = std::min(tightest, f.path[i] / moved);
    }
  }
  CHECK(most > 5e-3);     // as far as what a search waits for
  CHECK(tightest < 1.2);  // a bound is of use where it is not far off
}
