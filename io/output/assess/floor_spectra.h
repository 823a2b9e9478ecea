// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cases/motion.h"
#include "io/input/files/hdf5_file.h"

/// Accelerations of followed points, and floor response spectra for objects that stand or hang there.
namespace voussoir::io {

/// Absolute acceleration of one followed point, x, y, z: acceleration of the base, plus the rate of the point's velocity relative to the
/// base, by central differences of /history/<name>/velocity.
struct FloorAcceleration {
  std::string name;
  std::array<cases::Accelerogram, 3> axis;
  // Peaks, as summary has them: of point_accelerations.h, so below its corner frequency; of `axis` where the rows are too far apart for it.
  std::array<double, 3> peak{};
  double peak_horizontal = 0;  // m/s2, largest sqrt(x² + y²)
  bool low_passed = false;
};

/// Accelerations of the named points. \param base  motion of the base, as in the run \throw FileError
std::vector<FloorAcceleration> floor_accelerations(const Hdf5File& run, const std::vector<std::string>& names,
                                                   const cases::GroundMotion& base);

/// Periods of the spectra [s]: 61 from 0.02 to 4 in equal ratios.
std::vector<double> spectrum_periods();

/// Largest pseudo-acceleration ω² S_d at each period [m/s2]. \param damping  fraction of critical
std::vector<double> spectrum(const cases::Accelerogram& a, const std::vector<double>& periods, double damping);

/// CSV rows "point,axis,damping,period,acceleration" of all points and, as the point "base", of the base's motion.
std::string spectra_csv(const std::vector<FloorAcceleration>& points, const cases::GroundMotion& base, const std::vector<double>& dampings);

}  // namespace voussoir::io
