// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/schedule/task_shares.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <vector>

using voussoir::solver::TaskShares;
using voussoir::solver::Team;

namespace {

std::vector<int> own(TaskShares& shares, int thread) {
  std::vector<int> tasks;
  shares.take_own(thread, [&](std::int32_t t) { tasks.push_back(t); });
  return tasks;
}

std::vector<int> helped(TaskShares& shares, int thread) {
  std::vector<int> tasks;
  shares.help(thread, Team(8), [&](std::int32_t t) { tasks.push_back(t); });
  return tasks;
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void work_for(double seconds) {
  for (const double start = now(); now() - start < seconds;) continue;
}

/// Where the shares of two threads meet after some hundred steps of a hundred tasks, if `step` is one of them.
template <class Step>
double border_after(int looks, Step step) {
  TaskShares shares(0.0);
  for (int i = 0; i <= looks * 64; ++i) {
    shares.begin(2);
    shares.deal(100);
    step(shares);
  }
  return shares.borders()[0];
}

}  // namespace

TEST_CASE("a thread does its own share, and helps with what others have left") {
  const std::vector<std::int32_t> ends{4, 6};
  TaskShares shares(0.1);
  CHECK(shares.begin(2));
  for (int step = 0; step < 2; ++step) {
    shares.deal(ends);
    CHECK(own(shares, 1) == std::vector<int>{4, 5});
    CHECK(helped(shares, 1) == std::vector<int>{0, 1, 2, 3});
    CHECK(own(shares, 0).empty());
    CHECK(helped(shares, 0).empty());
    CHECK(!shares.begin(2));
  }
  CHECK(shares.begin(3));
  CHECK(shares.begin(2));  // a team of another size has borders of its own
  CHECK(shares.begin(3));
  shares.deal(6);
  CHECK(own(shares, 1) == std::vector<int>{2, 3});
  CHECK(helped(shares, 1) == std::vector<int>{4, 5, 0, 1});
  shares.begin(8);  // some have none of their own
  shares.deal(2);
  CHECK(own(shares, 2).empty());
  CHECK(helped(shares, 2) == std::vector<int>{1, 0});
  shares.begin(4);
  shares.deal(0);
  CHECK(own(shares, 3).empty());
  CHECK(helped(shares, 3).empty());
}

TEST_CASE("every task is done once, whatever number of threads asks for it") {
  std::vector<std::atomic<int>> done(1000);
  TaskShares shares(0.1);
  for (const int threads : {1, 2, 5, 16}) {
    Team team(threads);
    for (int step = 0; step < 200; ++step) {  // borders move
      for (auto& d : done) d = 0;
      shares.begin(threads);
      shares.deal(static_cast<std::int64_t>(done.size()));
      team.run([&](int thread) {
        const auto work = [&](std::int32_t t) { ++done[static_cast<std::size_t>(t)]; };
        shares.take_own(thread, work);
        shares.help(thread, team, work);
      });
      for (const auto& d : done) REQUIRE(d == 1);
    }
  }
}

TEST_CASE("a thread gives others that have come so many times its own time before it helps, but waits for none that is done or absent") {
  constexpr double kOwn = 2e-3;  // s
  enum class Other { at_work, done, absent };
  const auto wait = [&](double patience, Other other) {
    TaskShares shares(patience);
    shares.begin(2);
    shares.deal(4);
    double waited = 0.0;
    std::size_t tasks = 0;
    const auto thread_1 = [&] {
      shares.take_own(1, [&](std::int32_t) { work_for(kOwn); });
      const double start = now();
      tasks = helped(shares, 1).size();
      waited = now() - start;
    };
    // Its second task is still to be done while thread 1 looks on.
    if (other == Other::at_work) shares.take_own(0, [&](std::int32_t task) { task == 0 ? thread_1() : void(); });
    if (other == Other::done) own(shares, 0), thread_1();
    if (other == Other::absent) thread_1();
    CHECK(tasks == (other == Other::done ? 0 : other == Other::absent ? 2 : 1));
    return waited;
  };
  CHECK(wait(10.0, Other::at_work) > 0.99 * 10.0 * 2.0 * kOwn);
  CHECK(wait(1000.0, Other::done) < 0.5);
  CHECK(wait(1000.0, Other::absent) < 0.5);
  CHECK(wait(0.0, Other::at_work) < 0.5);
}

TEST_CASE("tasks of another thread are taken one by one, up to the one that is wanted") {
  TaskShares shares(0.1);
  shares.begin(2);
  shares.deal(std::vector<std::int32_t>{3, 8});
  std::vector<int> tasks;
  const auto take = [&](std::int32_t last) { return shares.take_one(1, last, [&](std::int32_t t) { tasks.push_back(t); }); };
  CHECK(take(4));
  CHECK(take(4));
  CHECK_FALSE(take(4));
  CHECK(tasks == std::vector<int>{3, 4});
  CHECK(own(shares, 1) == std::vector<int>{5, 6, 7});
}

TEST_CASE("a share without a task grows until it has one") {
  TaskShares shares(0.0);
  for (int step = 0; step <= 64 * 30; ++step) {
    shares.begin(2);
    const auto end = static_cast<std::int32_t>(10.0 * shares.borders()[0] - 4.5);  // none, at first
    shares.deal(std::vector<std::int32_t>{end, 10});
    for (const int thread : {0, 1}) shares.take_own(thread, [](std::int32_t) { work_for(1e-6); });
  }
  CHECK(shares.borders()[0] > 0.55);
}

TEST_CASE("the border moves towards the thread whose tasks take longer") {
  const double border = border_after(10, [](TaskShares& shares) {
    shares.take_own(0, [](std::int32_t) { work_for(2e-5); });
    shares.take_own(1, [](std::int32_t) { work_for(1e-5); });
  });
  CHECK(std::abs(border - 1.0 / 3.0) < 0.04);
}

TEST_CASE("a share counts as it would be without help") {
  // Thread 0 does its first task; meanwhile the other, with as long tasks of its own, has done all others.
  const double border = border_after(1, [](TaskShares& shares) {
    shares.take_own(1, [](std::int32_t) { work_for(2e-5); });
    shares.take_own(0, [&](std::int32_t) { shares.help(1, Team(2), [](std::int32_t) {}), work_for(2e-5); });
  });
  CHECK(std::abs(border - 0.5) < 0.04);
  // It comes too late for any.
  CHECK(border_after(1, [](TaskShares& shares) { own(shares, 1), helped(shares, 1), own(shares, 0); }) < 0.48);
}
