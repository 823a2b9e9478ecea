// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/laws/closing.h"

#include <doctest/doctest.h>

#include <cmath>

// One point of a dry joint that stiffens as it closes: THEORY.md (17a)-(17d).
using namespace voussoir;

namespace {

constexpr double kFirst = 1.5e10, kMost = 2e-4, kBlocks = 1.6e11;  // Pa/m, m, Pa/m
constexpr kernels::Closing kLaw{.most = kMost, .scale = kFirst * kMost, .blocks = kBlocks};
constexpr double kSpring = 1.0 / (1.0 / kFirst + 1.0 / kBlocks);  // Pa/m, without pressure (5a)

/// m, by which faces come together under the pressure p [Pa]: (17a).
double closing_at(double p) { return p / kLaw.blocks + kLaw.most * p / (kLaw.scale + p); }

/// A point led along a path; the law of contact has a spring of kSpring from its closure on.
struct Point {
  const kernels::Crushing* crushing = nullptr;
  double u = 0.0, crushed = 0.0, closure = 0.0, lost = 0.0, work = 0.0;

  [[nodiscard]] double pressure() const { return std::max(0.0, -kSpring * (u - closure)); }
  [[nodiscard]] double stored() const { return kernels::stored_at(pressure(), kLaw); }
  void lead(double to, int steps) {
    for (const double du = (to - u) / steps; steps > 0; --steps) {
      const double before = pressure();
      u += du;
      const kernels::Closed r = kernels::close_point(u, du, crushed, kSpring, kLaw, crushing);
      closure = r.closure, crushed += r.crushed, lost += r.lost;
      const double n = std::min(0.0, u - closure), n_before = std::min(0.0, u - closure - du);
      lost += 0.5 * kSpring * (n_before * n_before - n * n + (n_before + n) * du);  // what the law of contact books, (28)
      work -= 0.5 * (before + pressure()) * du;
    }
  }
};

}  // namespace

TEST_CASE("the hyperbola: pressure and closing are each other's inverse, and its ends have the stiffnesses that they should") {
  for (double p = 1.0; p < 1e9; p *= 3.7) {
    CHECK(kernels::pressure_at(closing_at(p), kLaw) == doctest::Approx(p).epsilon(1e-10));
    const double c = closing_at(p) - p / kBlocks;                               // of the joint alone
    CHECK(kFirst * c / (1.0 - c / kMost) == doctest::Approx(p).epsilon(1e-3));  // 1 - c/V loses digits where it is small
    CHECK(c < kMost);
  }
  const auto stiffness = [](double x) {
    return (kernels::pressure_at(1.001 * x, kLaw) - kernels::pressure_at(0.999 * x, kLaw)) / (0.002 * x);
  };
  CHECK(stiffness(1e-10) == doctest::Approx(kSpring).epsilon(1e-5));
  CHECK(stiffness(0.1) == doctest::Approx(kBlocks).epsilon(1e-5));
  CHECK(stiffness(0.1) < kBlocks);
  for (const double x : {1e-5, 1e-4, 3e-4}) {
    CHECK(kernels::stiffness_at(kernels::pressure_at(x, kLaw), kLaw) == doctest::Approx(stiffness(x)).epsilon(1e-5));
  }
  CHECK(kernels::pressure_at(-1e-6, kLaw) == 0.0);
}

TEST_CASE("the energy of the hyperbola is the work that closes it") {
  for (const double p : {1e2, 1e4, 1.5e5, 2e5, 3e6, 1e8}) {  // z from 3e-5 to 33
    const double end = closing_at(p);
    double sum = 0.0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) sum += kernels::pressure_at((i + 0.5) / kSteps * end, kLaw) * end / kSteps;
    CHECK(kernels::stored_at(p, kLaw) == doctest::Approx(sum).epsilon(1e-6));
  }
}

TEST_CASE("a point that closes and opens follows the hyperbola both ways and gives back what it took") {
  Point p;
  p.lead(-3e-4, 400);
  CHECK(p.pressure() == doctest::Approx(kernels::pressure_at(3e-4, kLaw)).epsilon(1e-12));
  CHECK(p.work == doctest::Approx(p.stored() + p.lost).epsilon(1e-12));
  CHECK(p.stored() == doctest::Approx(p.work).epsilon(1e-4));  // but for the trapezoid rule
  p.lead(-1e-4, 7);
  CHECK(p.pressure() == doctest::Approx(kernels::pressure_at(1e-4, kLaw)).epsilon(1e-12));
  CHECK(p.work == doctest::Approx(p.stored() + p.lost).epsilon(1e-12));
  p.lead(1e-4, 3);
  CHECK(p.pressure() == 0.0);
  CHECK(p.closure == 0.0);
  CHECK(p.work == doctest::Approx(p.lost).epsilon(1e-9));
  p.lead(-1e-4, 1);
  CHECK(p.pressure() == doctest::Approx(kernels::pressure_at(1e-4, kLaw)).epsilon(1e-12));
}

TEST_CASE("a point that stiffens crushes where it is pressed too hard, and loses what that takes") {
  constexpr double kStrength = 6e6, kResidual = 1e6, kSlope = 4e9;
  constexpr kernels::Crushing kSoftens{.strength = kStrength, .residual = kResidual, .slope = kSlope, .depth = 5e-3};
  Point p{&kSoftens};
  p.lead(-closing_at(0.99 * kStrength), 100);
  CHECK(p.crushed == 0.0);
  const double half = 0.5 * (kStrength + kResidual), by = (kStrength - half) / kSlope;
  p.lead(-(by + closing_at(half)), 500);
  CHECK(p.pressure() == doctest::Approx(half).epsilon(1e-9));
  CHECK(p.crushed == doctest::Approx(by).epsilon(1e-9));
  p.lead(-by, 50);  // unloaded along the hyperbola, which begins where it was crushed to
  CHECK(p.pressure() == doctest::Approx(0.0).scale(1.0));
  p.lead(-(by + closing_at(half)), 50);
  CHECK(p.pressure() == doctest::Approx(half).epsilon(1e-9));
  const double end = 2e-3 + (kStrength - kResidual) / kSlope;
  p.lead(-(end + closing_at(kResidual)), 2000);
  CHECK(p.pressure() == doctest::Approx(kResidual).epsilon(1e-9));
  CHECK(p.lost == doctest::Approx(0.5 * (kStrength - kResidual) * (kStrength - kResidual) / kSlope + kResidual * end).epsilon(2e-3));
  CHECK(p.work == doctest::Approx(p.stored() + p.lost).epsilon(1e-9));
  p.lead(-(5e-3 + closing_at(3e7)), 500);
  CHECK(p.crushed == 5e-3);
  CHECK(p.pressure() == doctest::Approx(3e7).epsilon(1e-9));  // compacted
}
