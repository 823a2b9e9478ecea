// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "kernels/integrate.h"
#include "kernels/rows.h"
#include "tests/kernels/side_fixture.h"

namespace voussoir::testing {

inline constexpr std::size_t kCount = 3 * kernels::kBatch;
inline constexpr double kStep = 5e-5;  // s

/// Free elements that fly and spin.
struct Flying {
  std::array<std::vector<double>, 25> columns;
  std::vector<double> tally, radius, pose, twist, wrench, dashpot, travel;
  std::vector<std::uint8_t> principal;

  Flying()
      : tally(kCount / kernels::kBatch * kernels::kTallies),
        pose(kCount * kernels::kPoseStride),
        twist(kCount * kernels::kTwistStride),
        wrench(kCount * kernels::kWrenchStride),
        dashpot(kCount * kernels::kDashpotStride),
        travel(kCount),
        principal(kCount / kernels::kBatch, 1) {
    Noise noise(7);
    for (auto& c : columns) c.assign(kCount, 0.0);
    for (int c = 0; c < 25; ++c) {
      const bool moves = c < 3 || (c >= 7 && c < 16);  // m, m/s, kg m2/s, rad/s
      for (double& x : columns[static_cast<std::size_t>(c)]) x = moves ? 0.5 * noise() : 0.0;
    }
    for (std::size_t i = 0; i < kCount; ++i) {
      columns[3][i] = 1.0;
      for (const std::size_t inverse : {19U, 20U, 21U}) columns[inverse][i] = 20.0;
      radius.push_back(0.1 + 0.1 * std::abs(noise()));
    }
  }
  kernels::ElementsView view() {
    const auto c = [this](std::size_t k) { return columns[k].data(); };
    return {c(0),  c(1),  c(2),         c(3),  c(4),  c(5),  c(6),  c(7),  c(8),  c(9),  c(10), c(11), c(12),           c(13),
            c(14), c(15), tally.data(), c(16), c(16), c(17), c(18), c(19), c(20), c(21), c(22), c(23), c(24), principal.data()};
  }
  kernels::ElementRows rows() { return {pose.data(), twist.data(), wrench.data(), dashpot.data()}; }
  void step() { kernels::drift(view(), rows(), kStep, 0, kCount); }
};

}  // namespace voussoir::testing
