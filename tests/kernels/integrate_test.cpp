// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/integrate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "kernels/prefetch.h"
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

// The plain twin: (24) of THEORY.md in space axes, with matrices, iterated until nothing changes. The second batch is along its principal
// axes.
TEST_CASE("the angular velocity is that of the implicit midpoint, and turns the element") {
  Flying f;
  Noise noise(5);
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t c = 19; c < 25; ++c)
      f.columns[c][i] = c < 22 ? 10.0 * static_cast<double>(c - 18) : i < kernels::kBatch ? 3.0 * noise() : 0.0;
  }
  f.principal[0] = 0;
  const auto drift = [&f](double dt) { kernels::drift(f.view(), f.rows(), dt, 0, kCount); };
  for (int k = 0; k < 3; ++k) drift(kStep);  // until ω fits L
  for (const double dt : {kStep, 10.0 * kStep}) {
    const Flying before = f;
    drift(dt);
    double fastest = 0.0;
    for (std::size_t i = 0; i < kCount; ++i) {
      CAPTURE(i);
      const Mat3 r = orientation(before, i);
      const Vec3 xy_xz_yz = at(before, 22, i), l = at(before, 10, i), w = at(f, 13, i);
      const Mat3 inverse = Mat3{{0, xy_xz_yz.x, xy_xz_yz.y}, {xy_xz_yz.x, 0, xy_xz_yz.z}, {xy_xz_yz.y, xy_xz_yz.z, 0}} +
                           Mat3::diagonal(before.columns[19][i], before.columns[20][i], before.columns[21][i]);
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
  rows.pose = poses, rows.out_of_cache = true;
  for (int k = 0; k < 3; ++k) {
    near.step();
    kernels::drift(far.view(), rows, kStep, 0, kCount);
    kernels::finish_stores();
    CHECK(std::ranges::equal(near.pose, poses));
    CHECK(near.twist == far.twist);
    CHECK(near.columns == far.columns);
  }
}

TEST_CASE("twists of batches that nobody watches are not written; nothing else depends on it") {
  Flying all, some;
  const std::uint8_t active[kCount / kernels::kBatch] = {0, 1, 0};
  kernels::ElementRows rows = some.rows();
  rows.active = active;
  for (int k = 0; k < 3; ++k) {
    all.step();
    kernels::drift(some.view(), rows, kStep, 0, kCount);
  }
  CHECK(all.columns == some.columns);
  CHECK(all.pose == some.pose);
  constexpr std::ptrdiff_t kOfBatch = kernels::kBatch * kernels::kTwistStride;
  for (std::ptrdiff_t batch = 0; batch < std::ssize(active); ++batch) {
    const auto *written = all.twist.data() + batch * kOfBatch, *row = some.twist.data() + batch * kOfBatch;
    if (batch == 1) {
      CHECK(std::equal(row, row + kOfBatch, written));
    } else {
      CHECK(std::all_of(row, row + kOfBatch, [](double x) { return x == 0.0; }));
    }
  }
}

TEST_CASE("what is said of elements along their principal axes is what their inertia says") {
  Flying said, unsaid;
  std::ranges::fill(unsaid.principal, 0);
  for (int k = 0; k < 3; ++k) {
    said.step(), unsaid.step();
    for (std::size_t c = 0; c < said.columns.size(); ++c) {
      for (std::size_t i = 0; i < kCount; ++i) CHECK(said.columns[c][i] == doctest::Approx(unsaid.columns[c][i]).epsilon(1e-15));
    }
  }
}

// The plain twin: (22) and (27) of THEORY.md for gravity, ground and damping, element by element.
TEST_CASE("a batch's energy tally is the sums over its elements") {
  Flying f;
  Noise noise(9);
  for (std::size_t i = 0; i < kCount; ++i) {
    const double mass = i == 3 ? 0.0 : 20.0 + noise();
    f.columns[16][i] = mass, f.columns[17][i] = mass > 0.0 ? 1.0 / mass : 0.0, f.columns[18][i] = 2.0 + noise();
  }
  f.step();
  const Flying before = f;
  const kernels::BodyForces bodies{kStep, {0.1, 0.2, -9.81}, {1.0, -2.0, 0.5}, {0.1, 0.3, -9.7}, {0.9, -2.1, 0.4}, false, {0.7, -0.3, 0.2}};
  kernels::kick(f.view(), f.rows(), bodies, 0, kCount);
  for (std::size_t batch = 0; batch < kCount / kernels::kBatch; ++batch) {
    double ground = 0.0, gravity = 0.0, damping = 0.0;
    for (std::size_t i = batch * kernels::kBatch; i < (batch + 1) * kernels::kBatch; ++i) {
      const Vec3 v = at(before, 7, i), mean = 0.5 * (v + at(f, 7, i)), damped = mean + bodies.damped_ground;
      const Vec3 gained = f.columns[16][i] > 0.0 ? kStep * (bodies.gravity - bodies.ground - f.columns[18][i] * damped) : Vec3{};
      CHECK(distance(at(f, 7, i), v + gained) < 1e-14);
      ground -= kStep * f.columns[16][i] * dot(bodies.mean_ground, v);
      gravity += kStep * f.columns[16][i] * dot(bodies.mean_gravity, v);
      damping += kStep * f.columns[18][i] * f.columns[16][i] * dot(mean, damped);
    }
    const double* tally = f.tally.data() + batch * kernels::kTallies;
    CHECK(tally[0] == doctest::Approx(ground).epsilon(1e-12));
    CHECK(tally[1] == doctest::Approx(gravity).epsilon(1e-12));
    CHECK(tally[2] == doctest::Approx(damping).epsilon(1e-12));
    CHECK(tally[3] == 0.0);
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
  double loss[kCount / kernels::kBatch] = {};
  for (const std::size_t i : kThree) {
    const Vec3 v = 0.5 * (at(before, 7, i) + at(f, 7, i)), w = 0.5 * (at(before, 13, i) + at(f, 13, i));
    loss[i / kernels::kBatch] -= kStep * (dot(force[i], v) + dot(torque[i], w));
  }
  for (std::size_t batch = 0; batch < std::size(loss); ++batch) {
    CAPTURE(batch);
    CHECK(f.tally[batch * kernels::kTallies + 3] == doctest::Approx(loss[batch]).epsilon(1e-12));
    CHECK((loss[batch] != 0.0) == (batch < 2));
  }
  CHECK(std::ranges::all_of(f.wrench, [](double x) { return x == 0.0; }));
  CHECK(std::ranges::all_of(f.dashpot, [](double x) { return x == 0.0; }));
}
