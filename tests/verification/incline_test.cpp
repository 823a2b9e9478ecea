// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/fixture.h"

// V3: Coulomb friction of one block.
namespace voussoir::testing {

TEST_CASE("V3: block slides on an incline") {
  const double slope = radians(40.0), mu = std::tan(radians(30.0));
  Run run("incline");
  run.until(0.3);  // the knock of sudden gravity has died away
  const double t0 = run.time(), v0 = run.velocity(0).x;
  run.until(1.0);
  const double expected = kGravity * (std::sin(slope) - mu * std::cos(slope));
  expect_near("V3 acceleration down the incline [m/s2]", (run.velocity(0).x - v0) / (run.time() - t0), expected, 5e-3);
}

TEST_CASE("V3: block slides down any fall line") {
  const double slope = radians(40.0), mu = std::tan(radians(30.0));
  for (const double angle : {30.0, 200.0}) {  // degrees, of the fall line from x
    const Vec3 down{std::cos(radians(angle)), std::sin(radians(angle)), 0.0};
    const double along = kGravity * std::sin(slope), across = kGravity * std::cos(slope);
    cases::Case c = load("incline").value;
    c.base->tilt = {0.0, 0.0};
    c.gravity.acceleration = {along * down.x, along * down.y, -across};
    Run run(c);
    run.until(0.3);
    const double t0 = run.time();
    const Vec3 v0 = run.velocity(0);
    run.until(1.0);
    const Vec3 a = (1.0 / (run.time() - t0)) * (run.velocity(0) - v0);
    const std::string where = ", fall line at " + std::to_string(static_cast<int>(angle)) + " degrees";
    expect_near("V3 acceleration" + where + " [m/s2]", dot(a, down), along - mu * across, 5e-3);
    expect_below("V3 acceleration across it" + where + " [m/s2]", std::abs(a.x * down.y - a.y * down.x), 5e-3 * (along - mu * across));
  }
}

TEST_CASE("V3: block sticks on an incline") {
  Run run("incline_stick");
  CHECK(run.settle());
  const Vec3 start = run.displacement(0);
  double drift = 0.0;
  run.until(5.0, {}, [&] { drift = std::max(drift, norm(run.displacement(0) - start)); });
  expect_below("V3 creep in 5 s [m]", drift, 1e-6);
}

TEST_CASE("V3: rectangular base pulse") {
  const double a = 8.0, t0 = 40.5 * 0.005, mu = std::tan(radians(25.0));  // 41 samples of a, and half an interval to fall
  Run run("pulse");
  CHECK(run.settle());
  const double start = run.displacement(0).x;
  run.until(1.0);
  const double v = a * t0;
  const double expected = v * v / (2.0 * mu * kGravity) * (1.0 - mu * kGravity / a);
  expect_near("V3 slip under a pulse [m]", start - run.displacement(0).x, expected, 2e-2);
}

}  // namespace voussoir::testing
