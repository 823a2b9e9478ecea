// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/treatment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::io {
namespace {

using Samples = std::vector<double>;

double last_time(const cases::Accelerogram& a) { return static_cast<double>(a.acceleration.size() - 1) * a.dt; }

/// Checks the window against the longest component; times in s.
void check_window(const std::array<cases::Accelerogram, 3>& components, const cases::MotionTreatment& t, const std::string& prefix) {
  double longest = 0.0, half_step = 0.0;
  for (const cases::Accelerogram& a : components) {
    if (a.acceleration.empty() || last_time(a) < longest) continue;
    longest = last_time(a), half_step = 0.5 * a.dt;
  }
  const double from = t.from.value_or(0.0);
  if (!(from >= 0.0 && from < longest))
    throw cases::InputError(prefix + "from",
                            cases::text(from) + " s; allowed: from 0 to below " + cases::text(longest) + ", where the motion ends");
  if (!t.to) return;
  if (!(*t.to > from))
    throw cases::InputError(prefix + "to", cases::text(*t.to) + " s; allowed: above " + cases::text(from) + ", where the window begins");
  if (*t.to > longest + half_step)
    throw cases::InputError(prefix + "to", cases::text(*t.to) + " s; allowed: up to " + cases::text(longest) + ", where the motion ends");
}

void cut(cases::Accelerogram& a, const cases::MotionTreatment& t, const std::string& prefix) {
  const auto index = [&](double time) { return static_cast<std::size_t>(std::llround(std::min(time, last_time(a)) / a.dt)); };
  const std::size_t first = t.from && *t.from > last_time(a) ? a.acceleration.size() : index(t.from.value_or(0.0));
  const std::size_t end = t.to ? index(*t.to) + 1 : a.acceleration.size();
  if (end < first + 2) {
    throw cases::InputError(prefix + (t.from ? "from" : "to"), "leaves fewer than 2 samples of " + cases::quoted(a.name) +
                                                                   ", which ends at " + cases::text(last_time(a)) +
                                                                   " s and has a step of " + cases::text(a.dt) + " s");
  }
  a.acceleration.resize(end);
  a.acceleration.erase(a.acceleration.begin(), a.acceleration.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Solves the n equations m x = r by elimination with row pivots.
template <std::size_t N>
std::array<double, N> solved(std::array<std::array<double, N>, N> m, std::array<double, N> r) {
  for (std::size_t k = 0; k < N; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < N; ++i) {
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    }
    std::swap(m[k], m[pivot]), std::swap(r[k], r[pivot]);
    for (std::size_t i = k + 1; i < N; ++i) {
      const double factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < N; ++j) m[i][j] -= factor * m[k][j];
      r[i] -= factor * r[k];
    }
  }
  for (std::size_t k = N; k-- > 0;) {
    for (std::size_t j = k + 1; j < N; ++j) r[k] -= m[k][j] * r[j];
    r[k] /= m[k][k];
  }
  return r;
}

/// Factors of the columns in the least-squares fit to `values`.
template <std::size_t N>
std::array<double, N> fitted(const std::array<Samples, N>& columns, const Samples& values) {
  std::array<std::array<double, N>, N> m{};
  std::array<double, N> r{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      for (std::size_t k = 0; k < values.size(); ++k) m[i][j] += columns[i][k] * columns[j][k];
    }
    for (std::size_t k = 0; k < values.size(); ++k) r[i] += columns[i][k] * values[k];
  }
  return solved<N>(m, r);
}

/// 1, s, s², ... at the samples, with s from 0 to 1 over the record.
template <std::size_t N>
std::array<Samples, N> powers(std::size_t samples) {
  std::array<Samples, N> columns;
  for (std::size_t i = 0; i < N; ++i) {
    columns[i].resize(samples);
    for (std::size_t k = 0; k < samples; ++k) {
      const double s = static_cast<double>(k) / static_cast<double>(samples - 1);
      columns[i][k] = i == 0 ? 1.0 : columns[i - 1][k] * s;
    }
  }
  return columns;
}

/// The trapezoid sum from rest, in units of steps.
Samples integrated(const Samples& a) {
  Samples v(a.size(), 0.0);
  for (std::size_t k = 1; k < a.size(); ++k) v[k] = v[k - 1] + 0.5 * (a[k - 1] + a[k]);
  return v;
}

template <std::size_t N>
void take_off(Samples& a, const std::array<Samples, N>& columns, const std::array<double, N>& factors) {
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < a.size(); ++k) a[k] -= factors[i] * columns[i][k];
  }
}

void correct_baseline(cases::Accelerogram& a, cases::Baseline baseline, const std::string& prefix) {
  Samples& s = a.acceleration;
  if (baseline != cases::Baseline::none && s.size() < 4)
    throw cases::InputError(prefix + "baseline", std::string(name(baseline)) + " needs 4 samples or more of " + cases::quoted(a.name));
  if (baseline == cases::Baseline::mean) {
    const auto columns = powers<1>(s.size());
    take_off(s, columns, fitted(columns, s));
  } else if (baseline == cases::Baseline::linear) {
    const auto columns = powers<2>(s.size());
    take_off(s, columns, fitted(columns, s));
  } else if (baseline == cases::Baseline::parabolic) {
    const auto columns = powers<3>(s.size());
    std::array<Samples, 3> velocities;
    for (std::size_t i = 0; i < 3; ++i) velocities[i] = integrated(columns[i]);
    take_off(s, columns, fitted(velocities, integrated(s)));
  }
}

void taper(cases::Accelerogram& a, const std::array<double, 2>& seconds, const std::string& prefix) {
  if (seconds[0] + seconds[1] > last_time(a) * (1.0 + 1e-12)) {
    throw cases::InputError(prefix + "taper", "takes " + cases::text(seconds[0] + seconds[1]) + " s together; allowed: at most the " +
                                                  cases::text(last_time(a)) + " s of " + cases::quoted(a.name));
  }
  const std::size_t n = a.acceleration.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double before = static_cast<double>(k) * a.dt, after = static_cast<double>(n - 1 - k) * a.dt;
    const auto weight = [](double t, double length) { return t < length ? 0.5 * (1.0 - std::cos(std::numbers::pi * t / length)) : 1.0; };
    a.acceleration[k] *= weight(before, seconds[0]) * weight(after, seconds[1]);
  }
}

}  // namespace

const char* name(cases::Baseline baseline) noexcept {
  switch (baseline) {
    case cases::Baseline::mean:
      return "mean";
    case cases::Baseline::linear:
      return "linear";
    case cases::Baseline::parabolic:
      return "parabolic";
    default:
      return "none";
  }
}

std::string described(const cases::MotionTreatment& t) {
  std::string all;
  const auto add = [&](const std::string& what) { all += (all.empty() ? "" : ", ") + what; };
  if (t.from || t.to) add("from " + cases::text(t.from.value_or(0.0)) + (t.to ? " to " + cases::text(*t.to) + " s" : " s on"));
  if (t.baseline != cases::Baseline::none) add(std::string("baseline ") + name(t.baseline));
  if (t.taper != std::array{0.0, 0.0}) add("tapered over " + cases::text(t.taper[0]) + " and " + cases::text(t.taper[1]) + " s");
  return all;
}

void treat(std::array<cases::Accelerogram, 3>& components, const cases::MotionTreatment& t, const std::string& prefix) {
  if (std::all_of(components.begin(), components.end(), [](const cases::Accelerogram& a) { return a.acceleration.empty(); })) return;
  if (t.from || t.to) check_window(components, t, prefix);
  for (const double seconds : t.taper) {
    if (!(seconds >= 0.0) || !std::isfinite(seconds))
      throw cases::InputError(prefix + "taper", cases::text(seconds) + " s; allowed: 0 or more");
  }
  for (cases::Accelerogram& a : components) {
    if (a.acceleration.empty()) continue;
    if (t.from || t.to) cut(a, t, prefix);
    correct_baseline(a, t.baseline, prefix);
    if (t.taper != std::array{0.0, 0.0}) taper(a, t.taper, prefix);
  }
}

}  // namespace voussoir::io
