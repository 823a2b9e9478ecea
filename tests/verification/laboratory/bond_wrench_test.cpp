// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/fixture.h"

// V5: the bond wrench. A bracket bends a brick off its bed: the bed cracks where M/W − N/A reaches its tensile strength.
namespace voussoir::testing {
namespace {

constexpr double kWidth = 0.1, kDepth = 0.2, kDensity = 2000.0, kGravity = 9.81;  // m, m, kg/m3, m/s2
constexpr double kWeight = kDensity * 0.6 * kWidth * 0.1 * kGravity,
                 kMoment = kWeight * 0.2;  // N, N m, of the bracket about the bed's middle
constexpr double kModulus = kWidth * kDepth * kDepth / 6.0, kPressure = kWeight / (kWidth * kDepth);  // m3, Pa

/// A bracket of 0.6 m lies with its last 0.2 m on a fixed brick, and its weight bends the bed. Whether the bed cracks.
bool cracks(double strength, geometry::SegmentRule rule) {
  cases::Case c;
  c.gravity.acceleration = {0.0, 0.0, -kGravity};
  c.gravity.ramp = 0.4;
  c.segment_size = 0.05;
  c.segment_rule = rule;
  c.materials["steel"] = {kDensity, 1e9, 0.2, {}};
  c.joint_laws["bed"] = {.tension = strength, .cohesion = 1e9, .friction = 30.0, .compression = 1e12};
  c.joints.default_law = "bed";
  cases::BlockSpec brick, bracket;
  brick.name = "brick", brick.material = "steel", brick.fixed = true;
  brick.box = {{Vec3{0.0, 0.0, 0.0}, Vec3{kDepth, kWidth, 0.1}}};
  bracket.name = "bracket", bracket.material = "steel";
  bracket.box = {{Vec3{0.0, 0.0, 0.1}, Vec3{0.6, kWidth, 0.2}}};
  c.blocks = {brick, bracket};
  Run run(c);
  run.settle();
  return run.sim().damage().tension > 0;
}

/// Pa: the least strength at which the bed does not crack, by bisection.
double strength_at_failure(double expected, geometry::SegmentRule rule) {
  double holds = 1.2 * expected, fails = 0.8 * expected;
  for (int i = 0; i < 8; ++i) {
    const double middle = 0.5 * (holds + fails);
    (cracks(middle, rule) ? fails : holds) = middle;
  }
  return 0.5 * (holds + fails);
}

}  // namespace

TEST_CASE("V5: bond wrench") {
  const double bending = kMoment / kModulus;
  const double rim = bending - kPressure;
  expect_near("V5 bond wrench, points to the rim: tensile strength at failure [Pa]", strength_at_failure(rim, geometry::SegmentRule::rim),
              rim, 1e-2);
  // n = 4 points at the centres across the bed: M/W/(1 + 1/n), THEORY (2).
  const double centres = bending / 1.25 - kPressure;
  expect_near("V5 bond wrench, points at the centres, n = 4: tensile strength at failure [Pa]",
              strength_at_failure(centres, geometry::SegmentRule::centres), centres, 1e-2);
}

}  // namespace voussoir::testing
