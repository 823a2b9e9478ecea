// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "tests/verification/couplet.h"

// V5 under the options of [failure]: what a joint carries in shear while it is pulled, and after it has reached its shear limit.
namespace voussoir::testing {
namespace {

/// Shear carried [Pa] when the couplet is sheared to the elastic stress `tau` under the normal stress sigma.
double sheared(Press& press, double sigma, double tau) {
  press.move({0, 0, sigma / kStiffness}, 1e-3, [](Vec3) {});
  press.move({tau / kShearStiffness, 0, 0}, 1e-4, [](Vec3) {});
  return std::abs(press.hold().x) / kArea;
}

std::string at(double sigma) { return " at " + std::to_string(static_cast<int>(sigma)) + " Pa [Pa]"; }

}  // namespace

TEST_CASE("V5: shear in tension by cohesion, none, coulomb") {
  for (const double sigma : {0.1 * kTension, 0.3 * kTension}) {
    const double coulomb = kCohesion - sigma * kTanPhi, far = 1.5 * kCohesion;
    REQUIRE(coulomb > 0.0);
    Press cohesion({"failure.shear_in_tension=cohesion"}), none({"failure.shear_in_tension=none"}),
        literally({"failure.shear_in_tension=coulomb"}), off({"failure.shear=off"});
    expect_near("V5 shear_in_tension = cohesion," + at(sigma), sheared(cohesion, sigma, far), kCohesion, 1e-3);
    expect_near("V5 shear_in_tension = none, elastic at 1.5 c," + at(sigma), sheared(none, sigma, far), far, 1e-3);
    expect_near("V5 shear_in_tension = coulomb," + at(sigma), sheared(literally, sigma, far), coulomb, 1e-3);
    expect_near("V5 shear = off, elastic at 1.5 c," + at(sigma), sheared(off, sigma, far), far, 1e-3);
    CHECK(!none.failed());
    CHECK(!off.failed());
  }
  // Under compression all of them but `off` are Eq. 6.
  const double sigma = -4.0e4, limit = kCohesion - sigma * kTanPhi;
  for (const char* option : {"cohesion", "none", "coulomb"}) {
    Press press({std::string("failure.shear_in_tension=") + option});
    expect_near(std::string("V5 shear_in_tension = ") + option + "," + at(sigma), sheared(press, sigma, 1.5 * limit), limit, 1e-3);
  }
  Press off({"failure.shear=off"});
  expect_near("V5 shear = off, elastic at 1.5 times Eq. 6," + at(sigma), sheared(off, sigma, 1.5 * limit), 1.5 * limit, 1e-3);
}

TEST_CASE("V5: after the shear limit, plastic and brittle") {
  const double sigma = -4.0e4, limit = kCohesion - sigma * kTanPhi, residual = -sigma * kTanPhi;
  Press plastic({"failure.post_shear=plastic"});
  expect_near("V5 post_shear = plastic, at three times the elastic limit [Pa]", sheared(plastic, sigma, 3.0 * limit), limit, 1e-3);
  CHECK(plastic.damage().slipped > 0);
  CHECK(plastic.damage().shear == 0);
  plastic.move({-0.5 * limit / kShearStiffness, 0, 0}, 1e-4, [](Vec3) {});
  expect_near("V5 post_shear = plastic, half unloaded with the initial stiffness [Pa]", std::abs(plastic.hold().x) / kArea, 0.5 * limit,
              1e-3);
  Press brittle({"failure.post_shear=brittle"});
  expect_near("V5 post_shear = brittle, friction alone is left [Pa]", sheared(brittle, sigma, 3.0 * limit), residual, 1e-3);
  CHECK(brittle.damage().shear > 0);
  CHECK(brittle.damage().bonded == 0);
  // What slipped plastically still holds in tension; what broke in shear does not.
  plastic.move({0, 0, (0.5 * kTension - sigma) / kStiffness}, 1e-3, [](Vec3) {});
  brittle.move({0, 0, (0.5 * kTension - sigma) / kStiffness}, 1e-3, [](Vec3) {});
  expect_near("V5 post_shear = plastic, tension carried after slip [Pa]", -plastic.hold().z / kArea, 0.5 * kTension, 1e-3);
  expect_below("V5 post_shear = brittle, tension carried after slip [Pa]", norm(brittle.hold()) / kArea, 1e-9);
}

TEST_CASE("V5: loads at several rates") {
  for (const int rates : {2, 4}) {
    Run run("couplet", {"time.multirate=" + std::to_string(rates), "load[1].ramp=[5.0,6.0]"});
    double residual = 0.0, moved = 0.0;
    run.until(1.5, {false, true}, [&] {
      residual = std::max(residual, run.sim().energy().residual);
      if (run.time() > 1.4) moved = std::max(moved, norm(run.velocity(1)));
    });
    const std::string what = "V5 loads with " + std::to_string(rates) + " rates: ";
    expect_below(what + "residual of the ledger", residual, 1e-4);
    expect_below(what + "speed at rest under the load [m/s]", moved, 1e-9);
  }
}

}  // namespace voussoir::testing
