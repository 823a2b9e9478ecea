// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/fixture.h"

// V5: a unit in two halves cracks at mid-length when the strength of its inside is reached.
namespace voussoir::testing {
namespace {

/// A unit of 0.2 m that hangs along x from a fixed block by a bed that never fails, under a gravity of that direction: its middle bears
/// ρ g L/2. Whether it has parted at the end of settling.
bool parts(double strength, double gravity) {
  cases::Case c;
  c.gravity.acceleration = {gravity, 0.0, 0.0};
  c.gravity.ramp = 0.2;
  c.materials["brick"] = {2000.0, 1e8, 0.2, "own"};
  c.joint_laws["own"] = {.tension = strength, .cohesion = 1e9, .friction = 30.0, .compression = 1e12};
  c.joint_laws["glue"] = {.tension = 1e12, .cohesion = 1e12, .friction = 30.0, .compression = 1e12};
  c.joints.default_law = "glue";
  c.segment_rule = geometry::SegmentRule::rim;
  cases::BlockSpec wall, unit;
  wall.name = "wall", wall.material = "brick", wall.fixed = true;
  wall.box = {{Vec3{-0.1, 0.0, 0.0}, Vec3{0.0, 0.1, 0.1}}};
  unit.name = "unit", unit.material = "brick", unit.halves = true;
  unit.box = {{Vec3{0.0, 0.0, 0.0}, Vec3{0.2, 0.1, 0.1}}};
  c.blocks = {wall, unit};
  Run run(c);
  return !run.settle();
}

}  // namespace

TEST_CASE("V5: a unit in halves parts at the strength of its inside") {
  const double gravity = 50.0, stress = 2000.0 * gravity * 0.1;  // Pa, of the half that hangs
  double holds = 1.3 * stress, fails = 0.7 * stress;
  for (int i = 0; i < 8; ++i) {
    const double middle = 0.5 * (holds + fails);
    (parts(middle, gravity) ? fails : holds) = middle;
  }
  expect_near("V5 unit in halves, hung by one end: stress at which it parts [Pa]", 0.5 * (holds + fails), stress, 1e-2);
}

}  // namespace voussoir::testing
