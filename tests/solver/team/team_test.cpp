// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/team/team.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace voussoir::solver;

namespace {

void sleep_for_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

}  // namespace

TEST_CASE("a job is called once by each thread that comes, and seen whole by the one that gave it, whatever the size of the team is") {
  Team team;
  std::mt19937 random(1);
  std::vector<int> calls(24);
  for (int job = 0; job < 20'000; ++job) {
    team.set_size(std::uniform_int_distribution<int>(1, job % 100 == 0 ? 24 : 4)(random));
    std::ranges::fill(calls, 0);
    const bool all = job % 3 == 0;
    const auto work = [&](int thread) { ++calls[static_cast<std::size_t>(thread)]; };
    all ? team.run_on_all(work) : team.run(work);
    REQUIRE(calls[0] == 1);
    for (int k = 0; k < 24; ++k) {
      const int n = calls[static_cast<std::size_t>(k)];
      REQUIRE(n <= (k < team.size() ? 1 : 0));
      if (all && k < team.size()) REQUIRE(n == 1);
    }
  }
}

TEST_CASE("numbers are shared out once each, by teams of any size") {
  Team team;
  for (const int threads : {1, 2, 3, 16}) {
    team.set_size(threads);
    for (const bool all : {false, true}) {
      team.wait_for_all(all);
      for (const std::int64_t count : {0, 1, 7, 64, 1000}) {
        std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
        for (const std::int64_t at_a_time : {1, 5, 64}) {
          for (auto& d : done) d = 0;
          team.share_out(count, at_a_time, [&](std::int64_t first, std::int64_t last) {
            CHECK(first < last);
            for (auto i = first; i < last; ++i) ++done[static_cast<std::size_t>(i)];
          });
          for (const auto& d : done) REQUIRE(d == 1);
          std::atomic<std::int64_t> sum{0};
          Tickets tickets;
          tickets.begin(count, at_a_time);
          team.run([&](int) {
            tickets.take([&](std::int64_t first, std::int64_t last) {
              for (auto i = first; i < last; ++i) sum += i;
            });
          });
          REQUIRE(sum == count * (count - 1) / 2);
        }
      }
    }
  }
}

TEST_CASE("what threads share out is told with the number of the thread, and all of them take part if they are waited for") {
  Team team(4);
  team.wait_for_all(true);
  std::vector<int> ranges(4);
  std::atomic<int> came{0};
  team.share_out(400, 1, [&](std::int64_t, std::int64_t, int thread) {
    if (++ranges[static_cast<std::size_t>(thread)] > 1) return;
    ++came;
    while (came < 4) sleep_for_ms(1);  // however late the others come, there is a range left for each
  });
  CHECK(std::accumulate(ranges.begin(), ranges.end(), 0) == 400);
  for (const int n : ranges) CHECK(n > 0);
}

TEST_CASE("threads that sleep between jobs come to the next; a team that gave none ends at once") {
  Team idle(8);
  Team team(3);
  for (int job = 0; job < 5; ++job) {
    std::atomic<int> calls{0};
    team.run_on_all([&](int) { ++calls; });
    CHECK(calls == 3);
    sleep_for_ms(20);
  }
}

TEST_CASE("a thread that comes too late is left out, and does not come to the next job twice") {
  Team team(2);
  for (int job = 0; job < 2000; ++job) {
    std::atomic<int> calls{0};
    team.run([&](int) { ++calls; });  // over before a thread that sleeps can wake
    REQUIRE(calls >= 1);
    REQUIRE(calls <= 2);
    if (job % 500 == 0) sleep_for_ms(5);
  }
}

TEST_CASE("an exception of any thread reaches the caller once all have ended, and the team goes on") {
  Team team(4);
  for (int thrower = 0; thrower < 4; ++thrower) {
    std::atomic<int> ended{0};
    const auto work = [&](int thread) {
      if (thread == thrower) throw std::runtime_error("thrown by " + std::to_string(thread));
      // As a thread does that needs what another was to do.
      for (BackOff back_off(team.patience()); !team.is_broken();) back_off.wait();
      ++ended;
      throw TeamBroken{};
    };
    CHECK_THROWS_WITH_AS(team.run_on_all(work), ("thrown by " + std::to_string(thrower)).c_str(), std::runtime_error);
    CHECK(ended == 3);
    std::atomic<int> calls{0};
    team.run_on_all([&](int) { ++calls; });
    CHECK(calls == 4);
    CHECK_FALSE(team.is_broken());
  }
  Team one;
  CHECK_THROWS_AS(one.run([](int) { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST_CASE("far more threads than cores end, with all of them at work") {
  Team team(64);
  team.wait_for_all(true);
  std::int64_t sum = 0;
  for (int job = 0; job < 50; ++job) {
    std::vector<std::int64_t> by_thread(64);
    team.share_out(640, 1, [&](std::int64_t first, std::int64_t, int thread) { by_thread[static_cast<std::size_t>(thread)] += first; });
    sum += std::accumulate(by_thread.begin(), by_thread.end(), std::int64_t{0});
  }
  CHECK(sum == 50 * 640 * 639 / 2);
}

TEST_CASE("a signal wakes all who wait for it, whether they spin or sleep") {
  Signal signal;
  std::atomic<int> goal{0}, seen{0};
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&, k] {
      for (int round = 1; round <= 200; ++round) {
        signal.wait_until([&] { return goal.load() >= round; }, k % 2 == 0 ? Patience{0, 0} : Patience{});
        ++seen;
      }
    });
  }
  for (int round = 1; round <= 200; ++round) {
    if (round % 20 == 0) sleep_for_ms(1);
    goal = round;
    signal.raise();
    while (seen.load() < 4 * round) std::this_thread::yield();
  }
  for (std::thread& t : threads) t.join();
  CHECK(seen == 800);
}
