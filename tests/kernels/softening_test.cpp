// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/laws/softening.h"

#include <doctest/doctest.h>

#include <numbers>

// One segment that softens, led along paths with closed forms: THEORY.md (13a)-(13e).
using namespace voussoir;
using kernels::Local;

namespace {

constexpr double kStep = 5e-5;                   // s
constexpr double kModeI = 12.0, kModeII = 40.0;  // J/m2
constexpr kernels::Stiffness kSprings{2e10, 8e9, 0.0, 0.0};
constexpr kernels::Strength kBond{.tension = 2e5, .cohesion = 3e5, .tan_phi = 0.75, .compression = 1e7, .cap = 1.0, .friction = 0.6};

/// A segment under test: everything that it has lost so far.
struct Segment {
  kernels::Softening law;
  kernels::Strength bond = kBond;
  kernels::FailureOptions options{};
  kernels::SegmentState state{};
  double wear = 0.0;
  Local u{};
  double fracture = 0.0, friction = 0.0, impact = 0.0;  // J/m2
  kernels::SegmentStep last{};

  /// Goes to `to` in even steps.
  void lead(Local to, int steps) {
    const Local du = (1.0 / steps) * (to - u);
    for (int i = 0; i < steps; ++i) {
      u = u + du;
      last = kernels::advance_soft_segment(state, wear, u, (1.0 / kStep) * du, kStep, kSprings, bond, law, options);
      fracture += last.fracture, friction += last.friction, impact += last.impact;
    }
  }
  [[nodiscard]] double tau() const { return std::hypot(last.traction.s1, last.traction.s2); }
};

double length_of(double energy, double strength, double k) { return (energy - 0.5 * strength * strength / k) / strength; }

kernels::Softening softening(bool linear, double dilatancy = 0.0) {
  return {.opening = length_of(kModeI, kBond.tension, kSprings.kn) * kSprings.kn / kBond.tension,
          .slip = length_of(kModeII, kBond.cohesion, kSprings.ks),
          .dilatancy = dilatancy,
          .linear = linear};
}

const double kElastic = kBond.tension / kSprings.kn;                    // m, opening at the limit
const double kOpening = length_of(kModeI, kBond.tension, kSprings.kn);  // m, u_c

}  // namespace

TEST_CASE("the share that is left is an exponential to the last digits") {
  for (int i = 0; i <= 2000; ++i) {
    const double x = 0.01 * i;
    CHECK(kernels::detail::decay(x) == doctest::Approx(std::exp(-x)).epsilon(4e-16));
  }
  CHECK(kernels::detail::decay(0.0) == 1.0);
  CHECK(kernels::detail::decay(1e9) < 1e-300);
}

TEST_CASE("tension softens along the curve and costs the fracture energy") {
  for (const bool linear : {false, true}) {
    CAPTURE(linear);
    Segment s{softening(linear)};
    s.lead({0.999 * kElastic, 0, 0}, 10);
    CHECK(s.wear == 0.0);
    CHECK(s.last.traction.n == doctest::Approx(0.999 * kBond.tension).epsilon(1e-12));
    for (const double part : {0.2, 0.7, 1.1, 1.6}) {
      s.lead({kElastic + part * kOpening, 0, 0}, 500);
      const double left = linear ? 1.0 - 0.5 * part : std::exp(-part);
      CHECK(s.last.traction.n == doctest::Approx(left * kBond.tension).epsilon(1e-12));
      CHECK(s.state.bond == kernels::Bond::slipped);
    }
    s.lead({kElastic + 8.0 * kOpening, 0, 0}, 20000);
    CHECK(s.state.bond == kernels::Bond::contact);
    CHECK(s.last.traction.n == 0.0);
    CHECK(s.wear == 0.0);
    CHECK(s.fracture == doctest::Approx(kModeI).epsilon(linear ? 1e-6 : 1.1e-3));  // a thousandth of the tail is left out
    CHECK(s.friction + s.impact == 0.0);
  }
}

TEST_CASE("tension unloads to the origin, closes with the whole stiffness and comes back to where it left the curve") {
  Segment s{softening(false)};
  const double far = kElastic + 0.8 * kOpening, sigma = kBond.tension * std::exp(-0.8);
  s.lead({far, 0, 0}, 1000);
  const double lost = s.fracture;
  s.lead({0.25 * far, 0, 0}, 100);
  CHECK(s.last.traction.n == doctest::Approx(0.25 * sigma).epsilon(1e-10));
  s.lead({-1e-6, 0, 0}, 100);
  CHECK(s.last.traction.n == doctest::Approx(-1e-6 * kSprings.kn).epsilon(1e-10));
  s.lead({far, 0, 0}, 100);
  CHECK(s.last.traction.n == doctest::Approx(sigma).epsilon(1e-10));
  CHECK(s.fracture == doctest::Approx(lost).epsilon(1e-9));  // nothing is lost on the way there and back
  CHECK(std::abs(s.impact) < 1e-3 * lost);                   // but what one step over the kink leaves
  s.lead({kElastic + 1.2 * kOpening, 0, 0}, 100);
  CHECK(s.last.traction.n == doctest::Approx(kBond.tension * std::exp(-1.2)).epsilon(1e-10));
}

TEST_CASE("shear under pressure: peak of Mohr and Coulomb, mode II for the cohesion, residual friction") {
  for (const bool linear : {false, true}) {
    for (const double sigma : {0.0, -2e5, -6e5}) {
      CAPTURE(linear);
      CAPTURE(sigma);
      Segment s{softening(linear)};
      s.bond.friction = s.bond.tan_phi;  // friction stays as it is: then the curve has a closed form
      s.lead({sigma / kSprings.kn, 0, 0}, 10);
      const double peak = kBond.cohesion - sigma * kBond.tan_phi, at_peak = peak / kSprings.ks;
      s.lead({s.u.n, at_peak, 0}, 10);
      CHECK(s.tau() == doctest::Approx(peak).epsilon(1e-9));
      const double wear = 0.6, left = linear ? 1.0 - 0.5 * wear : std::exp(-wear);
      s.lead({s.u.n, at_peak + wear * s.law.slip, 0}, 1000);
      CHECK(s.wear == doctest::Approx(wear).epsilon(1e-9));
      CHECK(s.tau() == doctest::Approx(kBond.cohesion * left - sigma * kBond.tan_phi).epsilon(1e-9));
      // Unloading: the initial stiffness.
      const double before = s.tau();
      s.lead({s.u.n, s.u.s1 - 1e-6, 0}, 5);
      CHECK(s.tau() == doctest::Approx(before - 1e-6 * kSprings.ks).epsilon(1e-9));
      s.lead({s.u.n, at_peak + 8.0 * s.law.slip, 0}, 40000);
      CHECK(s.state.bond == kernels::Bond::contact);
      CHECK(s.tau() == doctest::Approx(-sigma * kBond.tan_phi).epsilon(1e-9).scale(1.0));
      CHECK(s.fracture == doctest::Approx(kModeII).epsilon(linear ? 1e-3 : 2e-3));
      // Friction alone: over all that has slipped.
      const double slipped = s.u.s1 - s.tau() / kSprings.ks;
      CHECK(s.friction == doctest::Approx(-sigma * kBond.tan_phi * slipped).epsilon(1e-3).scale(1.0));
    }
  }
}

TEST_CASE("friction goes to what is left of it with cohesion, and forces turn with the slip") {
  Segment s{softening(false)};
  const double sigma = -4e5;
  s.lead({sigma / kSprings.kn, 0, 0}, 10);
  for (int i = 0; i <= 8000; ++i) {
    const double turn = 0.25 * std::numbers::pi, r = i * 2e-7;
    s.lead({s.u.n, r * std::cos(turn), r * std::sin(turn)}, 1);
    if (s.state.bond == kernels::Bond::contact) break;
    if (s.wear == 0.0) continue;
    const double left = std::exp(-s.wear), tan_phi = 0.6 + 0.15 * left;
    CHECK(s.tau() == doctest::Approx(kBond.cohesion * left - sigma * tan_phi).epsilon(5e-3));
    CHECK(s.last.traction.s1 == doctest::Approx(s.last.traction.s2).epsilon(1e-6));
  }
  CHECK(s.state.bond == kernels::Bond::contact);
  CHECK(s.tau() == doctest::Approx(-0.6 * sigma).epsilon(1e-9));
}

TEST_CASE("a bond that has slipped is weaker in tension, one that has opened weaker in shear") {
  Segment s{softening(false)};
  s.lead({0.0, kBond.cohesion / kSprings.ks + 0.5 * s.law.slip, 0}, 2000);
  CHECK(s.wear == doctest::Approx(0.5).epsilon(1e-9));
  // On the curve of tension there: (u, f_t exp(-0.5)), and along the line from the origin up to it.
  const double far = kElastic + 0.5 * kOpening, most = kBond.tension * std::exp(-0.5);
  s.lead({0.0, s.u.s1 - 0.9 * s.tau() / kSprings.ks, 0}, 10);
  s.lead({0.999 * far, s.u.s1, 0}, 200);
  CHECK(s.wear == doctest::Approx(0.5).epsilon(1e-9));
  CHECK(s.last.traction.n == doctest::Approx(0.999 * most).epsilon(1e-9));
  s.lead({kElastic + 1.0 * kOpening, s.u.s1, 0}, 200);
  CHECK(s.wear == doctest::Approx(1.0).epsilon(1e-9));

  Segment t{softening(false)};
  t.lead({kElastic + 0.7 * kOpening, 0, 0}, 1000);
  const double sigma = -1e5, left = std::exp(-0.7);
  t.lead({sigma / kSprings.kn, 0, 0}, 200);
  const double peak = kBond.cohesion * left - sigma * (0.6 + 0.15 * left);
  t.lead({t.u.n, 0.9999 * peak / kSprings.ks, 0}, 200);
  CHECK(t.wear == doctest::Approx(0.7).epsilon(1e-9));
  t.lead({t.u.n, 1.01 * peak / kSprings.ks, 0}, 200);
  CHECK(t.wear > 0.7);
  CHECK(t.tau() == doctest::Approx(peak).epsilon(1e-2));
}

TEST_CASE("the first slip opens the joint, and no more once cohesion is gone") {
  const double tan_psi = 0.4;
  Segment s{softening(false, tan_psi)};
  s.lead({-1e-4, 0, 0}, 10);  // far more than it will open, so it stays pressed
  s.lead({-1e-4, 3e-2, 0}, 60000);
  CHECK(s.state.bond == kernels::Bond::contact);
  // Work of the cohesion over the slip is mode II, so the share left over the slip is mode II / c.
  CHECK(s.state.closure == doctest::Approx(tan_psi * kModeII / kBond.cohesion).epsilon(5e-3));
  CHECK(s.last.traction.n == doctest::Approx(-(1e-4 + s.state.closure) * kSprings.kn).epsilon(1e-9));
  const double opened = s.state.closure;
  s.lead({-1e-4, 2e-2, 0}, 1000);
  CHECK(s.state.closure == opened);
}

TEST_CASE("one energy alone: the other limit is that of a bond that does not soften, on a worn bond too") {
  kernels::Softening tension = softening(false);
  tension.slip = 0.0;
  Segment s{tension};
  s.lead({0, 2.0 * kBond.cohesion / kSprings.ks, 0}, 100);
  CHECK(s.tau() == doctest::Approx(kBond.cohesion).epsilon(1e-12));
  CHECK(s.wear == 0.0);
  CHECK(s.last.reached == kernels::Mode::none);  // said once
  s.options.brittle = true;
  s.lead({0, 3.0 * kBond.cohesion / kSprings.ks, 0}, 10);
  CHECK(s.state.bond == kernels::Bond::contact);

  kernels::Softening shear = softening(false);
  shear.opening = 0.0;
  Segment t{shear};
  t.lead({0, kBond.cohesion / kSprings.ks + 0.5 * shear.slip, 0}, 1000);
  t.lead({0, t.u.s1 - 0.9 * t.tau() / kSprings.ks, 0}, 10);
  t.lead({0.999 * kElastic, t.u.s1, 0}, 10);
  CHECK(t.last.traction.n == doctest::Approx(0.999 * std::exp(-0.5) * kBond.tension).epsilon(1e-9));
  t.lead({1.001 * kElastic, t.u.s1, 0}, 1);
  CHECK(t.state.bond == kernels::Bond::contact);
  CHECK(t.last.traction.n == 0.0);
}
