// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/figures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "cases/case.h"

using namespace voussoir;
using namespace voussoir::cases;
using namespace voussoir::io;

namespace {

constexpr double kPi = std::numbers::pi;

Accelerogram sampled(double dt, std::size_t samples, const std::function<double(double)>& a) {
  Accelerogram out{"test", dt, {}};
  for (std::size_t i = 0; i < samples; ++i) out.acceleration.push_back(a(static_cast<double>(i) * dt));
  return out;
}

/// Largest |u| at the samples of a closed form.
double peak_of(double dt, std::size_t samples, const std::function<double(double)>& u) {
  double peak = 0.0;
  for (std::size_t i = 0; i < samples; ++i) peak = std::max(peak, std::abs(u(static_cast<double>(i) * dt)));
  return peak;
}

/// Classical Runge-Kutta on u'' = -a(t) - 2 z w u' - w² u with many steps in each sample step.
double peak_by_small_steps(const Accelerogram& a, double f, double z, int parts) {
  const double w = 2.0 * kPi * f, h = a.dt / parts;
  const auto slope = [&](double t, double u, double v) { return -acceleration_at(a, t) - 2.0 * z * w * v - w * w * u; };
  double u = 0.0, v = 0.0, peak = 0.0;
  for (std::size_t i = 0; i + 1 < a.acceleration.size(); ++i) {
    for (int k = 0; k < parts; ++k) {
      const double t = static_cast<double>(i) * a.dt + k * h;
      const double k1u = v, k1v = slope(t, u, v);
      const double k2u = v + 0.5 * h * k1v, k2v = slope(t + 0.5 * h, u + 0.5 * h * k1u, v + 0.5 * h * k1v);
      const double k3u = v + 0.5 * h * k2v, k3v = slope(t + 0.5 * h, u + 0.5 * h * k2u, v + 0.5 * h * k2v);
      const double k4u = v + h * k3v, k4v = slope(t + h, u + h * k3u, v + h * k3v);
      u += h / 6.0 * (k1u + 2.0 * k2u + 2.0 * k3u + k4u);
      v += h / 6.0 * (k1v + 2.0 * k2v + 2.0 * k3v + k4v);
    }
    peak = std::max(peak, std::abs(u));
  }
  return peak;
}

}  // namespace

TEST_CASE("figures of a rectangular pulse") {
  const double A = -3.0, dt = 0.01, t0 = 2.0, end = 5.0;
  const Accelerogram a = sampled(dt, 501, [&](double t) { return t < t0 + 0.5 * dt ? A : 0.0; });
  const MotionFigures f = figures(a);
  const double length = t0 + 0.5 * dt;  // the trapezoid rule falls over one step
  CHECK(f.peak_acceleration == 3.0);
  CHECK(f.peak_time == 0.0);
  CHECK(f.peak_velocity == doctest::Approx(3.0 * length).epsilon(1e-12));
  const double displacement = 3.0 * (0.5 * t0 * t0 + 0.5 * dt * (t0 + length) + length * (end - t0 - dt));
  CHECK(f.peak_displacement == doctest::Approx(displacement).epsilon(1e-12));
  CHECK(f.arias == doctest::Approx(kPi / (2.0 * 9.80665) * 9.0 * length).epsilon(1e-12));
  CHECK(f.d5_75 == doctest::Approx(0.70 * length).epsilon(1e-12));
  CHECK(f.d5_95 == doctest::Approx(0.90 * length).epsilon(1e-12));
  CHECK(f.duration == doctest::Approx(end).epsilon(1e-12));
}

TEST_CASE("figures of a sine") {
  const double A = 2.0, T = 0.8, dt = 0.01, w = 2.0 * kPi / T;
  const Accelerogram a = sampled(dt, 801, [&](double t) { return A * std::sin(w * t); });
  const MotionFigures f = figures(a);
  // The trapezoid sum of a sine is the integral times (w dt/2) / tan(w dt/2).
  const double factor = 0.5 * w * dt / std::tan(0.5 * w * dt);
  CHECK(f.peak_acceleration == doctest::Approx(A).epsilon(1e-12));
  // The first peak, or a later one that round-off makes the larger.
  CHECK(std::abs(std::remainder(f.peak_time - 0.25 * T, 0.5 * T)) < 1e-9);
  CHECK(f.peak_velocity == doctest::Approx(2.0 * A / w * factor).epsilon(1e-9));
  CHECK(f.peak_displacement == doctest::Approx(A / w * factor * 8.0).epsilon(1e-9));  // drifts with the mean velocity A/w
  CHECK(f.arias == doctest::Approx(kPi / (2.0 * 9.80665) * 0.5 * A * A * 8.0).epsilon(1e-9));
  CHECK(f.d5_75 == doctest::Approx(0.70 * 8.0).epsilon(1e-9));
  CHECK(f.d5_95 == doctest::Approx(0.90 * 8.0).epsilon(1e-9));
}

TEST_CASE("figures of nothing and of silence are zero") {
  for (const Accelerogram& a : {Accelerogram{}, Accelerogram{"one", 0.01, {0.0}}, Accelerogram{"zeros", 0.01, {0.0, 0.0, 0.0}}}) {
    const MotionFigures f = figures(a);
    CHECK(f.peak_acceleration == 0.0);
    CHECK(f.arias == 0.0);
    CHECK(f.d5_75 == 0.0);
    CHECK(f.d5_95 == 0.0);
  }
}

TEST_CASE("spectral displacement of a step") {
  const double A = 1.7, dt = 0.01;
  const std::size_t n = 1001;
  const Accelerogram a = sampled(dt, n, [&](double) { return A; });
  for (const double f : {0.2, 1.0, 7.0, 30.0}) {
    for (const double z : {0.0, 0.02, 0.3, 0.95}) {
      const double w = 2.0 * kPi * f, wd = w * std::sqrt(1.0 - z * z);
      const double expected = peak_of(dt, n, [&](double t) {
        return -A / (w * w) * (1.0 - std::exp(-z * w * t) * (std::cos(wd * t) + z * w / wd * std::sin(wd * t)));
      });
      CHECK(spectral_displacement(a, f, z) == doctest::Approx(expected).epsilon(1e-9));
    }
  }
}

TEST_CASE("spectral displacement of a ramp") {
  const double r = -0.6, dt = 0.02;
  const std::size_t n = 101;
  const Accelerogram a = sampled(dt, n, [&](double t) { return r * t; });
  for (const double f : {0.2, 1.0, 7.0, 30.0}) {
    for (const double z : {0.0, 0.02, 0.3, 0.95}) {
      const double w = 2.0 * kPi * f, wd = w * std::sqrt(1.0 - z * z);
      const double expected = peak_of(dt, n, [&](double t) {
        const double free = 2.0 * z / w * std::cos(wd * t) + (2.0 * z * z - 1.0) / wd * std::sin(wd * t);
        return -r / (w * w) * (t - 2.0 * z / w + std::exp(-z * w * t) * free);
      });
      CHECK(spectral_displacement(a, f, z) == doctest::Approx(expected).epsilon(1e-9));
    }
  }
}

TEST_CASE("spectral displacement of an uneven motion against small steps") {
  const Accelerogram a = sampled(0.02, 201, [](double t) { return 3.0 * std::sin(11.0 * t * t) + 2.0 * std::cos(40.0 * t); });
  for (const double f : {0.3, 1.3, 4.0, 12.0}) {
    for (const double z : {0.0, 0.05, 0.4}) {
      CHECK(spectral_displacement(a, f, z) == doctest::Approx(peak_by_small_steps(a, f, z, 64)).epsilon(1e-8));
    }
  }
}

TEST_CASE("spectral displacement counts samples up to t_end only") {
  Accelerogram a = sampled(0.1, 51, [](double t) { return t < 2.05 ? 1.0 : 9.0; });
  Accelerogram head = a;
  head.acceleration.resize(21);
  CHECK(spectral_displacement(a, 0.7, 0.05, 2.0) == spectral_displacement(head, 0.7, 0.05));
  CHECK(spectral_displacement(a, 0.7, 0.05, 2.05) == spectral_displacement(head, 0.7, 0.05));
  CHECK(spectral_displacement(a, 0.7, 0.05) > 2.0 * spectral_displacement(head, 0.7, 0.05));
  CHECK(spectral_displacement(a, 0.7, 0.05, -1.0) == 0.0);
  CHECK(spectral_displacement(Accelerogram{}, 0.7, 0.05) == 0.0);
}

TEST_CASE("spectral displacement refuses what is no oscillator") {
  const Accelerogram a{"test", 0.01, {0.0, 1.0}};
  for (const double f : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_WITH_AS(spectral_displacement(a, f, 0.02), doctest::Contains("allowed: above 0"), InputError);
  }
  for (const double z : {-0.01, 1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_WITH_AS(spectral_displacement(a, 1.0, z), doctest::Contains("allowed: from 0 to below 1"), InputError);
  }
}
