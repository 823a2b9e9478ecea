// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/integrate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "kernels/fetch.h"
#include "tests/kernels/flying_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// exp of a rotation vector (Rodrigues).
Mat3 turn(Vec3 r) {
  const double a = norm(r);
  const Mat3 k{{0, -r.z, r.y}, {r.z, 0, -r.x}, {-r.y, r.x, 0}};
  return Mat3{} + (std::sin(a) / a) * k + (2.0 * std::pow(std::sin(0.5 * a) / a, 2)) * (k * k);
}

double largest(const Mat3& m) { return std::max({norm(m.r0), norm(m.r1), norm(m.r2)}); }

/// Element i of the columns from `first` on.
Vec3 at(const Flying& f, std::size_t first, std::size_t i) {
  return {f.columns[first][i], f.columns[first + 1][i], f.columns[first + 2][i]};
}
Mat3 orientation(const Flying& f, std::size_t i) { return rotation({f.columns[3][i], f.columns[4][i], f.columns[5][i], f.columns[6][i]}); }

}  // namespace

// The plain twin: (24) of THEORY.md in space axes, with matrices, iterated until nothing changes. Three groups of lanes, so that groups
// that go side by side and one that goes alone are both looked at.
TEST_CASE("the angular velocity is that of the implicit midpoint, and turns the element") {
  constexpr std::size_t kSome = 3 * kernels::kWidth;
  Flying f;
  Noise noise(5);
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t c = 23; c < 29; ++c) f.columns[c][i] = c < 26 ? 10.0 * static_cast<double>(c - 22) : 3.0 * noise();
  }
  const auto drift = [&f](double dt) { kernels::drift(f.view(), f.rows(), dt, 0, kSome); };
  for (int k = 0; k < 3; ++k) drift(kStep);  // until ω fits L
  for (const double dt : {kStep, 10.0 * kStep}) {
    const Flying before = f;
    drift(dt);
    double fastest = 0.0;
    for (std::size_t i = 0; i < kSome; ++i) {
      CAPTURE(i);
      const Mat3 r = orientation(before, i);
      const Vec3 xy_xz_yz = at(before, 26, i), l = at(before, 10, i), w = at(f, 13, i);
      const Mat3 inverse = Mat3{{0, xy_xz_yz.x, xy_xz_yz.y}, {xy_xz_yz.x, 0, xy_xz_yz.z}, {xy_xz_yz.y, xy_xz_yz.z, 0}} +
                           Mat3::diagonal(before.columns[23][i], before.columns[24][i], before.columns[25][i]);
      Vec3 exact = at(before, 13, i);
      for (int k = 0; k < 30; ++k) {
        const Mat3 half = turn(0.5 * dt * exact) * r;
        exact = half * (inverse * (transposed(half) * l));
      }
      const double phi = 0.5 * dt * norm(exact);
      CHECK(norm(w - exact) < (10.0 * phi * phi * phi + 1e-15) * norm(exact));
      CHECK(largest(orientation(f, i) - turn(dt * w) * r) < 1e-15);
      const kernels::Pose pose = kernels::load_pose(f.pose.data(), static_cast<std::int64_t>(i));
      const kernels::Twist twist = kernels::load_twist(f.twist.data(), static_cast<std::int64_t>(i));
      CHECK(largest(pose.d - (orientation(f, i) - Mat3{})) < 1e-15);
      CHECK(norm(pose.u - (at(before, 0, i) + dt * at(before, 7, i))) < 1e-15);
      CHECK(twist.v == at(f, 7, i));
      CHECK(twist.w == w);
      fastest = std::max(fastest, phi);
    }
    CHECK(fastest > 5.0 * dt);  // rad/s, halved: they do turn
  }
}

TEST_CASE("poses stored past the caches are the same") {
  alignas(64) static double poses[kCount * kernels::kPoseStride];
  Flying near, far;
  kernels::ElementRows rows = far.rows();
  rows.pose = poses, rows.past_caches = true;
  for (int k = 0; k < 3; ++k) {
    near.step();
    kernels::drift(far.view(), rows, kStep, 0, kCount);
    kernels::finish_stores();
    CHECK(std::ranges::equal(near.pose, poses));
    CHECK(near.twist == far.twist);
    CHECK(near.columns == far.columns);
  }
}

// (27) of THEORY.md: force times the mean velocity, torque times the mean of the angular velocities before and after.
TEST_CASE("what dashpots took is booked where they did something, and nothing of a step is left in the rows") {
  Flying f;
  f.step();
  constexpr std::size_t kThree[] = {5, kernels::kLanes + 2, 3 * kernels::kLanes - 1};
  const kernels::ElementRows rows = f.rows();
  Noise noise(8);
  Vec3 force[kCount] = {}, torque[kCount] = {};
  for (const std::size_t i : kThree) {
    force[i] = noise.vector(100.0), torque[i] = noise.vector(10.0);
    kernels::add_wrench(rows.wrench, static_cast<std::int64_t>(i), 3.0 * force[i], {});
    kernels::add_dashpot(rows.wrench, rows.dashpot, static_cast<std::int64_t>(i), force[i], torque[i]);
  }
  const Flying before = f;
  kernels::BodyForces bodies;
  bodies.dt = kStep;
  kernels::kick(f.view(), rows, bodies, 0, kCount);
  f.step();
  for (std::size_t i = 0; i < kCount; ++i) {
    CAPTURE(i);
    const Vec3 v = 0.5 * (at(before, 7, i) + at(f, 7, i)), w = 0.5 * (at(before, 13, i) + at(f, 13, i));
    const double loss = -kStep * (dot(force[i], v) + dot(torque[i], w));
    CHECK(f.columns[19][i] == doctest::Approx(loss).epsilon(1e-12));
    CHECK((loss != 0.0) == (force[i] != Vec3{}));
  }
  CHECK(std::ranges::all_of(f.wrench, [](double x) { return x == 0.0; }));
  CHECK(std::ranges::all_of(f.dashpot, [](double x) { return x == 0.0; }));
}
