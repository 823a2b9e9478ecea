// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/machine.h"

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

TEST_CASE("what a machine does just now is not above what it does at best by more than its clock varies") {
  const double now = flops_now(1);
  CHECK(now > 1e8);
  CHECK(now < 2.0 * peak_flops(1));
}
