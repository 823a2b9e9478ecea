// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/certificate.h"

#include <doctest/doctest.h>

#include "tests/kernels/side_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// Under these no bound goes before the certificate (kernels/whole_sides.h).
constexpr kernels::FailureOptions kNoBound{.in_tension = kernels::ShearInTension::coulomb};

SideStep closed_form(SideUnderTest u, const TwoBodies& b, kernels::FailureOptions o = {}) {
  std::vector<kernels::SegmentEvent> events;
  return advance(kernels::advance_sides, u, b, 5e-5, 0.0, o, events, kernels::SideState::whole);
}

SideStep by_segments(SideUnderTest u, const TwoBodies& b, kernels::FailureOptions o = {}) {
  std::vector<kernels::SegmentEvent> events;
  return advance(kernels::advance_sides_reference, u, b, 5e-5, 0.0, o, events);
}

/// Both bodies moved together by up to 0.3 m and 0.2 rad, and apart by about `opening` [m].
TwoBodies random_pose(const SideUnderTest& u, Noise& noise, double opening) {
  TwoBodies b;
  const Vec3 common = noise.vector(0.3), turn = noise.vector(0.2);
  b.place(0, common, turn);
  const Vec3 between = u.side.ca - u.side.cb;  // of the centroids
  b.place(1, common + kernels::load_pose(b.pose.data(), 0).d * between + noise.vector(opening), turn + noise.vector(10.0 * opening));
  return b;
}

/// The master turned by up to 0.2 rad on the base, and apart from it by about `opening` [m].
TwoBodies random_pose_on_base(const SideUnderTest& u, Noise& noise, double opening) {
  TwoBodies b;
  const Vec3 turn = noise.vector(0.2);
  b.place(0, {}, turn);
  b.place(0, noise.vector(opening) - kernels::load_pose(b.pose.data(), 0).d * u.side.ca, turn);
  return b;
}

/// Strengths apart by powers of ten, so that now this limit comes first and now that.
kernels::Strength random_strength(Noise& noise) {
  const auto factor = [&] { return std::pow(10.0, noise()); };
  return {1.27e5 * factor(), 3.04e4 * factor(), std::tan(0.5585), 4.9e5 * factor(), noise() > 0.0 ? 9.0 : 0.0};
}

}  // namespace

TEST_CASE("the closed form of a whole side equals the sum over its segments to 1e-11") {
  Noise noise(1);
  for (const double mean : {0.5, 0.0, -1.0}) {
    for (int i = 0; i < 200; ++i) {
      SideUnderTest u(1 + i % 8, 1 + i % 5, std::max(mean, 0.0));
      u.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
      const bool on_base = mean < 0.0;
      if (on_base) u.put_onto_base();
      const TwoBodies b = on_base ? random_pose_on_base(u, noise, 1e-6) : random_pose(u, noise, 1e-6);
      const SideStep c = closed_form(u, b, kNoBound);
      const SideStep s = by_segments(u, b);
      REQUIRE_FALSE(c.looked_at);
      REQUIRE(s.result.events == 0);
      const kernels::SideFrame f = u.frame(b);
      const double largest = norm(Vec3{f.d.n, f.d.s1, f.d.s2}) + 0.1 * (std::sqrt(dot(f.ds, f.ds)) + std::sqrt(dot(f.dt, f.dt)));
      const double unit = u.side.k.kn * 8 * 5 * 0.025 * 0.025 * largest;  // k A max|u|
      CHECK(distance(c.force_a, s.force_a) < 1e-11 * unit);
      CHECK(distance(c.force_b, s.force_b) < 1e-11 * unit);
      CHECK(distance(c.torque_a, s.torque_a) < 1e-11 * unit);
      CHECK(distance(c.torque_b, s.torque_b) < 1e-11 * unit);
      CHECK(norm(c.force_a) > 1e-9 * unit);
    }
  }
}

TEST_CASE("the elastic energy of the closed form equals the sum over the segments") {
  Noise noise(2);
  for (int i = 0; i < 50; ++i) {
    SideUnderTest u(4, 8, i % 2 ? 0.5 : 0.0);
    u.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
    const TwoBodies b = random_pose(u, noise, 1e-6);
    const double by_points = energy(u, b).bonds;
    double closed[kernels::kLanes];
    kernels::whole_side_energies(u.block(3), b.pose.data(), closed);
    CHECK(closed[3] == doctest::Approx(by_points).epsilon(1e-11).scale(0.0));
  }
}

TEST_CASE("the certificate never passes a side in which a segment yields, and passes most that are safe") {
  Noise noise(3);
  const kernels::ShearInTension choices[] = {kernels::ShearInTension::cohesion, kernels::ShearInTension::none,
                                             kernels::ShearInTension::coulomb};
  int safe = 0, passed = 0;
  int broke[4] = {};
  for (int i = 0; i < 12000; ++i) {
    SideUnderTest u(4, 4, 0.5);
    u.side.strength = random_strength(noise);
    kernels::FailureOptions o;
    o.in_tension = choices[i % 3];
    o.shear = i % 7 != 0;
    const TwoBodies b = random_pose(u, noise, 6e-5 * std::pow(10.0, noise()));
    const bool certified = !closed_form(u, b, o).looked_at;
    std::vector<kernels::SegmentEvent> events;
    advance(kernels::advance_sides_reference, u, b, 5e-5, 0.0, o, events);
    CHECK_FALSE((certified && !events.empty()));
    for (const kernels::SegmentEvent& e : events) ++broke[static_cast<int>(e.reached)];
    safe += events.empty();
    passed += certified;
  }
  for (const kernels::Mode mode : {kernels::Mode::tension, kernels::Mode::shear, kernels::Mode::compression}) {
    CHECK(broke[static_cast<int>(mode)] > 500);
  }
  CHECK(safe > 2000);
  CHECK(passed > 0.8 * safe);
}

TEST_CASE("a compressive strength far above all others keeps no side from its closed form") {
  Noise noise(8);
  int safe = 0, passed = 0;
  for (int i = 0; i < 4000; ++i) {
    SideUnderTest u(4, 4, 0.5);
    u.side.strength = {1.27e5, 3.04e4, std::tan(0.5585), i % 2 == 0 ? 1e15 : std::numeric_limits<double>::infinity(), 9.0};
    const TwoBodies b = random_pose(u, noise, 3e-5 * std::pow(10.0, noise()));
    safe += by_segments(u, b, kNoBound).result.events == 0;
    passed += !closed_form(u, b, kNoBound).looked_at;
  }
  CHECK(safe > 200);
  CHECK(passed > 0.95 * safe);
}

TEST_CASE("the base takes no force") {
  Noise noise(4);
  SideUnderTest u(4, 4, 0.0);
  u.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
  u.put_onto_base();
  const TwoBodies b = random_pose_on_base(u, noise, 1e-6);
  for (const kernels::FailureOptions o : {kernels::FailureOptions{}, kNoBound}) {
    const SideStep c = closed_form(u, b, o);
    CHECK_FALSE(c.looked_at);
    CHECK(norm(c.force_a) > 0.0);
    CHECK(norm(c.force_base) == 0.0);
  }
  CHECK(norm(by_segments(u, b).force_base) == 0.0);
}

TEST_CASE("an open side is passed over only where no segment touches") {
  Noise noise(5);
  int open = 0, touching = 0;
  for (int i = 0; i < 2000; ++i) {
    SideUnderTest u(4, 3, 0.5);
    std::fill(u.bond.begin(), u.bond.begin() + u.n, kernels::Bond::contact);
    const TwoBodies b = random_pose(u, noise, 1e-5);
    std::vector<kernels::SegmentEvent> events;
    SideUnderTest copy = u;
    const SideStep c = advance(kernels::advance_sides, copy, b, 5e-5, 0.0, {}, events, kernels::SideState::open);
    const bool passed = !c.looked_at;
    const bool touches = by_segments(u, b).result.touching;
    CHECK(passed == !touches);
    open += passed, touching += touches;
    if (passed) CHECK(norm(c.force_a) + norm(c.force_b) + norm(c.torque_a) + norm(c.torque_b) == 0.0);
  }
  CHECK(open > 100);
  CHECK(touching > 100);
}
