// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/intensity.h"

#include <cmath>
#include <numbers>

#include "cases/input_error.h"
#include "cases/names.h"
#include "io/input/motion/spectra/figures.h"

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

}  // namespace

double intensity(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b) {
  const double of_a = of_one(of, a), of_b = of_one(of, b);
  if (of_a == 0.0 || of_b == 0.0) return of_a + of_b;
  return std::sqrt(of_a) * std::sqrt(of_b);  // root of each, so that the product does not overflow
}

double factor_to_reach(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b) {
  const double now = intensity(of, a, b);
  const double factor = of.level / now;
  if (!(now > 0.0) || !std::isfinite(now) || !(factor > 0.0) || !std::isfinite(factor))
    throw cases::InputError("motion.intensity",
                            "cannot be " + described(of) + ": of the horizontal components as they are it is " + cases::text(now));
  return factor;
}

std::string described(const cases::MotionIntensity& of) {
  switch (of.measure) {
    case cases::IntensityMeasure::pga:
      return "PGA = " + cases::text(of.level) + " m/s2";
    case cases::IntensityMeasure::pgv:
      return "PGV = " + cases::text(of.level) + " m/s";
    case cases::IntensityMeasure::sa:
      break;
  }
  return "Sa(" + cases::text(*of.period) + " s) = " + cases::text(of.level) + " m/s2";
}

}  // namespace voussoir::io
