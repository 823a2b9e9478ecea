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

/// Where the shares of two threads meet after so many steps of a hundred tasks. Tasks are done by thread 0 but for those from `others` on,
/// for which thread 1 comes while thread 0 is at work.
double border_after(TaskShares& shares, int steps, int others) {
  for (int step = 0; step < steps; ++step) {
    shares.begin(2);
    shares.deal(100);
    const auto ends = [&](int share) { return static_cast<int>(shares.borders()[static_cast<std::size_t>(share)] * 100.0 + 0.5); };
    int left = others;
    shares.take(0, [&](std::int32_t t) {
      // Thread 1 takes what is left of the first share, or comes as soon as thread 0 reaches the second one.
      if (left >= 0 && (t == left || t >= ends(0) - 1)) left = -1, shares.take(1, [](std::int32_t) {});
    });
  }
  return shares.borders()[0];
}

}  // namespace

TEST_CASE("a thread begins with its own share, and goes on with what others have left") {
  const std::vector<std::int32_t> ends{4, 6};
  TaskShares shares;
  CHECK(shares.begin(2));
  for (int step = 0; step < 2; ++step) {
    shares.deal(ends);
    CHECK(taken(shares, 1) == std::vector<int>{4, 5, 0, 1, 2, 3});
    CHECK(taken(shares, 0).empty());
    CHECK(!shares.begin(2));
  }
  CHECK(shares.begin(3));
  CHECK(shares.begin(2));  // a team of another size has borders of its own
  CHECK(shares.begin(3));
  shares.deal(6);
  CHECK(taken(shares, 1) == std::vector<int>{2, 3, 4, 5, 0, 1});
  shares.begin(8);  // some have none of their own
  shares.deal(2);
  CHECK(taken(shares, 2) == std::vector<int>{1, 0});
  shares.begin(4);
  shares.deal(0);
  CHECK(taken(shares, 3).empty());
}

TEST_CASE("every task is done once, whatever number of threads asks for it") {
  std::vector<std::atomic<int>> done(1000);
  TaskShares shares;
  for (const int threads : {1, 2, 5, 16}) {
    for (int step = 0; step < 200; ++step) {  // borders move
      for (auto& d : done) d = 0;
      shares.begin(threads);
      shares.deal(static_cast<std::int64_t>(done.size()));
#pragma omp parallel num_threads(threads)
      shares.take(omp_get_thread_num(), [&](std::int32_t t) { ++done[static_cast<std::size_t>(t)]; });
      for (const auto& d : done) REQUIRE(d == 1);
    }
  }
}

TEST_CASE("shares follow what threads get done, until none has to help another") {
  TaskShares shares;
  CHECK(border_after(shares, 65, 30) < 0.5);  // thread 1 has helped with 20 of 50
  const double found = border_after(shares, 20 * 64, 30);
  CHECK(found == doctest::Approx(0.3).epsilon(0.05));
  CHECK(border_after(shares, 20 * 64, 30) == doctest::Approx(found).epsilon(0.02));
  // A thread that gets nothing done for a while keeps a share to come back to.
  CHECK(border_after(shares, 40 * 64, 0) > 0.1);
}

TEST_CASE("what little threads take from each other leaves all borders where they are") {
  TaskShares shares;
  const std::vector<std::int32_t> ends{100, 200};
  shares.begin(2);
  for (int step = 0; step < 2000; ++step) {
    shares.deal(ends);
    shares.take(0, [&](std::int32_t t) {
      if (t == 98) shares.take(1, [](std::int32_t) {});  // thread 1 does the last task of thread 0: an excess of 1 %
    });
    CHECK(!shares.begin(2));
  }
  CHECK(shares.borders()[0] == 0.5);
}
