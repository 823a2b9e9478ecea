// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/motion/intensity.h"

#include <cmath>
#include <numbers>

#include "cases/names.h"

namespace voussoir::cases {
namespace {

double of_one(const MotionIntensity& of, const Accelerogram& a) {
  switch (of.measure) {
    case IntensityMeasure::pga:
      return figures(a).peak_acceleration;
    case IntensityMeasure::pgv:
      return figures(a).peak_velocity;
    case IntensityMeasure::sa:
      break;
  }
  const double w = 2.0 * std::numbers::pi / *of.period;
  return w * w * spectral_displacement(a, 1.0 / *of.period, kIntensityDamping);
}

}  // namespace

double intensity(const MotionIntensity& of, const Accelerogram& a, const Accelerogram& b) {
  const double of_a = of_one(of, a), of_b = of_one(of, b);
  if (of_a == 0.0 || of_b == 0.0) return of_a + of_b;
  return std::sqrt(of_a) * std::sqrt(of_b);  // of each, lest the product be no number
}

double factor_to_reach(const MotionIntensity& of, const Accelerogram& a, const Accelerogram& b) {
  const double now = intensity(of, a, b);
  const double factor = of.level / now;
  if (!(now > 0.0) || !std::isfinite(now) || !(factor > 0.0) || !std::isfinite(factor))
    throw InputError("motion.intensity", "cannot be " + described(of) + ": of the horizontal components as they are it is " + text(now));
  return factor;
}

std::string described(const MotionIntensity& of) {
  switch (of.measure) {
    case IntensityMeasure::pga:
      return "PGA = " + text(of.level) + " m/s2";
    case IntensityMeasure::pgv:
      return "PGV = " + text(of.level) + " m/s";
    case IntensityMeasure::sa:
      break;
  }
  return "Sa(" + text(*of.period) + " s) = " + text(of.level) + " m/s2";
}

}  // namespace voussoir::cases
