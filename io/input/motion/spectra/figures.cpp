// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cases/motion.h"

namespace voussoir::io {
namespace {

/// Time at which the running integral reaches `share` of its end value.
double time_of_share(const std::vector<double>& running, double dt, double share) {
  const double wanted = share * running.back();
  const auto after = std::lower_bound(running.begin(), running.end(), wanted);
  if (after == running.begin() || after == running.end()) return 0.0;
  const auto i = static_cast<double>(after - running.begin());
  const double below = *(after - 1);
  return dt * (i - 1.0 + (wanted - below) / (*after - below));
}

}  // namespace

MotionFigures figures(const cases::Accelerogram& a) {
  MotionFigures f;
  const std::vector<double>& s = a.acceleration;
  if (s.empty()) return f;
  std::vector<double> squares(s.size(), 0.0);
  double velocity = 0.0, displacement = 0.0;
  f.peak_acceleration = std::abs(s[0]);
  for (std::size_t i = 1; i < s.size(); ++i) {
    const double before = velocity;
    velocity += 0.5 * a.dt * (s[i - 1] + s[i]);
    displacement += 0.5 * a.dt * (before + velocity);
    squares[i] = squares[i - 1] + 0.5 * a.dt * (s[i - 1] * s[i - 1] + s[i] * s[i]);
    if (std::abs(s[i]) > f.peak_acceleration) {
      f.peak_acceleration = std::abs(s[i]);
      f.peak_time = static_cast<double>(i) * a.dt;
    }
    f.peak_velocity = std::max(f.peak_velocity, std::abs(velocity));
    f.peak_displacement = std::max(f.peak_displacement, std::abs(displacement));
  }
  f.duration = static_cast<double>(s.size() - 1) * a.dt;
  f.arias = std::numbers::pi / (2.0 * cases::kStandardGravity) * squares.back();
  const double start = time_of_share(squares, a.dt, 0.05);
  f.d5_75 = time_of_share(squares, a.dt, 0.75) - start;
  f.d5_95 = time_of_share(squares, a.dt, 0.95) - start;
  return f;
}

}  // namespace voussoir::io
