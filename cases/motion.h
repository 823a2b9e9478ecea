// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/vec3.h"

/// Ground motion as data: what shakes the base (Eq. 15). Files are read in io/.
namespace voussoir::cases {

/// Standard gravity, m/s2: the g of records in units of g and of the Arias intensity (the weight of the model has its own, see Gravity).
inline constexpr double kStandardGravity = 9.80665;

/// One component: equally spaced samples from t = 0.
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
  double factor = 1.0;  // by which all components were multiplied to reach Motion::intensity; 1 without it
};
/// Ground acceleration at time t [s], m/s2. Zero for t < 0.
Vec3 acceleration_at(const GroundMotion& m, double t) noexcept;

/// Velocity of the ground that starts from rest at t = 0: the integral of acceleration_at, exact for its straight lines.
class GroundVelocity {
 public:
  explicit GroundVelocity(const GroundMotion& m);
  /// m/s; zero for t < 0, constant after the last sample.
  [[nodiscard]] Vec3 at(double t) const noexcept;

 private:
  GroundMotion motion_;
  std::array<std::vector<double>, 3> at_samples_;  // m/s
};

/// What engineers ask of a record. Integrals are trapezoid sums over the samples.
struct MotionFigures {
  double peak_acceleration = 0.0;   // m/s2, absolute
  double peak_time = 0.0;           // s
  double peak_velocity = 0.0;       // m/s, absolute, trapezoid integral from rest
  double peak_displacement = 0.0;   // m
  double arias = 0.0;               // m/s, pi/(2g) ∫ a² dt with g = 9.80665
  double d5_75 = 0.0, d5_95 = 0.0;  // s, significant durations: the Arias integral grows from 5 % to 75 % (95 %), interpolated
  double duration = 0.0;            // s, of the last sample
};
/// All zero for a record without samples.
MotionFigures figures(const Accelerogram& a);

/// Peak relative displacement [m] of a damped oscillator from rest, exact for the piecewise linear record (Nigam-Jennings 1969).
/// The peak is taken over the record's samples: too low for periods below about ten sample steps, and for long ones where the record ends
/// while it still swings.
/// \param damping_ratio of critical, 0 <= ratio < 1. \param t_end only samples up to t_end [s] count.
/// \throw InputError for a frequency or a damping out of range.
double spectral_displacement(const Accelerogram& a, double frequency_hz, double damping_ratio, double t_end = 1e300);

/// The synthetic three-component records: L, T, V; 21 s at 0.005 s. Every compiled program makes them with the same bits, on processors
/// with FMA and with glibc's mathematics. Made to meet the published figures of a near-fault main shock (catalogue/bam-like.md lists
/// targets and achieved figures). Never the real record.
///  - "bam-like", also "bam-like-1": the record of the catalogue's tables; its pulse has a period of 2.8 s.
std::array<Accelerogram, 3> bam_like_1();
///  - "bam-like#7": a realisation of the family, whose pulse has the published period of 2.02 s. Each meets the same figures with other
///    short waves. \throw InputError for a number outside 1 to kMostRealisations.
std::array<Accelerogram, 3> bam_like(int realisation);
inline constexpr int kMostRealisations = 999;

}  // namespace voussoir::cases
