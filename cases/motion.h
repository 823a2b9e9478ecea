// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/vec3.h"

/// Ground motion as data: the acceleration of the base (Eq. 15). Files are read in io/.
namespace voussoir::cases {

/// Standard gravity [m/s2], used for records in units of g and for the Arias intensity. The weight of the model uses Gravity instead.
inline constexpr double kStandardGravity = 9.80665;

/// One component of a motion: equally spaced samples from t = 0.
struct Accelerogram {
  std::string name;                  // event, station, component; for messages and results
  double dt = 0.0;                   // s
  std::vector<double> acceleration;  // m/s2
};

/// Linear interpolation between samples [m/s2]; zero before the first and after the last sample.
double acceleration_at(const Accelerogram& a, double t) noexcept;

/// Three components on x, y, z; an absent axis has no samples.
struct GroundMotion {
  std::array<Accelerogram, 3> axis;
  std::array<double, 3> factor{1.0, 1.0, 1.0};  // of L, T, V (of x, y, z if files are given so), to reach Motion::intensity
};
/// Ground acceleration at time t [s], m/s2. Zero for t < 0.
Vec3 acceleration_at(const GroundMotion& m, double t) noexcept;

/// Velocity of the ground, starting from rest at t = 0: the integral of acceleration_at, exact for piecewise linear acceleration.
class GroundVelocity {
 public:
  explicit GroundVelocity(const GroundMotion& m);
  /// Velocity at time t [s], m/s; zero for t < 0, constant after the last sample.
  [[nodiscard]] Vec3 at(double t) const noexcept;

 private:
  GroundMotion motion_;
  std::array<std::vector<double>, 3> at_samples_;  // m/s
};

}  // namespace voussoir::cases
