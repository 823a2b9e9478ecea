// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/motion.h"

#include <algorithm>

namespace voussoir::cases {

double acceleration_at(const Accelerogram& a, double t) noexcept {
  const std::size_t n = a.acceleration.size();
  if (n == 0 || !(a.dt > 0.0) || !(t >= 0.0)) return 0.0;
  const double position = t / a.dt;
  if (position >= static_cast<double>(n - 1)) {
    // A clock that adds up steps may pass the last sample by round-off, and still gets the last sample.
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

/// Velocities at the samples, starting from rest [m/s].
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

}  // namespace voussoir::cases
