// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/intensity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/input_error.h"
#include "cases/names.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/spectra.h"

namespace voussoir::io {
namespace {

double of_one(const cases::MotionIntensity& of, const cases::Accelerogram& a) {
  switch (of.measure) {
    case cases::IntensityMeasure::pga:
      return figures(a).peak_acceleration;
    case cases::IntensityMeasure::pgv:
      return figures(a).peak_velocity;
    case cases::IntensityMeasure::sa:
      break;
  }
  const double w = 2.0 * std::numbers::pi / *of.period;
  return w * w * spectral_displacement(a, 1.0 / *of.period, kIntensityDamping);
}

/// The motion along a direction, by its angle [rad] from the first component towards the second.
cases::Accelerogram along(double angle, const cases::Accelerogram& a, const cases::Accelerogram& b) {
  const double c = std::cos(angle), s = std::sin(angle);
  cases::Accelerogram sum{"", a.dt, std::vector<double>(std::max(a.acceleration.size(), b.acceleration.size()))};
  for (std::size_t i = 0; i < a.acceleration.size(); ++i) sum.acceleration[i] += c * a.acceleration[i];
  for (std::size_t i = 0; i < b.acceleration.size(); ++i) sum.acceleration[i] += s * b.acceleration[i];
  return sum;
}

double rotd50(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b) {
  if (a.dt != b.dt)
    throw cases::InputError("motion.intensity.components", "\"RotD50\" needs horizontal components of one time step, not " +
                                                               cases::text(a.dt) + " and " + cases::text(b.dt) + " s");
  return over_directions([&](double angle) { return of_one(of, along(angle, a, b)); }).median;
}

double checked_factor(const cases::MotionIntensity& of, double now) {
  const double factor = of.level / now;
  if (!(now > 0.0) || !std::isfinite(now) || !(factor > 0.0) || !std::isfinite(factor))
    throw cases::InputError("motion.intensity",
                            "cannot be " + described(of) + ": of the horizontal components as they are it is " + cases::text(now));
  return factor;
}

}  // namespace

double intensity(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b) {
  const double of_a = of_one(of, a), of_b = of_one(of, b);
  if (of_a == 0.0 || of_b == 0.0) return of_a + of_b;
  switch (of.components) {
    case cases::IntensityOf::rotd50:
      return rotd50(of, a, b);
    case cases::IntensityOf::larger:
      return std::max(of_a, of_b);
    case cases::IntensityOf::each:
      return std::min(of_a, of_b);
    case cases::IntensityOf::geometric_mean:
      break;
  }
  return std::sqrt(of_a) * std::sqrt(of_b);  // root of each, so that the product does not overflow
}

std::array<double, 3> factors_to_reach(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b) {
  const double all = checked_factor(of, intensity(of, a, b));
  const double of_a = of_one(of, a), of_b = of_one(of, b);
  if (of.components != cases::IntensityOf::each || of_a == 0.0 || of_b == 0.0) return {all, all, all};
  const double first = checked_factor(of, of_a), second = checked_factor(of, of_b);
  return {first, second, std::sqrt(first) * std::sqrt(second)};
}

const char* meaning_of(cases::IntensityOf components) noexcept {
  switch (components) {
    case cases::IntensityOf::rotd50:
      return "the median over all horizontal directions, by one factor";
    case cases::IntensityOf::larger:
      return "of the larger horizontal component, by one factor";
    case cases::IntensityOf::each:
      return "of each horizontal component, by a factor of its own";
    case cases::IntensityOf::geometric_mean:
      break;
  }
  return "the geometric mean of both horizontal components, by one factor";
}

std::string intensity_name(const cases::MotionIntensity& of) {
  switch (of.measure) {
    case cases::IntensityMeasure::pga:
      return "PGA";
    case cases::IntensityMeasure::pgv:
      return "PGV";
    case cases::IntensityMeasure::sa:
      break;
  }
  return "Sa(" + cases::text(*of.period) + " s)";
}

const char* intensity_unit(const cases::MotionIntensity& of) noexcept {
  return of.measure == cases::IntensityMeasure::pgv ? "m/s" : "m/s2";
}

std::string described(const cases::MotionIntensity& of) {
  return intensity_name(of) + " = " + cases::text(of.level) + " " + intensity_unit(of);
}

}  // namespace voussoir::io
