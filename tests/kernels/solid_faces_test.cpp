// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Faces that twist as solids do, THEORY.md (11a): fast kernels against the plain twin, and against closed forms.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/kernels/side_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr double kTwists[] = {-0.8, -0.3, 0.3};
constexpr double kStep = 5e-5;

/// A side that looks along an axis, anyhow, or stands on the base.
SideUnderTest side_of(double twist, int form, Noise& noise) {
  SideUnderTest u(4, 6, form == 2 ? 0.0 : 0.5);
  u.side.twist = twist;
  if (form == 1) {
    const Quaternion q{0.9, 0.3, -0.2, std::sqrt(1.0 - 0.81 - 0.09 - 0.04)};
    const Mat3 d = rotation_minus_identity(q);
    u.side.es = u.side.es + d * u.side.es, u.side.et = u.side.et + d * u.side.et;
  }
  if (form == 2) u.put_onto_base();
  u.side.ca = noise.vector(0.05), u.side.cb = noise.vector(0.05);
  return u;
}

TwoBodies pose_of(const SideUnderTest& u, Noise& noise, double opening) {
  TwoBodies b;
  const Vec3 common = u.side.on_base ? Vec3{} : noise.vector(0.3), turn = u.side.on_base ? noise.vector(1e-4) : noise.vector(0.2);
  b.place(0, common, turn);
  const Mat3 d = kernels::load_pose(b.pose.data(), 0).d;
  if (u.side.on_base) {
    b.place(0, noise.vector(opening) - d * u.side.ca, turn);
  } else {
    b.place(1, common + d * (u.side.ca - u.side.cb) + noise.vector(opening), turn + noise.vector(10.0 * opening));
    b.move(1, noise.vector(0.01), noise.vector(0.1));
  }
  b.move(0, noise.vector(0.01), noise.vector(0.1));
  return b;
}

void check_same(const SideStep& a, const SideStep& b) {
  const double force = norm(b.force_a) + 1e-6, torque = norm(b.torque_a) + norm(b.torque_b) + 1e-8;
  CHECK(distance(a.force_a, b.force_a) < 1e-9 * force);
  CHECK(distance(a.torque_a, b.torque_a) < 1e-9 * torque);
  CHECK(distance(a.torque_b, b.torque_b) < 1e-9 * torque);
}

SideStep step_of(kernels::AdvanceSides& kernel, SideUnderTest& u, const TwoBodies& b, kernels::SideState state,
                 kernels::FailureOptions o = {}) {
  std::vector<kernels::SegmentEvent> events;
  return advance(kernel, u, b, kStep, 0.0, o, events, state);
}

}  // namespace

TEST_CASE("faces that twist as solids do: both closed forms of whole sides are the sum over the segments") {
  Noise noise(11);
  int closed = 0;
  for (const double twist : kTwists) {
    for (int i = 0; i < 60; ++i) {
      SideUnderTest u = side_of(twist, i % 3, noise);
      const TwoBodies b = pose_of(u, noise, 1e-6);
      SideUnderTest plain = u;
      const SideStep want = step_of(kernels::advance_sides_reference, plain, b, kernels::SideState::segments);
      for (const kernels::ShearInTension limit : {kernels::ShearInTension::cohesion, kernels::ShearInTension::coulomb}) {
        SideUnderTest fast = u;  // coulomb: without the short form
        const SideStep found = step_of(kernels::advance_sides, fast, b, kernels::SideState::whole, {.in_tension = limit});
        closed += !found.looked_at;
        if (want.result.events == 0) check_same(found, want);
      }
    }
  }
  CHECK(closed > 200);
}

TEST_CASE("faces that twist as solids do: damaged and steady sides do what the plain twin does") {
  Noise noise(12);
  int steady = 0;
  for (const double twist : kTwists) {
    for (int i = 0; i < 60; ++i) {
      SideUnderTest u = side_of(twist, i % 3, noise);
      for (std::size_t k = 0; k < static_cast<std::size_t>(u.n); ++k) {
        if (noise() > 0.3) u.bond[k] = kernels::Bond::contact;
        u.segments().slip1(static_cast<int>(k)) = 1e-7 * noise(), u.segments().slip2(static_cast<int>(k)) = 1e-7 * noise();
      }
      SideUnderTest plain = u;
      const TwoBodies b = pose_of(u, noise, 1e-6);
      const SideStep found = step_of(kernels::advance_sides, u, b, kernels::SideState::segments);
      const SideStep want = step_of(kernels::advance_sides_reference, plain, b, kernels::SideState::segments);
      check_same(found, want);
      CHECK(found.result.friction == doctest::Approx(want.result.friction).epsilon(1e-9).scale(1e-12));
      if (!make_steady(u, found, 0.01, {})) continue;
      ++steady;
      const SideStep again = step_of(kernels::advance_sides, u, b, kernels::SideState::steady);
      CHECK_FALSE(again.looked_at);
      check_same(again, step_of(kernels::advance_sides_reference, plain, b, kernels::SideState::segments));
    }
  }
  CHECK(steady > 5);
}

TEST_CASE("faces that twist as solids do: the torque of a twist is G J, a slide and a tilt are as before") {
  for (const double twist : kTwists) {
    SideUnderTest u(4, 6, 0.5), plane(4, 6, 0.5);
    u.side.ca = plane.side.ca = {0.05, 0.0, 0.0}, u.side.cb = plane.side.cb = {-0.05, 0.0, 0.0};
    u.side.twist = twist;
    const auto torque = [](SideUnderTest& side, Vec3 turn) {
      TwoBodies b;
      b.place(1, {}, turn);
      return step_of(kernels::advance_sides, side, b, kernels::SideState::whole).torque_a;
    };
    const double ratio = torque(u, {1e-6, 0.0, 0.0}).x / torque(plane, {1e-6, 0.0, 0.0}).x;
    CHECK(ratio == doctest::Approx((1.0 + twist) * (1.0 + twist)).epsilon(1e-9));
    CHECK(distance(torque(u, {0.0, 1e-6, 1e-6}), torque(plane, {0.0, 1e-6, 1e-6})) < 1e-9 * norm(torque(plane, {0.0, 1e-6, 1e-6})));
  }
}

TEST_CASE("faces that twist as solids do: the forces are the slope of the stored energy") {
  Noise noise(13);
  for (const double twist : kTwists) {
    SideUnderTest u = side_of(twist, 0, noise);
    for (std::size_t k = 0; k < 8; ++k) u.bond[k] = kernels::Bond::contact;
    const Vec3 apart{1e-6, 2e-7, -3e-7}, turn{4e-7, 0.0, 0.0};
    const auto stored = [&](double about) {
      TwoBodies b;
      b.place(1, apart, turn + Vec3{about, 0.0, 0.0});
      SideUnderTest at = u;
      return energy(at, b).bonds;
    };
    TwoBodies b;
    b.place(1, apart, turn);
    SideUnderTest at = u;
    const SideStep s = step_of(kernels::advance_sides_reference, at, b, kernels::SideState::segments);
    constexpr double kTurn = 1e-8;
    CHECK((stored(kTurn) - stored(-kTurn)) / (2.0 * kTurn) == doctest::Approx(-s.torque_b.x).epsilon(1e-5).scale(0.0));
  }
}

TEST_CASE("faces that twist as solids do: on the base, too, where no axis of the points lies along the joint's") {
  Noise noise(14);
  int closed = 0;
  for (const double twist : kTwists) {
    for (int i = 0; i < 30; ++i) {
      SideUnderTest u = side_of(twist, 2, noise);
      for (std::size_t k = 0; k < u.s.size(); ++k) {
        if (u.s[k] + u.t[k] > 0.0) u.area[k] *= 3.0;
      }
      double area = 0.0, s = 0.0, t = 0.0;  // about their centroid
      for (std::size_t k = 0; k < u.s.size(); ++k) area += u.area[k], s += u.area[k] * u.s[k], t += u.area[k] * u.t[k];
      for (std::size_t k = 0; k < u.s.size(); ++k) u.s[k] -= s / area, u.t[k] -= t / area;
      const TwoBodies b = pose_of(u, noise, 1e-6);
      SideUnderTest plain = u;
      const SideStep want = step_of(kernels::advance_sides_reference, plain, b, kernels::SideState::segments);
      const SideStep found = step_of(kernels::advance_sides, u, b, kernels::SideState::whole);
      closed += !found.looked_at;
      if (want.result.events == 0) check_same(found, want);
    }
  }
  CHECK(closed > 50);
}
