// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/input_error.h"
#include "cases/motion.h"
#include "cases/names.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/spectra.h"

namespace voussoir::io {
namespace {

/// One exact step of u'' + 2 z w u' + w² u = -a(t), a linear over the step (Nigam and Jennings 1969, Eqs. 2.6-2.8):
///   (u, v) at the end = A (u, v) + B (a at the start, a at the end).
struct OscillatorStep {
  double a11, a12, a21, a22;
  double b11, b12, b21, b22;
};

OscillatorStep oscillator_step(double w, double z, double dt) {
  const double root = std::sqrt(1.0 - z * z), wd = w * root;
  const double e = std::exp(-z * w * dt), s = std::sin(wd * dt), c = std::cos(wd * dt);
  const double w2 = w * w, w3 = w2 * w;
  const double p = (2.0 * z * z - 1.0) / (w2 * dt), q = 2.0 * z / (w3 * dt);
  const double rising = c - z / root * s, falling = wd * s + z * w * c;
  OscillatorStep k{};
  k.a11 = e * (z / root * s + c);
  k.a12 = e / wd * s;
  k.a21 = -w / root * e * s;
  k.a22 = e * rising;
  k.b11 = e * ((p + z / w) * s / wd + (q + 1.0 / w2) * c) - q;
  k.b12 = -e * (p * s / wd + q * c) - 1.0 / w2 + q;
  k.b21 = e * ((p + z / w) * rising - (q + 1.0 / w2) * falling) + 1.0 / (w2 * dt);
  k.b22 = -e * (p * rising - q * falling) - 1.0 / (w2 * dt);
  return k;
}

/// \throw InputError for an invalid frequency or damping
void check_oscillator(double frequency_hz, double damping_ratio) {
  if (!(frequency_hz > 0.0) || !std::isfinite(frequency_hz)) {
    throw cases::InputError("", "oscillator frequency is " + cases::text(frequency_hz) + " Hz; allowed: above 0");
  }
  if (!(damping_ratio >= 0.0 && damping_ratio < 1.0)) {
    throw cases::InputError("", "damping ratio is " + cases::text(damping_ratio) + "; allowed: from 0 to below 1 (of critical)");
  }
}

}  // namespace

double spectral_displacement(const cases::Accelerogram& a, double frequency_hz, double damping_ratio, double t_end) {
  check_oscillator(frequency_hz, damping_ratio);
  if (a.acceleration.empty() || !(t_end >= 0.0)) return 0.0;
  const double last = std::min(std::floor(t_end / a.dt * (1.0 + 1e-12)), static_cast<double>(a.acceleration.size() - 1));
  const auto samples = static_cast<std::size_t>(last) + 1;
  const OscillatorStep k = oscillator_step(2.0 * std::numbers::pi * frequency_hz, damping_ratio, a.dt);
  double u = 0.0, v = 0.0, peak = 0.0;
  for (std::size_t i = 1; i < samples; ++i) {
    const double a0 = a.acceleration[i - 1], a1 = a.acceleration[i], u0 = u;
    u = k.a11 * u0 + k.a12 * v + k.b11 * a0 + k.b12 * a1;
    v = k.a21 * u0 + k.a22 * v + k.b21 * a0 + k.b22 * a1;
    peak = std::max(peak, std::abs(u));
  }
  return peak;
}

std::vector<double> displacement_response(const cases::Accelerogram& a, double frequency_hz, double damping_ratio, std::size_t samples) {
  check_oscillator(frequency_hz, damping_ratio);
  const OscillatorStep k = oscillator_step(2.0 * std::numbers::pi * frequency_hz, damping_ratio, a.dt);
  const auto at = [&](std::size_t i) { return i < a.acceleration.size() ? a.acceleration[i] : 0.0; };
  std::vector<double> response(samples, 0.0);
  double v = 0.0;
  for (std::size_t i = 1; i < samples; ++i) {
    const double a0 = at(i - 1), a1 = at(i), u0 = response[i - 1];
    response[i] = k.a11 * u0 + k.a12 * v + k.b11 * a0 + k.b12 * a1;
    v = k.a21 * u0 + k.a22 * v + k.b21 * a0 + k.b22 * a1;
  }
  return response;
}

}  // namespace voussoir::io
