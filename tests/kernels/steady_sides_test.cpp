// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "tests/kernels/side_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr double kStep = 5e-5;
constexpr double kAnywhere = 1.0;  // m

kernels::FailureOptions options(int i) {
  const kernels::ShearInTension choices[] = {kernels::ShearInTension::cohesion, kernels::ShearInTension::none,
                                             kernels::ShearInTension::coulomb};
  kernels::FailureOptions o;
  o.in_tension = choices[i % 3];
  o.shear = i % 7 != 0;
  o.brittle = i % 5 == 0;
  return o;
}

/// Some of its segments broken, others slipped.
SideUnderTest damaged(Noise& noise, double mean) {
  SideUnderTest u(5, 3, mean);
  for (std::size_t i = 0; i < static_cast<std::size_t>(u.n); ++i) {
    const double kind = noise();
    if (kind > 0.4) u.bond[i] = kernels::Bond::contact;
    if (kind < -0.4) {
      u.bond[i] = kernels::Bond::slipped, u.first_mode[i] = kernels::Mode::shear;
      u.segments().slip1(static_cast<int>(i)) = 2e-5 * noise();
      u.segments().slip2(static_cast<int>(i)) = 2e-5 * noise();
    }
  }
  return u;
}

struct Pose {
  Vec3 u, turn;
  Pose and_also(Noise& noise, double move) const { return {u + noise.vector(move), turn + noise.vector(10.0 * move)}; }
};
/// The slave in that pose, after the two bodies have gone some way together.
TwoBodies place(const SideUnderTest& side, Vec3 together, Vec3 turned, const Pose& p) {
  TwoBodies b;
  b.place(0, together, turned);
  if (side.side.on_base) {  // the master in that pose, turned on its centre
    b.place(0, {}, turned - p.turn);
    b.place(0, -p.u - kernels::load_pose(b.pose.data(), 0).d * side.side.ca, turned - p.turn);
    return b;
  }
  const Vec3 between = side.side.ca - side.side.cb;
  b.place(1, together + kernels::load_pose(b.pose.data(), 0).d * between + p.u, turned + p.turn);
  return b;
}

SideStep step(kernels::AdvanceSides& kernel, SideUnderTest& u, const TwoBodies& b, kernels::FailureOptions o,
              kernels::SideState state = kernels::SideState::segments) {
  std::vector<kernels::SegmentEvent> events;
  return advance(kernel, u, b, kStep, 0.0, o, events, state);
}

bool same_history(const SideUnderTest& a, const SideUnderTest& b) {
  const auto same = [](const kernels::SegmentSprings& x, const kernels::SegmentSprings& y) {
    return std::ranges::equal(x.slip1, y.slip1) && std::ranges::equal(x.slip2, y.slip2) && std::ranges::equal(x.closure, y.closure);
  };
  return a.bond == b.bond && a.first_mode == b.first_mode && std::ranges::equal(a.springs, b.springs, same);
}

}  // namespace

TEST_CASE("a side said to be steady is one in which no segment changes, and has the forces of its segments") {
  Noise noise(11);
  int steady = 0, stays = 0, unchanged = 0, changed = 0;
  for (int i = 0; i < 20000; ++i) {
    const kernels::FailureOptions o = options(i);
    SideUnderTest u = damaged(noise, i % 2 ? 0.5 : 0.0);
    const bool on_base = i % 3 == 0;
    if (on_base) u.put_onto_base();
    const Vec3 together = noise.vector(0.3), turned = noise.vector(on_base ? 1e-4 : 0.2);
    const Pose first = Pose{}.and_also(noise, 2e-5);
    const SideStep looked = step(kernels::advance_sides, u, place(u, together, turned, first), o);
    if (!looked.looked_at || !make_steady(u, looked, kAnywhere, o)) continue;
    ++steady;
    const TwoBodies b = place(u, together, turned, first.and_also(noise, 3e-5 * std::pow(10.0, noise() - 0.5)));
    SideUnderTest copy = u;
    const SideStep fast = step(kernels::advance_sides, u, b, o, kernels::SideState::steady);
    const SideStep plain = step(kernels::advance_sides_reference, copy, b, o);
    const bool changes = !same_history(u, copy) || plain.result.touching;
    changed += changes, unchanged += !changes;
    if (fast.looked_at) continue;
    ++stays;
    REQUIRE_FALSE(changes);
    const kernels::SideFrame f = copy.frame(b);
    const double largest = norm(Vec3{f.d.n, f.d.s1, f.d.s2}) + 0.1 * (std::sqrt(dot(f.ds, f.ds)) + std::sqrt(dot(f.dt, f.dt)));
    const double unit = u.side.k.kn * 5 * 3 * 0.025 * 0.025 * (largest + 2e-5);  // k A max|u - slip|
    CHECK(distance(fast.force_a, plain.force_a) < 1e-11 * unit);
    CHECK(distance(fast.force_b, plain.force_b) < 1e-11 * unit);
    CHECK(distance(fast.torque_a, plain.torque_a) < 1e-11 * unit);
    CHECK(distance(fast.torque_b, plain.torque_b) < 1e-11 * unit);
    CHECK(norm(fast.dash_a) == 0.0);
  }
  CHECK(steady > 1000);
  CHECK(changed > 300);
  CHECK(stays > 0.3 * unchanged);
  MESSAGE(steady << " steady, then " << changed << " change, " << unchanged << " do not, of these " << stays << " are known to");
}

TEST_CASE("a side is not steady if a segment touches, was crushed, slips, or none holds") {
  Noise noise(12);
  const auto tried = [&](auto&& spoil) {
    SideUnderTest u(4, 3, 0.5);
    u.bond[5] = kernels::Bond::contact;
    Pose p{{1e-5, 0.0, 0.0}, {}};  // apart
    spoil(u, p);
    const SideStep s = step(kernels::advance_sides, u, place(u, {}, {}, p), {});
    REQUIRE(s.looked_at);
    return make_steady(u, s, kAnywhere, {});
  };
  CHECK(tried([](SideUnderTest&, Pose&) {}));
  CHECK_FALSE(tried([](SideUnderTest&, Pose& p) { p.u.x = -1e-5; }));
  CHECK_FALSE(tried([](SideUnderTest& u, Pose&) { u.bond[7] = kernels::Bond::crushed, u.segments().closure(7) = 2e-5; }));
  CHECK_FALSE(tried([](SideUnderTest&, Pose& p) { p.u.y = 2e-4; }));
  CHECK_FALSE(tried([](SideUnderTest& u, Pose&) { std::fill_n(u.bond.begin(), u.n, kernels::Bond::contact); }));
}

TEST_CASE("a steady side is looked at before it has slid as far as it may") {
  SideUnderTest u(4, 3, 0.5);
  u.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
  u.bond[5] = kernels::Bond::contact;
  const SideStep s = step(kernels::advance_sides, u, place(u, {}, {}, {{1e-5, 0.0, 0.0}, {}}), {});
  REQUIRE(make_steady(u, s, 1e-3, {}));
  CHECK_FALSE(step(kernels::advance_sides, u, place(u, {}, {}, {{1e-5, 0.9e-3, 0.0}, {}}), {}, kernels::SideState::steady).looked_at);
  CHECK(step(kernels::advance_sides, u, place(u, {}, {}, {{1e-5, 1.1e-3, 0.0}, {}}), {}, kernels::SideState::steady).looked_at);
}

TEST_CASE("a side that cracks and is steady in between goes the way of one whose segments are looked at in every step") {
  int looked_at = 0, passed = 0, found = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const kernels::FailureOptions o = options(static_cast<int>(seed));
    Noise noise(seed);
    SideUnderTest fast(5, 3, 0.5), plain(5, 3, 0.5);
    kernels::SideState state = kernels::SideState::segments;
    std::vector<kernels::SegmentEvent> fast_events, plain_events;
    Vec3 u{3e-5, 0.0, 0.0}, turn{}, v{}, w{};
    double unit = 1.0;
    for (int i = 0; i < 1500; ++i) {
      v = 0.99 * v + noise.vector(3e-3) - 2.0 * u, w = 0.99 * w + noise.vector(3e-2) - 2.0 * turn;  // pulled back to where it began
      u = u + kStep * v, turn = turn + kStep * w;
      TwoBodies b;
      b.place(1, u, turn);
      b.move(1, v, w);
      const SideStep a = advance(kernels::advance_sides, fast, b, kStep, i * kStep, o, fast_events, state);
      const SideStep p = advance(kernels::advance_sides_reference, plain, b, kStep, i * kStep, o, plain_events);
      unit = std::max(unit, norm(p.force_a));
      REQUIRE(distance(a.force_a, p.force_a) < 1e-9 * unit);
      REQUIRE(distance(a.torque_b, p.torque_b) < 1e-9 * unit);
      REQUIRE(fast.bond == plain.bond);
      a.looked_at ? ++looked_at : ++passed;
      if (!a.looked_at) continue;
      const bool steady = i % 8 == 0 && a.result.held > 0 && !a.result.touching && make_steady(fast, a, kAnywhere, o);
      state = steady ? kernels::SideState::steady : kernels::SideState::segments;
      found += steady;
    }
    REQUIRE(fast_events.size() == plain_events.size());
  }
  MESSAGE(found << " times found steady, " << passed << " steps passed over, " << looked_at << " looked at");
  CHECK(found > 200);
  CHECK(passed > 2000);
  CHECK(looked_at > 2000);
}
