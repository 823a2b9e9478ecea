// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/case.h"
#include "cases/motion.h"

/// How strong a motion is, as one number, and the factor that gives it another strength: what incremental dynamic analysis and fragility
/// curves are drawn over.
namespace voussoir::io {

inline constexpr double kIntensityDamping = 0.05;  // of critical, of Sa

/// The measure of two horizontal components together: the geometric mean of the values of the two. A component without samples, or whose
/// value is zero, does not count; 0 if neither has one. Taken over all samples, also where a run ends before the last one.
///  - pga: peak ground acceleration, m/s2;  pgv: peak ground velocity, m/s, of the motion from rest (MotionFigures);
///  - sa: pseudo-acceleration (2 pi / period)² Sd, m/s2, with 5 % of damping, Sd as spectral_displacement finds it.
/// \pre a period if the measure is sa
double intensity(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b);

/// The factor that brings the two components to `of.level`. \throw InputError at "motion.intensity" if no factor does: neither moves.
double factor_to_reach(const cases::MotionIntensity& of, const cases::Accelerogram& a, const cases::Accelerogram& b);

/// "PGA = 3 m/s2", "Sa(0.3 s) = 4 m/s2".
std::string described(const cases::MotionIntensity& of);

}  // namespace voussoir::io
