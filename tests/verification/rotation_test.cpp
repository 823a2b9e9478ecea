// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/verification/fixture.h"

// V7: rotation without forces from outside.
namespace voussoir::testing {
namespace {

/// Box 0.3 × 0.2 × 0.1, ω = (0.01, 10, 0.01) rad/s: the first three times at which ω_y in the body changes sign. Euler's equations give
/// ω_y = ω_m sn(p (t − t₀), k) where L² is above 2 T I_y, so it vanishes every 2K/p (Landau and Lifshitz, Mechanics, § 37).
std::array<double, 3> flip_times() {
  const double x2 = 0.3 * 0.3, y2 = 0.2 * 0.2, z2 = 0.1 * 0.1;  // m², edges
  double i1 = y2 + z2, i3 = x2 + y2;                            // the common factor m/12 drops out
  const double i2 = x2 + z2;
  const Vec3 w{0.01, 10.0, 0.01};
  const double l2 = i1 * i1 * w.x * w.x + i2 * i2 * w.y * w.y + i3 * i3 * w.z * w.z;
  const double t2 = i1 * w.x * w.x + i2 * w.y * w.y + i3 * w.z * w.z;
  if (l2 < t2 * i2) std::swap(i1, i3);  // the formulas ask for L² > 2 T I_y; else the outer axes change places
  const double top = std::sqrt((t2 * i3 - l2) / (i2 * (i3 - i2)));
  const double p = std::sqrt((i3 - i2) * (l2 - t2 * i1) / (i1 * i2 * i3));
  const double k = std::sqrt((i2 - i1) * (t2 * i3 - l2) / ((i3 - i2) * (l2 - t2 * i1)));
  // I_y dω_y/dt = (I_z − I_x) ω_z ω_x: with the true moments it tells whether |ω_y| falls at the start.
  const double quarter = std::comp_ellint_1(k), start = std::ellint_1(k, std::asin(w.y / top));
  const bool falls = (x2 - z2) * w.z * w.x * w.y < 0.0;
  const double first = (falls ? start : 2.0 * quarter - start) / p;
  return {first, first + 2.0 * quarter / p, first + 4.0 * quarter / p};
}

/// Component of ω along the body's y axis.
double middle_spin(const Run& run) {
  const Mat3 r = rotation(run.orientation(0));
  return (transposed(r) * run.spin(0)).y;
}

Quaternion product(Quaternion a, Quaternion b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// Angular momentum by the way a box of 0.3 × 0.2 × 0.1 m and the mass m has turned in a step: from two orientations and the edges alone.
Vec3 turned_momentum(Quaternion before, Quaternion after, double step, double m) {
  const Quaternion turn = product({before.w, -before.x, -before.y, -before.z}, after);  // in body axes
  const Vec3 axis{turn.x, turn.y, turn.z};
  const double sine = norm(axis), angle = 2.0 * std::atan2(sine, turn.w);
  const Vec3 w = (angle / (sine * step)) * axis;
  const double c = std::cos(0.25 * angle), s = std::sin(0.25 * angle) / sine;  // half way, a quarter of the angle in a quaternion
  const Quaternion middle = product(before, {c, s * axis.x, s * axis.y, s * axis.z});
  const double x2 = 0.3 * 0.3, y2 = 0.2 * 0.2, z2 = 0.1 * 0.1;  // m²
  return rotation(middle) * ((m / 12.0) * Vec3{(y2 + z2) * w.x, (x2 + z2) * w.y, (x2 + y2) * w.z});
}

struct Momentum {
  Vec3 linear, angular;
};

/// About the origin. Positions are a half step ahead of velocities, which drops out of x × v.
Momentum momentum(const Run& run) {
  Momentum p;
  for (std::size_t i = 0; i < run.count(); ++i) {
    const Vec3 mv = run.mass(i) * run.velocity(i);
    p.linear += mv;
    p.angular += cross(run.position(i), mv) + run.angular_momentum(i);
  }
  return p;
}

}  // namespace

TEST_CASE("V7: torque-free box flips about its middle axis") {
  Run run("tumbling");
  const Vec3 start = run.angular_momentum(0);
  Quaternion before{};
  std::vector<double> flips;
  double last = 0.0, last_time = 0.0, drift = 0.0, energy = 0.0, energy_drift = 0.0;
  const double step = run.sim().dt() * static_cast<double>(run.sim().cycle());
  run.until(10.0, {false, true}, [&] {
    if (run.sim().steps() == 0) return;
    const double now = middle_spin(run), time = run.time() - 0.5 * step;
    if (last * now < 0.0) flips.push_back(last_time + (time - last_time) * last / (last - now));
    last = now, last_time = time;
    if (run.sim().steps() > 1)
      drift = std::max(drift, norm(turned_momentum(before, run.orientation(0), step, run.mass(0)) - start) / norm(start));
    before = run.orientation(0);
    const double e = mechanical(run.sim().energy());
    if (energy == 0.0) energy = e;
    energy_drift = std::max(energy_drift, relative_error(e, energy));
  });
  const std::array<double, 3> expected = flip_times();
  const double figures[] = {1.9860, 5.4999, 9.0138};  // s, as the specification prints them
  REQUIRE(flips.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(expected[i] - figures[i]) < 6e-5);
    expect_near("V7 flip " + std::to_string(i + 1) + " [s]", flips[i], expected[i], 1e-3);
  }
  expect_below("V7 drift of angular momentum", drift, 1e-6);
  expect_below("V7 drift of energy", energy_drift, 1e-6);
}

TEST_CASE("V7: bonded cluster spinning freely") {
  Run run("cluster");
  run.cycle({false, true});
  const double energy = mechanical(run.sim().energy());
  const Momentum start = momentum(run);
  double linear = 0.0, angular = 0.0, drift = 0.0;
  for (int i = 0; i < 100000; ++i) {
    run.cycle({false, i % 100 == 0});
    if (i % 100 != 0) continue;
    const Momentum now = momentum(run);
    linear = std::max(linear, norm(now.linear - start.linear) / norm(start.linear));
    angular = std::max(angular, norm(now.angular - start.angular) / norm(start.angular));
    drift = std::max(drift, relative_error(mechanical(run.sim().energy()), energy));
  }
  expect_below("V7 cluster, drift of linear momentum", linear, 1e-12);
  expect_below("V7 cluster, drift of angular momentum", angular, 1e-12);
  expect_below("V7 cluster, drift of energy", drift, 1e-6);
}

}  // namespace voussoir::testing
