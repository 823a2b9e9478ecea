// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/motion.h"

#include <doctest/doctest.h>

#include <functional>
#include <limits>

using namespace voussoir;
using namespace voussoir::cases;

namespace {

Accelerogram sampled(double dt, std::size_t samples, const std::function<double(double)>& a) {
  Accelerogram out{"test", dt, {}};
  for (std::size_t i = 0; i < samples; ++i) out.acceleration.push_back(a(static_cast<double>(i) * dt));
  return out;
}

}  // namespace

TEST_CASE("acceleration between samples is linear, and zero outside the record") {
  const Accelerogram a{"test", 0.5, {1.0, 3.0, -1.0}};
  CHECK(acceleration_at(a, -1e-9) == 0.0);
  CHECK(acceleration_at(a, 0.0) == 1.0);
  CHECK(acceleration_at(a, 0.125) == doctest::Approx(1.0 + 2.0 * 0.25));
  CHECK(acceleration_at(a, 0.5) == 3.0);
  CHECK(acceleration_at(a, 0.75) == doctest::Approx(1.0));
  CHECK(acceleration_at(a, 1.0) == -1.0);
  CHECK(acceleration_at(a, 1.0 + 1e-6) == 0.0);
  CHECK(acceleration_at(a, 1e300) == 0.0);
  CHECK(acceleration_at(a, std::numeric_limits<double>::quiet_NaN()) == 0.0);
  CHECK(acceleration_at(Accelerogram{}, 0.0) == 0.0);
}

TEST_CASE("the last sample is met by a clock that adds up its steps") {
  const Accelerogram a = sampled(0.005, 201, [](double) { return 2.0; });
  double t = 0.0;
  for (int i = 0; i < 1000; ++i) t += 0.001;
  REQUIRE(t != 1.0);
  CHECK(acceleration_at(a, t) == 2.0);
}

TEST_CASE("components of different steps and lengths, and an absent one") {
  GroundMotion m;
  m.axis[0] = {"x", 0.5, {0.0, 1.0}};
  m.axis[2] = {"z", 0.25, {4.0, 8.0, 12.0, 16.0, 20.0}};
  CHECK(acceleration_at(m, 0.25) == Vec3{0.5, 0.0, 8.0});
  CHECK(acceleration_at(m, 0.75) == Vec3{0.0, 0.0, 16.0});
  CHECK(acceleration_at(m, -0.1) == Vec3{0.0, 0.0, 0.0});
}

TEST_CASE("velocity of the ground is the integral of straight lines, from rest, and stays as it is after the record") {
  GroundMotion m;
  m.axis[0] = {"x", 0.5, {1.0, 3.0, -1.0}};
  m.axis[2] = {"z", 0.25, {4.0, 8.0}};
  const GroundVelocity v(m);
  CHECK(v.at(-1.0) == Vec3{0.0, 0.0, 0.0});
  CHECK(v.at(0.0) == Vec3{0.0, 0.0, 0.0});
  CHECK(v.at(0.125).x == doctest::Approx(0.125 * (1.0 + 1.5) / 2.0));
  CHECK(v.at(0.125).z == doctest::Approx(0.125 * (4.0 + 6.0) / 2.0));
  CHECK(v.at(0.5).x == doctest::Approx(1.0));
  CHECK(v.at(0.75).x == doctest::Approx(1.0 + 0.25 * (3.0 + 1.0) / 2.0));
  CHECK(v.at(1.0).x == doctest::Approx(1.5));
  CHECK(v.at(7.0) == Vec3{v.at(1.0).x, 0.0, 1.5});
  CHECK(GroundVelocity(GroundMotion{}).at(1.0) == Vec3{0.0, 0.0, 0.0});
}
