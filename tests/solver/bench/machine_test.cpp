// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/machine.h"

#include <doctest/doctest.h>
#include <omp.h>

using namespace voussoir::solver;

TEST_CASE("a value takes no time within a thread, some from one to another, and is not timed with more threads than cores") {
  CHECK(handover_now(1) == 0.0);
  CHECK(handover_now(omp_get_num_procs() + 1) == 0.0);
  const double time = handover_now(2);
  if (time == 0.0) return;  // the system gives one
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
    const std::vector<double> times = core_times(threads);
    REQUIRE(times.size() == static_cast<std::size_t>(threads));
    for (const double t : times) {
      if (t == 0.0) continue;  // the system gave fewer threads
      CHECK(t > 1e-6);
      CHECK(t < 1.0);
    }
  }
}
