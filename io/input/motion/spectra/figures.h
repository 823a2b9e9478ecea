// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/motion.h"

/// Intensity figures of one component of a record, and its response spectrum.
namespace voussoir::io {

/// Intensity figures of a record. Integrals are trapezoid sums over the samples.
struct MotionFigures {
  double peak_acceleration = 0.0;   // m/s2, absolute
  double peak_time = 0.0;           // s
  double peak_velocity = 0.0;       // m/s, absolute, trapezoid integral from rest
  double peak_displacement = 0.0;   // m
  double arias = 0.0;               // m/s, pi/(2g) ∫ a² dt with g = 9.80665
  double d5_75 = 0.0, d5_95 = 0.0;  // s, significant durations: growth of the Arias integral from 5 % to 75 % (95 %), interpolated
  double duration = 0.0;            // s, time of the last sample
};
/// Computes the figures; all zero for a record without samples.
MotionFigures figures(const cases::Accelerogram& a);

/// Peak relative displacement [m] of a damped oscillator from rest, exact for the piecewise linear record (Nigam-Jennings 1969). The peak
/// is taken over the record's samples: too low for periods below about ten sample steps, and for long periods if the record ends while the
/// oscillator still swings.
/// \param damping_ratio  of critical, 0 <= ratio < 1. \param t_end  only samples up to t_end [s] count.
/// \throw InputError for a frequency or a damping out of range.
double spectral_displacement(const cases::Accelerogram& a, double frequency_hz, double damping_ratio, double t_end = 1e300);

}  // namespace voussoir::io
