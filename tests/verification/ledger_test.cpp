// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "tests/verification/fixture.h"

// V13: the energy ledger closes.
namespace voussoir::testing {
namespace {

double residual_of_falling_wall(const char* step) {
  Run run("dry_wall", {std::string("time.step=") + step});
  double residual = 0.0;
  const double height = run.position(run.count() - 1).z;
  run.until(1.0, {false, true}, [&] { residual = std::max(residual, run.sim().energy().residual); });
  CHECK(run.position(run.count() - 1).z < 0.5 * height);  // it has fallen
  const solver::EnergyRow& e = run.sim().energy();
  MESSAGE("V13 step ", step, " s: gravity ", e.gravity, ", kinetic ", e.kinetic, ", dashpots ", e.dashpot, ", friction ", e.friction, " J");
  return residual;
}

}  // namespace

TEST_CASE("V13: energy ledger of a wall knocked down by gravity and friction") {
  const double coarse = residual_of_falling_wall("1e-4"), middle = residual_of_falling_wall("5e-5"),
               fine = residual_of_falling_wall("2.5e-5");
  expect_below("V13 residual over input, 1e-4 s", coarse, 1e-4);
  expect_below("V13 residual over input, 5e-5 s", middle, 1e-4);
  expect_below("V13 residual over input, 2.5e-5 s", fine, 1e-4);
  CHECK(fine < coarse);
}

}  // namespace voussoir::testing
