// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "cases/motion.h"
#include "cases/tables/motion.h"

/// Intensity of a motion as one number, and the factor that scales it to another intensity, for incremental dynamic analysis and fragility
/// curves.
namespace voussoir::io {

inline constexpr double kIntensityDamping = 0.05;  // of critical, for Sa

/// The intensity of two horizontal components, as `of.components` says: the geometric mean of their values; the median over the directions
/// of the horizontal motion, a degree apart (RotD50); the larger value; for `each` the smaller one. A component without samples, or whose
/// value is zero, is ignored; 0 if both are. All samples count, even if a run ends before the last one.
/// - pga: peak ground acceleration, m/s2; pgv: peak ground velocity, m/s, of the motion from rest (MotionFigures);
/// - sa: pseudo-acceleration (2 pi / period)² Sd, m/s2, with 5 % of damping, Sd by spectral_displacement.
/// \pre a period if the measure is sa; for RotD50 components of one time step
double intensity(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b);

/// The factors that bring the two components to `of.level`, and that of the vertical one: equal but for `each`, of which the last is the
/// geometric mean of the others. \throw InputError at "motion.intensity" if neither component moves, or for RotD50 of components with two
/// time steps.
std::array<double, 3> factors_to_reach(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b);

/// The meaning of the level: "the geometric mean of both horizontal components".
const char* meaning_of(cases::IntensityOf components) noexcept;

/// The measure, as "PGA" or "Sa(0.3 s)", and its unit.
std::string intensity_name(const cases::MotionIntensity& of);
const char* intensity_unit(const cases::MotionIntensity& of) noexcept;

/// The intensity in words: "PGA = 3 m/s2", "Sa(0.3 s) = 4 m/s2".
std::string described(const cases::MotionIntensity& of);

}  // namespace voussoir::io
