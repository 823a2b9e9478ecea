// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "tests/verification/fixture.h"

// V10: contact dashpots at critical damping must not spoil the step of Eq. 19.
namespace voussoir::testing {
namespace {

/// Largest distance of any element from where it was at `from` [s], until `end`; `kinetic` is that of the end.
double drift(Run& run, double from, double end, double& kinetic) {
  run.until(from);
  std::vector<Vec3> start;
  for (std::size_t i = 0; i < run.count(); ++i) start.push_back(run.displacement(i));
  double most = 0.0;
  run.until(end, {false, true}, [&] {
    for (std::size_t i = 0; i < run.count(); ++i) most = std::max(most, norm(run.displacement(i) - start[i]));
  });
  kinetic = run.sim().energy().kinetic;
  return most;
}

/// 0.995 of Eq. 19: half the height of an element over c_L of wood.
std::string step_of_eq19() {
  const double bound = 0.05 / std::sqrt(6.3e8 / (1.0 - 0.3 * 0.3) / 700.0);
  return "time.step=" + std::to_string(0.995e6 * bound) + "e-6";
}

}  // namespace

TEST_CASE("V10: dry stack of wood, settled, stays at rest") {
  Run run("dry_stack", {step_of_eq19()});
  CHECK(run.settle());
  double kinetic = 0.0;
  expect_below("V10 settled, drift in 5 s [m]", drift(run, 0.0, 5.0, kinetic), 1e-6);
  // Against the elastic energy of the stack, half its weight times its shortening: Σ (weight above)² (2 ℓ) / (2 E' A).
  CHECK(run.sim().energy().contact > 0.0);
  expect_below("V10 settled, kinetic over elastic energy at the end", kinetic / run.sim().energy().contact, 1e-8);
}

TEST_CASE("V10: dry stack of wood under sudden gravity comes to rest") {
  Run run("dry_stack", {step_of_eq19(), "gravity.settle=false"});
  double kinetic = 0.0;
  expect_below("V10 sudden, drift from 1 to 5 s [m]", drift(run, 1.0, 5.0, kinetic), 1e-6);
  expect_below("V10 sudden, kinetic over elastic energy at the end", kinetic / run.sim().energy().contact, 1e-8);
}

}  // namespace voussoir::testing
