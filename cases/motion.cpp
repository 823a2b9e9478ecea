// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace voussoir::cases {

double acceleration_at(const Accelerogram& a, double t) noexcept {
  const std::size_t n = a.acceleration.size();
  if (n == 0 || !(a.dt > 0.0) || !(t >= 0.0)) return 0.0;
  const double position = t / a.dt;
  if (position >= static_cast<double>(n - 1)) {
    // A clock that adds up its steps may pass the last sample by round-off only; that still is the last sample.
    return position <= static_cast<double>(n - 1) * (1.0 + 1e-12) ? a.acceleration.back() : 0.0;
  }
  const auto i = static_cast<std::size_t>(position);
  const double part = position - static_cast<double>(i);
  return (1.0 - part) * a.acceleration[i] + part * a.acceleration[i + 1];
}

Vec3 acceleration_at(const GroundMotion& m, double t) noexcept {
  return {acceleration_at(m.axis[0], t), acceleration_at(m.axis[1], t), acceleration_at(m.axis[2], t)};
}

namespace {

/// At the samples, from rest [m/s].
std::vector<double> velocities(const Accelerogram& a) {
  std::vector<double> v(a.acceleration.size(), 0.0);
  for (std::size_t i = 1; i < v.size(); ++i) v[i] = v[i - 1] + 0.5 * a.dt * (a.acceleration[i - 1] + a.acceleration[i]);
  return v;
}

double velocity_at(const Accelerogram& a, const std::vector<double>& v, double t) noexcept {
  if (v.empty() || !(t > 0.0)) return 0.0;
  const double last = static_cast<double>(v.size() - 1);
  const auto i = static_cast<std::size_t>(std::min(t / a.dt, last));
  const double start = static_cast<double>(i) * a.dt, end = std::min(t, last * a.dt);
  return v[i] + 0.5 * (end - start) * (a.acceleration[i] + acceleration_at(a, end));
}

}  // namespace

GroundVelocity::GroundVelocity(const GroundMotion& m) : motion_(m) {
  for (std::size_t k = 0; k < 3; ++k) at_samples_[k] = velocities(m.axis[k]);
}

Vec3 GroundVelocity::at(double t) const noexcept {
  const auto along = [&](std::size_t k) { return velocity_at(motion_.axis[k], at_samples_[k], t); };
  return {along(0), along(1), along(2)};
}

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

MotionFigures figures(const Accelerogram& a) {
  MotionFigures f;
  const std::vector<double>& s = a.acceleration;
  if (s.empty()) return f;
  std::vector<double> squares(s.size(), 0.0);
  const std::vector<double> velocity = velocities(a);
  double displacement = 0.0;
  f.peak_acceleration = std::abs(s[0]);
  for (std::size_t i = 1; i < s.size(); ++i) {
    displacement += 0.5 * a.dt * (velocity[i - 1] + velocity[i]);
    squares[i] = squares[i - 1] + 0.5 * a.dt * (s[i - 1] * s[i - 1] + s[i] * s[i]);
    if (std::abs(s[i]) > f.peak_acceleration) {
      f.peak_acceleration = std::abs(s[i]);
      f.peak_time = static_cast<double>(i) * a.dt;
    }
    f.peak_velocity = std::max(f.peak_velocity, std::abs(velocity[i]));
    f.peak_displacement = std::max(f.peak_displacement, std::abs(displacement));
  }
  f.duration = static_cast<double>(s.size() - 1) * a.dt;
  f.arias = std::numbers::pi / (2.0 * kStandardGravity) * squares.back();
  const double start = time_of_share(squares, a.dt, 0.05);
  f.d5_75 = time_of_share(squares, a.dt, 0.75) - start;
  f.d5_95 = time_of_share(squares, a.dt, 0.95) - start;
  return f;
}

}  // namespace voussoir::cases
