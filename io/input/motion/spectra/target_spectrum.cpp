// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "io/input/motion/spectra/spectra.h"

namespace voussoir::io {
namespace {

/// Soil factor and corner periods [s].
struct Ground {
  double s, tb, tc, td;
};
constexpr Ground kType1[] = {
    {1.0, 0.15, 0.4, 2.0}, {1.2, 0.15, 0.5, 2.0}, {1.15, 0.20, 0.6, 2.0}, {1.35, 0.20, 0.8, 2.0}, {1.4, 0.15, 0.5, 2.0}};
constexpr Ground kType2[] = {
    {1.0, 0.05, 0.25, 1.2}, {1.35, 0.05, 0.25, 1.2}, {1.5, 0.10, 0.25, 1.2}, {1.8, 0.10, 0.30, 1.2}, {1.6, 0.05, 0.25, 1.2}};

const Ground& ground_of(const Eurocode8& e) noexcept { return (e.type == 1 ? kType1 : kType2)[e.ground - 'A']; }

}  // namespace

double damping_factor(double damping_ratio) noexcept { return std::max(0.55, std::sqrt(10.0 / (5.0 + 100.0 * damping_ratio))); }

double eurocode8_corner(const Eurocode8& e) noexcept { return ground_of(e).tc; }

double eurocode8(const Eurocode8& e, double period, double damping_ratio) noexcept {
  const Ground& g = ground_of(e);
  const double eta = damping_factor(damping_ratio);
  const double plateau = 2.5 * eta, ground = e.ag * g.s;
  if (period < g.tb) return ground * (1.0 + period / g.tb * (plateau - 1.0));  // Eq. 3.2
  if (period <= g.tc) return ground * plateau;                                 // Eq. 3.3
  if (period <= g.td) return ground * plateau * g.tc / period;                 // Eq. 3.4
  return ground * plateau * g.tc * g.td / (period * period);                   // Eq. 3.5
}

std::optional<double> value_at(const TargetSpectrum& target, double period, double damping_ratio) noexcept {
  constexpr double kRoundOff = 1e-9;  // relative, of a computed period
  if (target.code) {
    if (!(period >= 0.0 && period <= kEurocode8LongestPeriod * (1.0 + kRoundOff))) return std::nullopt;
    return eurocode8(*target.code, period, damping_ratio);
  }
  const std::vector<double>& x = target.period;
  const std::vector<double>& y = target.acceleration;
  if (x.empty() || !(period >= x.front() * (1.0 - kRoundOff) && period <= x.back() * (1.0 + kRoundOff))) return std::nullopt;
  const auto after = std::upper_bound(x.begin(), x.end(), period);
  if (after == x.begin()) return y.front();
  if (after == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(after - x.begin());
  const double part = (period - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + part * (y[i] - y[i - 1]);
}

SpectrumFit fit(std::span<const double> record, std::span<const double> target) {
  const auto n = static_cast<double>(record.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < record.size(); ++i) sum += std::log(target[i] / record[i]);
  SpectrumFit out;
  out.factor = std::exp(sum / n);
  double squares = 0.0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double ratio = out.factor * record[i] / target[i];
    squares += std::log(ratio) * std::log(ratio);
    if (i == 0 || ratio < out.lowest) out.lowest = ratio, out.lowest_at = i;
  }
  out.misfit = std::sqrt(squares / n);
  return out;
}

std::vector<double> periods_between(double shortest, double longest, int count) {
  std::vector<double> periods;
  for (int i = 0; i < count; ++i) periods.push_back(shortest * std::pow(longest / shortest, i / (count - 1.0)));
  return periods;
}

}  // namespace voussoir::io
