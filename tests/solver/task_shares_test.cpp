// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/task_shares.h"

#include <doctest/doctest.h>
#include <omp.h>

#include <atomic>
#include <vector>

using voussoir::solver::TaskShares;

namespace {

std::vector<int> taken(TaskShares& shares, int thread) {
  std::vector<int> tasks;
  shares.take(thread, [&](std::int32_t t) { tasks.push_back(t); });
  return tasks;
}

}  // namespace

TEST_CASE("a thread begins with the tasks among its own elements, and goes on with what others have left") {
  const std::vector<double> places{0.0, 0.1, 0.2, 0.4, 0.5, 0.9};
  TaskShares shares;
  for (int step = 0; step < 2; ++step) {
    shares.deal(places, 2);
    CHECK(taken(shares, 1) == std::vector<int>{4, 5, 0, 1, 2, 3});
    CHECK(taken(shares, 0).empty());
  }
  shares.deal(places, 3);
  CHECK(taken(shares, 1) == std::vector<int>{3, 4, 5, 0, 1, 2});
  shares.deal(places, 8);  // some have none of their own
  CHECK(taken(shares, 2) == std::vector<int>{3, 4, 5, 0, 1, 2});
  shares.deal({}, 4);
  CHECK(taken(shares, 3).empty());
}

TEST_CASE("every task is done once, whatever number of threads asks for it") {
  std::vector<double> places(1000);
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<double>(i) / 2000.0;  // the later threads have none of their own
  std::vector<std::atomic<int>> done(places.size());
  TaskShares shares;
  for (const int threads : {1, 2, 5, 16}) {
    for (auto& d : done) d = 0;
    shares.deal(places, threads);
#pragma omp parallel num_threads(threads)
    shares.take(omp_get_thread_num(), [&](std::int32_t t) { ++done[static_cast<std::size_t>(t)]; });
    for (const auto& d : done) CHECK(d == 1);
  }
}
