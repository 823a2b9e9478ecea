// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/input_error.h"
#include "geometry/nth.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/spectra.h"

namespace voussoir::io {
namespace {

constexpr int kAngles = 180;

/// The largest |u cos + v sin| over all samples.
double peak_along(const std::vector<double>& u, const std::vector<double>& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  double peak = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) peak = std::max(peak, std::abs(c * u[i] + s * v[i]));
  return peak;
}

}  // namespace

OverDirections over_directions(const std::function<double(double)>& value) {
  std::array<double, kAngles> values{};
  for (int k = 0; k < kAngles; ++k) nth(values, k) = value(k * std::numbers::pi / kAngles);
  std::sort(values.begin(), values.end());
  return {0.5 * (values[kAngles / 2 - 1] + values[kAngles / 2]), values.back()};
}

CombinedDisplacement combined_displacement(const cases::Accelerogram& a, const cases::Accelerogram& b, double frequency_hz,
                                           double damping_ratio) {
  if (a.dt != b.dt) throw cases::InputError("", "the two components have different steps; allowed: the same step");
  const std::size_t samples = std::max(a.acceleration.size(), b.acceleration.size());
  const std::vector<double> u = displacement_response(a, frequency_hz, damping_ratio, samples);
  const std::vector<double> v = displacement_response(b, frequency_hz, damping_ratio, samples);
  const OverDirections peaks = over_directions([&](double angle) { return peak_along(u, v, angle); });
  CombinedDisplacement out;
  out.geometric_mean =
      std::sqrt(spectral_displacement(a, frequency_hz, damping_ratio) * spectral_displacement(b, frequency_hz, damping_ratio));
  out.rotd50 = peaks.median, out.rotd100 = peaks.largest;
  return out;
}

}  // namespace voussoir::io
