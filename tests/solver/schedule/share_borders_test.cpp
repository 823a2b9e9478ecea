// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/schedule/share_borders.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using voussoir::solver::ShareBorders;

namespace {

constexpr int kLook = 64;  // steps, at most, until borders move

/// So many steps in which a share takes as long as it is, times the cost of its thread.
void go_on(ShareBorders& b, int steps, const std::vector<double>& costs) {
  for (int step = 0; step < steps; ++step) {
    std::vector<double> times;
    double first = 0.0;
    for (std::size_t k = 0; k < costs.size(); ++k) {
      times.push_back(1e-4 * costs[k] * (b.ends()[k] - first));
      first = b.ends()[k];
    }
    b.note(times);
  }
}

}  // namespace

TEST_CASE("shares are alike at first, and end where the last task does") {
  const ShareBorders b(4);
  CHECK(std::vector<double>(b.ends().begin(), b.ends().end()) == std::vector<double>{0.25, 0.5, 0.75, 1.0});
  CHECK(ShareBorders(1).ends()[0] == 1.0);
}

TEST_CASE("shares follow what they take, until all take the same") {
  ShareBorders b(3);
  go_on(b, 40 * kLook, {1.0, 2.0, 5.0});
  const double sum = 1.0 + 1.0 / 2.0 + 1.0 / 5.0;
  CHECK(std::abs(b.ends()[0] - 1.0 / sum) < 0.02);
  CHECK(std::abs(b.ends()[1] - 1.5 / sum) < 0.02);
  CHECK(b.ends()[2] == 1.0);
  go_on(b, 40 * kLook, {1.0, 1.0, 1.0});
  CHECK(std::abs(b.ends()[0] - 1.0 / 3.0) < 0.02);
}

TEST_CASE("what little shares differ leaves all borders where they are; more moves them, and is told") {
  ShareBorders b(2);
  for (int step = 0; step < 30 * kLook; ++step) REQUIRE(!b.note(std::vector<double>{1.01, 0.99}));
  CHECK(b.ends()[0] == 0.5);
  int moves = 0;
  for (int step = 0; step < kLook; ++step) moves += b.note(std::vector<double>{1.1, 0.9});
  CHECK(moves == 1);
  CHECK(b.ends()[0] < 0.5);
}

TEST_CASE("a thread that lost its core for a moment keeps its share, and one that has none left keeps some to find back with") {
  ShareBorders b(2);
  for (int step = 0; step < 30 * kLook; ++step) b.note(std::vector<double>{step % kLook == 7 ? 1000.0 : 1.0, 1.0});
  CHECK(b.ends()[0] == 0.5);
  go_on(b, 100 * kLook, {1e6, 1.0});
  CHECK(b.ends()[0] > 0.1);
  CHECK(b.ends()[0] < 0.2);
  go_on(b, 40 * kLook, {1.0, 1.0});
  CHECK(std::abs(b.ends()[0] - 0.5) < 0.02);
}

TEST_CASE("steps that take no time tell nothing") {
  ShareBorders b(2);
  for (int step = 0; step < 2 * kLook; ++step) CHECK(!b.note(std::vector<double>{0.0, 0.0}));
  CHECK(b.ends()[0] == 0.5);
}
