// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/machine.h"

#include <doctest/doctest.h>

using namespace voussoir::solver;

TEST_CASE("a value takes no time within a thread, some from one to another, and is not timed with more threads than cores") {
  Team one(1), two(2), many(processors() + 1);
  CHECK(handover_now(one) == 0.0);
  CHECK(handover_now(many) == 0.0);
  const double time = handover_now(two);
  if (processors() < 2) return;
  CHECK(time > 1e-9);
  CHECK(time < 0.1);
}

TEST_CASE("what a machine can do at best is within reason, with two threads as with one") {
  const double one = peak_flops(1);
  CHECK(one > 1e8);
  CHECK(one < 1e12);
  CHECK(peak_flops(2) > 0.7 * one);  // two halves of one core do no more
  const double bandwidth = peak_bandwidth(1);
  CHECK(bandwidth > 1e8);
  CHECK(bandwidth < 1e12);
}

TEST_CASE("every core of a team is timed") {
  for (const int threads : {1, 2}) {
    Team team(threads);
    const std::vector<double> times = core_times(team);
    REQUIRE(times.size() == static_cast<std::size_t>(threads));
    for (const double t : times) {
      CHECK(t > 1e-6);
      CHECK(t < 1.0);
    }
  }
}
