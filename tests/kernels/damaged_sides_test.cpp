// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numbers>

#include "kernels/laws/contact_law.h"
#include "tests/kernels/side_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr double kStep = 5e-5;

/// One twin: its history, its events, its running losses.
struct Twin {
  SideUnderTest u;
  kernels::AdvanceSides& kernel;
  std::vector<kernels::SegmentEvent> events{};
  double lost = 0.0;
  SideStep last{};

  void step(const TwoBodies& b, double time, kernels::FailureOptions o) {
    last = advance(kernel, u, b, kStep, time, o, events);
    lost += last.result.friction + last.result.impact + last.result.fracture;
  }
};

/// One of two bodies, or the one on the base: they shake, open, slide and close again.
struct Shaker {
  Noise noise;
  int body = 1;  // the one that moves
  Vec3 u{}, turn{}, v{}, w{};
  TwoBodies at(double rate) {
    v = 0.98 * v + noise.vector(rate), w = 0.98 * w + noise.vector(10.0 * rate);
    moved = v - (0.001 / kStep) * u, turned = w - (0.001 / kStep) * turn;
    u = u + kStep * moved, turn = turn + kStep * turned;
    TwoBodies b;
    b.place(body, u, turn);
    b.move(body, moved, turned);
    return b;
  }
  Vec3 moved{}, turned{};  // m/s, rad/s: of the last step
};

void compare(const Twin& a, const Twin& b, double unit) {
  CHECK(distance(a.last.force_a, b.last.force_a) < 1e-10 * unit);
  CHECK(distance(a.last.torque_a, b.last.torque_a) < 1e-10 * unit);
  CHECK(distance(a.last.dash_a, b.last.dash_a) < 1e-10 * unit);
  CHECK(distance(a.last.force_b, b.last.force_b) < 1e-10 * unit);
  CHECK(distance(a.last.torque_b, b.last.torque_b) < 1e-10 * unit);
  const kernels::DamagedSide &x = a.last.result, &y = b.last.result;
  CHECK(x.held == y.held);
  CHECK(x.events == y.events);
  CHECK(x.touching == y.touching);
  CHECK(x.gap == doctest::Approx(y.gap).epsilon(1e-9).scale(1e-6));
  CHECK(x.slide2 == doctest::Approx(y.slide2).epsilon(1e-9).scale(1e-9));
  CHECK(x.tilt2 == doctest::Approx(y.tilt2).epsilon(1e-9).scale(1e-9));
  CHECK(a.u.bond == b.u.bond);
}

/// A bond that opens or slides a few times its elastic way before it is gone: Shaker takes it there and back.
kernels::Softening soft_law(int option) {
  return {.opening = 1.5, .slip = 1e-4, .dilatancy = option % 2 == 0 ? 0.3 : 0.0, .linear = option > 1};
}

/// Shaker presses broken segments harder than this, some of them beyond the depth.
kernels::Crushing crushing_law(int option) {
  return option % 2 == 0 ? kernels::Crushing{.strength = 8e4, .residual = 2e4, .slope = 3e8, .depth = 4e-4}
                         : kernels::Crushing{.strength = 5e4, .depth = 2e-4};
}

/// A dry joint whose stiffness without pressure is the side's: 1/2e9 + 1/2e9 = 1/1e9 m/Pa.
void stiffen(SideUnderTest& u) {
  std::fill_n(u.bond.begin(), u.n, kernels::Bond::contact);  // padding stays bonded, as in a model
  u.closing = {.most = 1e-4, .scale = 1e-4 * 2e9, .blocks = 2e9};
}

/// Shakes both for 800 steps, comparing their forces, and calls `look(bodies)` after each.
template <class Look>
void shake_together(Twin& fast, Twin& plain, std::uint64_t seed, kernels::FailureOptions o, Look look) {
  Shaker shaker{Noise(seed), fast.u.side.on_base ? 0 : 1};
  double unit = 1.0;
  for (int i = 0; i < 800; ++i) {
    const TwoBodies b = shaker.at(1e-2);
    fast.step(b, i * kStep, o);
    plain.step(b, i * kStep, o);
    unit = std::max({unit, norm(plain.last.force_a)});
    compare(fast, plain, unit);
    look(b);
  }
}

}  // namespace

TEST_CASE("vector and plain segments go the same way through cracking, slip and contact") {
  for (int option = 0; option < 5; ++option) {
    kernels::FailureOptions o;
    o.brittle = option == 1;
    o.dashpot_excess = option == 4 ? kernels::kUnbounded : kernels::kBounded;
    o.in_tension = option == 2   ? kernels::ShearInTension::none
                   : option == 3 ? kernels::ShearInTension::coulomb
                                 : kernels::ShearInTension::cohesion;
    int broken = 0, slipped = 0, touching = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      SideUnderTest u(3 + static_cast<int>(seed) % 5, 3, seed % 2 ? 0.5 : 0.0);  // 9 to 21 points: odd tails
      if (seed % 3 == 0) u.put_onto_base();
      Twin fast{u, kernels::advance_sides}, plain{u, kernels::advance_sides_reference};
      shake_together(fast, plain, seed, o, [&](const TwoBodies&) { touching += plain.last.result.touching; });
      REQUIRE(fast.events.size() == plain.events.size());
      for (std::size_t i = 0; i < fast.events.size(); ++i) {
        CHECK(fast.events[i].point == plain.events[i].point);
        CHECK(fast.events[i].broke == plain.events[i].broke);
        broken += plain.events[i].broke != kernels::Mode::none;
        slipped += plain.events[i].reached == kernels::Mode::shear;
      }
      CHECK(fast.lost == doctest::Approx(plain.lost).epsilon(1e-8));
    }
    CHECK(broken > 50);
    if (option == 0) CHECK(slipped > 10);
    CHECK(touching > 100);
  }
}

TEST_CASE("vector and plain segments of a side that softens go the same way") {
  for (int option = 0; option < 4; ++option) {
    CAPTURE(option);
    kernels::FailureOptions o;
    o.in_tension = option == 3 ? kernels::ShearInTension::coulomb : kernels::ShearInTension::cohesion;
    int worn = 0, broken = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SideUnderTest u(3 + static_cast<int>(seed) % 5, 3, seed % 2 ? 0.5 : 0.0);
      if (seed % 3 == 0) u.put_onto_base();
      u.soften(soft_law(option));
      Twin fast{u, kernels::advance_sides}, plain{u, kernels::advance_sides_reference};
      shake_together(fast, plain, seed, o, [&](const TwoBodies&) {
        for (std::size_t k = 0; k < u.wear.size(); ++k) {
          worn += plain.u.wear[k] > 0.0;
          CHECK(fast.u.wear[k] == doctest::Approx(plain.u.wear[k]).epsilon(1e-8).scale(1e-6));
        }
      });
      for (const kernels::SegmentEvent& e : plain.events) broken += e.broke != kernels::Mode::none;
      CHECK(fast.lost == doctest::Approx(plain.lost).epsilon(1e-8));
    }
    CHECK(worn > 1000);
    CHECK(broken > 50);
  }
}

TEST_CASE("vector and plain segments of a dry side that stiffens as it closes go the same way") {
  for (const bool crushes : {false, true}) {
    int stiffer = 0, crushed = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SideUnderTest u(3 + static_cast<int>(seed) % 5, 3, seed % 2 ? 0.5 : 0.0);
      if (seed % 3 == 0) u.put_onto_base();
      stiffen(u);
      if (crushes) u.crush(crushing_law(1));
      Twin fast{u, kernels::advance_sides}, plain{u, kernels::advance_sides_reference};
      shake_together(fast, plain, seed, {}, [&](const TwoBodies& b) {
        const double stored = energy(plain.u, b).contact;
        stiffer += stored > 0.0;
        CHECK(energy(fast.u, b).contact == doctest::Approx(stored).epsilon(1e-8).scale(1e-6));
      });
      for (const double depth : plain.u.crushed) crushed += depth > 0.0;
      CHECK(fast.lost == doctest::Approx(plain.lost).epsilon(1e-8));
    }
    CHECK(stiffer > 500);
    if (crushes) CHECK(crushed > 20);
  }
}

TEST_CASE("vector and plain segments of a side whose contacts crush go the same way") {
  for (int option = 0; option < 8; ++option) {  // from 4 on bonds, too, are crushed, on a cap below what contacts bear at first
    CAPTURE(option);
    int crushed = 0, at_depth = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SideUnderTest u(3 + static_cast<int>(seed) % 5, 3, seed % 2 ? 0.5 : 0.0);
      if (seed % 3 == 0) u.put_onto_base();
      if (option % 4 > 1) u.soften(soft_law(option % 4));
      u.crush(crushing_law(option % 4));
      if (option > 3) u.side.strength.compression = 4e4;
      Twin fast{u, kernels::advance_sides}, plain{u, kernels::advance_sides_reference};
      shake_together(fast, plain, seed, {}, [&](const TwoBodies&) {
        for (std::size_t k = 0; k < u.crushed.size(); ++k) {
          CHECK(fast.u.crushed[k] == doctest::Approx(plain.u.crushed[k]).epsilon(1e-8).scale(1e-6));
        }
      });
      for (const double depth : plain.u.crushed) crushed += depth > 0.0, at_depth += depth == u.crushing.depth;
      CHECK(fast.lost == doctest::Approx(plain.lost).epsilon(1e-8));
    }
    CHECK(crushed > 20);
    MESSAGE(crushed << " points crushed, " << at_depth << " as far as they can be");
  }
}

TEST_CASE("what the springs of a side take is stored or lost, whatever path they are led along, and no loss is a gain") {
  for (kernels::AdvanceSides* kernel : {&kernels::advance_sides, &kernels::advance_sides_reference}) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      Twin t{SideUnderTest(4, 4, 0.5), *kernel};
      const std::uint64_t path = seed > 32 ? seed - 20 : seed;
      if (seed > 32) t.u.crush(crushing_law(static_cast<int>(seed)));
      if (seed > 36) t.u.side.strength.compression = 4e4;
      if (seed > 20) t.u.soften(soft_law(static_cast<int>(seed) % 4));
      t.u.side.k.cn = t.u.side.k.cs = 0.0;
      Shaker shaker{Noise(100 + path)};
      double work = 0.0, most = 0.0, off = 0.0, least_loss = 0.0;  // J; work on the springs by the trapezoid rule
      Vec3 force{}, torque{};
      for (int i = 0; i < 600; ++i) {
        const TwoBodies b = shaker.at(1e-2);
        t.step(b, i * kStep, {});
        work -= 0.5 * kStep * (dot(t.last.force_b + force, shaker.moved) + dot(t.last.torque_b + torque, shaker.turned));
        force = t.last.force_b, torque = t.last.torque_b;
        const kernels::SideEnergy e = energy(t.u, b);
        most = std::max(most, std::abs(work));
        off = std::max(off, std::abs(work - (e.bonds + e.contact) - t.lost));
        least_loss = std::min({least_loss, t.last.result.friction, t.last.result.fracture, t.last.result.impact});
      }
      CAPTURE(seed);
      CHECK(off < 1e-3 * most);  // the work is taken to first order in the turn of a step
      CHECK(least_loss > -(seed > 36 ? 1e-4 : 1e-5) * most);  // (14) goes back along the radius, whatever way the shear turns
      CHECK(t.lost > 0.1 * most);
    }
  }
}

namespace {

/// A smooth path of the moving body, from rest in place: three waves of each displacement, and of the turn about one axis.
struct Path {
  static constexpr double kTime = 600 * kStep;  // s
  Vec3 axis, wave[3];                           // unit; m
  double turn[3];                               // rad
  explicit Path(std::uint64_t seed) {
    Noise noise(seed);
    axis = noise.vector(1.0);
    axis = (1.0 / norm(axis)) * axis;
    for (Vec3& w : wave) w = noise.vector(1e-4);
    for (double& t : turn) t = 1e-3 * noise();
  }
  static double rises(int k, double time) { return std::sin((k + 1) * 2.0 * std::numbers::pi * time / kTime); }
  [[nodiscard]] Vec3 at(double time) const {
    Vec3 sum{};
    for (int k = 0; k < 3; ++k) sum = sum + rises(k, time) * wave[k];
    return sum;
  }
  [[nodiscard]] double angle(double time) const {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += rises(k, time) * turn[k];
    return sum;
  }
};

/// What a dry side that stiffens does along a path in so many steps [J].
struct Books {
  double off = 0.0;     // largest of |work − stored − lost|
  double gained = 0.0;  // sum of the losses of single steps that are below zero
  double lost = 0.0, most = 0.0;
};
Books walk(std::uint64_t seed, bool crushes, int steps) {
  const Path path(seed);
  Twin t{SideUnderTest(4, 4, 0.5), kernels::advance_sides};
  stiffen(t.u);
  if (crushes) t.u.crush(crushing_law(1));
  t.u.side.k.cn = t.u.side.k.cs = 0.0;
  Books books;
  double work = 0.0;
  const double h = Path::kTime / steps;
  Vec3 force{}, torque{};
  for (int i = 1; i <= steps; ++i) {
    const Vec3 u = path.at(i * h), du = u - path.at((i - 1) * h);
    const Vec3 dturn = (path.angle(i * h) - path.angle((i - 1) * h)) * path.axis;
    TwoBodies b;
    b.place(1, u, 2.0 * std::tan(0.5 * path.angle(i * h)) * path.axis);
    b.move(1, (1.0 / h) * du, (1.0 / h) * dturn);
    t.last = advance(t.kernel, t.u, b, h, i * h, {}, t.events);
    const kernels::DamagedSide& r = t.last.result;
    t.lost += r.friction + r.impact + r.fracture;
    for (const double loss : {r.friction, r.impact, r.fracture}) books.gained -= std::min(0.0, loss);
    work -= 0.5 * (dot(t.last.force_b + force, du) + dot(t.last.torque_b + torque, dturn));
    force = t.last.force_b, torque = t.last.torque_b;
    books.most = std::max(books.most, std::abs(work));
    books.off = std::max(books.off, std::abs(work - energy(t.u, b).contact - t.lost));
  }
  books.lost = t.lost;
  return books;
}

}  // namespace

TEST_CASE(
    "what the springs of a dry side take that stiffens as it closes is stored or lost, and half the step leaves a quarter of what the "
    "trapezoid rule misses") {
  for (const bool crushes : {false, true}) {
    CAPTURE(crushes);
    Books sum[3];  // of 600, 1200 and 2400 steps
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
      CAPTURE(seed);
      for (int i = 0; i < 3; ++i) {
        const Books b = walk(200 + seed, crushes, 600 << i);
        CHECK(b.off < 1e-4 * b.most);  // the work is taken to first order in the turn of a step
        CHECK(b.gained < 1e-3 * b.most);
        CHECK(b.lost > 0.0);
        sum[i].off += b.off, sum[i].gained += b.gained, sum[i].lost += b.lost, sum[i].most += b.most;
      }
    }
    for (int i = 1; i < 3; ++i) {
      MESSAGE("off ", sum[i].off / sum[i].most, ", at twice the step ", sum[i - 1].off / sum[i - 1].most, "; gained ",
              sum[i].gained / sum[i].most, ", at twice the step ", sum[i - 1].gained / sum[i - 1].most, "; lost ",
              sum[i].lost / sum[i].most);
      CHECK(sum[i].off < 0.6 * sum[i - 1].off);
      CHECK(sum[i].gained < 0.3 * sum[i - 1].gained);
      CHECK(sum[i].lost == doctest::Approx(sum[i - 1].lost).epsilon(1e-2));
    }
    CHECK(sum[2].lost > 0.1 * sum[2].most);
  }
}

TEST_CASE("dashpots without bounds are Eqs. 9 and 10 as they read: a contact may pull, and bear more than friction") {
  const kernels::Stiffness k{1e9, 4e8, 4e5, 2e5};
  const kernels::Strength strength{1e5, 3e4, 0.6, 4.9e5, 9.0, 0.5};
  const kernels::Local rate{1.0, 2.0, 0.0};
  for (const double excess : {kernels::kBounded, kernels::kUnbounded}) {
    kernels::SegmentState q{.bond = kernels::Bond::contact};
    const kernels::SegmentStep s = kernels::advance_segment(q, {-1e-4, 0.0, 0.0}, rate, kStep, k, strength, {.dashpot_excess = excess});
    const kernels::ContactStep c =
        kernels::advance_contact(-1e-4, {1.0, 0.0, 0.0}, {rate.n, rate.s1, rate.s2}, {}, k, strength.friction, kStep, excess);
    const bool free = excess == kernels::kUnbounded;
    CHECK(s.dashpot.n == doctest::Approx(free ? 4e5 : 1e5));
    CHECK(s.dashpot.s1 == doctest::Approx(free ? 4e5 : 0.0).scale(1.0));
    CHECK(s.traction.n == doctest::Approx(free ? 3e5 : 0.0).scale(1.0));
    CHECK(s.traction.s1 == doctest::Approx(s.dashpot.s1).scale(1.0));  // nothing presses, so no friction
    CHECK(distance(c.dashpot, Vec3{s.dashpot.n, s.dashpot.s1, s.dashpot.s2}) < 1e-6);
  }
}

TEST_CASE("a contact whose dashpot takes all of its spring carries nothing, and is never out of numbers") {
  Noise noise(6);
  for (int i = 0; i < 20000; ++i) {
    kernels::SegmentState q{.bond = i % 2 ? kernels::Bond::contact : kernels::Bond::crushed, .closure = -1e-4 * (1.0 + noise())};
    const kernels::Stiffness k{1e9 * (2.0 + noise()), 4e8, 4e5 * (2.0 + noise()), 2e5};
    const kernels::Local u{q.closure - 1e-8 * (1.0 + noise()), 0.0, 0.0}, rate{10.0, 0.0, 0.0};
    const kernels::SegmentStep s = kernels::advance_segment(q, u, rate, kStep, k, {1e5, 3e4, 0.6, 4.9e5, 9.0}, {});
    REQUIRE(std::abs(s.traction.n) < 1e-9);
    REQUIRE(s.traction.s1 == 0.0);
    REQUIRE(q.slip1 == 0.0);
  }
}
