// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/wake_ups.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using voussoir::solver::WakeUps;

namespace {

std::vector<std::int32_t> list(const WakeUps& w) { return {w.awake().begin(), w.awake().end()}; }

}  // namespace

TEST_CASE("wake-ups: an item sleeps until the bound of one of its elements comes to its limit") {
  const std::vector<WakeUps::Link> links = {{0, 0}, {1, 0}, {1, 1}, {WakeUps::kNone, 1}};
  WakeUps w;
  w.reset(3, 2, links);
  std::vector<double> bound = {0.0, 0.0, 0.0};
  w.wake(bound.data());
  CHECK(list(w) == std::vector<std::int32_t>{0, 1});
  w.set_limit(0, 0, 1.0), w.set_limit(1, 1, 2.0), w.put_to_sleep(0);
  w.set_limit(2, 1, 3.0), w.set_limit(3, WakeUps::kNone, 0.0), w.put_to_sleep(1);
  bound = {0.999, 1.999, 50.0};
  w.wake(bound.data());
  CHECK(list(w).empty());
  bound[1] = 2.0;
  w.wake(bound.data());
  CHECK(list(w) == std::vector<std::int32_t>{0});
  w.set_limit(0, 0, 9.0), w.set_limit(1, 1, 8.0), w.put_to_sleep(0);
  bound[1] = 3.0;
  w.wake(bound.data());
  CHECK(list(w) == std::vector<std::int32_t>{1});
  bound[0] = 9.0;
  w.wake(bound.data());
  CHECK(list(w) == std::vector<std::int32_t>{0, 1});
}

TEST_CASE("wake-ups: no item is asleep that a look at all of them would find due") {
  constexpr int kElements = 150, kItems = 400, kSteps = 300;
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int32_t> element(0, kElements - 1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<WakeUps::Link> links;
  for (std::int32_t i = 0; i < kItems; ++i) links.push_back({element(random), i}), links.push_back({element(random), i});
  WakeUps w;
  w.reset(kElements, kItems, links);
  std::vector<double> bound(kElements, 0.0), speed(kElements), safe(kItems, 0.0);
  for (double& v : speed) v = part(random) * part(random);
  const auto due = [&](std::size_t i) {
    return bound[static_cast<std::size_t>(links[2 * i].element)] + bound[static_cast<std::size_t>(links[2 * i + 1].element)] >= safe[i];
  };
  std::size_t looks = 0;
  for (int step = 0; step < kSteps; ++step) {
    w.wake(bound.data());
    const std::vector<std::int32_t> awake = list(w);
    REQUIRE(std::ranges::is_sorted(awake));
    for (std::size_t i = 0; i < kItems; ++i) {
      if (due(i)) REQUIRE(std::ranges::binary_search(awake, static_cast<std::int32_t>(i)));
    }
    looks += awake.size();
    for (const std::int32_t item : awake) {
      const auto i = static_cast<std::size_t>(item);
      const auto a = links[2 * i].element, b = links[2 * i + 1].element;
      const double sum = bound[static_cast<std::size_t>(a)] + bound[static_cast<std::size_t>(b)];
      if (due(i)) safe[i] = sum + 20.0 * part(random);
      const double share = 0.5 * (safe[i] - sum);
      w.set_limit(2 * i, a, bound[static_cast<std::size_t>(a)] + share);
      w.set_limit(2 * i + 1, b, bound[static_cast<std::size_t>(b)] + share);
      w.put_to_sleep(item);
    }
    for (std::size_t e = 0; e < kElements; ++e) bound[e] += speed[e] * part(random);
  }
  CHECK(looks > 0);
  CHECK(looks < kItems * kSteps / 4);
}
