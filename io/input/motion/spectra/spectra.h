// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cases/motion.h"

/// Combined spectra of two components, target spectra, and the factor that fits a record to a target.
namespace voussoir::io {

/// Relative displacement [m] of the oscillator of spectral_displacement at `samples` steps from rest; beyond its last sample the record is
/// zero. \throw InputError as spectral_displacement.
std::vector<double> displacement_response(const cases::Accelerogram& a, double frequency_hz, double damping_ratio, std::size_t samples);

/// Median and largest of a value over the directions in the plane (Boore 2010, RotD50 and RotD100): at 0, 1, ... 179 degrees from the first
/// component towards the second. The median is the mean of the 90th and the 91st value.
struct OverDirections {
  double median = 0.0, largest = 0.0;
};
/// \param value  of a direction, an angle in rad
OverDirections over_directions(const std::function<double(double)>& value);

/// Peak relative displacements [m] of two horizontal components combined.
struct CombinedDisplacement {
  double geometric_mean = 0.0;         // of the peaks of both components; depends on the orientation of the instrument
  double rotd50 = 0.0, rotd100 = 0.0;  // median and maximum over the directions in the plane (Boore 2010)
};
/// RotD: over_directions of the peak of the rotated responses, u cos k + v sin k; rotd100 falls short of the true maximum by at most 4e-5.
/// The shorter component is zero after its end.
/// \throw InputError for different steps, and as spectral_displacement.
CombinedDisplacement combined_displacement(const cases::Accelerogram& a, const cases::Accelerogram& b, double frequency_hz,
                                           double damping_ratio);

/// The elastic horizontal spectrum of EN 1998-1:2004, 3.2.2.2, with the recommended parameters of its Tables 3.2 and 3.3.
struct Eurocode8 {
  int type = 1;       // 1, or 2 for earthquakes of magnitude up to 5.5
  char ground = 'A';  // A to E
  double ag = 0.0;    // m/s2, design acceleration on ground A
};
inline constexpr double kEurocode8LongestPeriod = 4.0;  // s
/// S_e(T) [m/s2] for a period from 0 to 4 s; eta = sqrt(10 / (5 + 100 damping)), at least 0.55. \pre type, ground as above
double eurocode8(const Eurocode8& e, double period, double damping_ratio) noexcept;

/// The corner period T_C at the end of its plateau [s].
double eurocode8_corner(const Eurocode8& e) noexcept;
/// Damping correction factor of EN 1998-1:2004, Eq. 3.6 (NTC 2018, Eq. 3.2.4): sqrt(10 / (5 + 100 damping)), at least 0.55.
double damping_factor(double damping_ratio) noexcept;

/// A target spectrum for comparison: Eurocode 8, or a table.
struct TargetSpectrum {
  std::string name;
  std::optional<Eurocode8> code;
  std::vector<double> period, acceleration;  // s ascending, m/s2; used without `code`
};
/// Spectral acceleration [m/s2], linear in period between the rows of a table; nothing outside its range (Eurocode 8: 0 to 4 s).
std::optional<double> value_at(const TargetSpectrum& target, double period, double damping_ratio) noexcept;

/// Fit of a record to a target over some periods.
struct SpectrumFit {
  double factor = 1.0;        // exp of the mean of ln(target / record): the least sum of squares of ln(target / (factor · record))
  double misfit = 0.0;        // root mean square of that logarithm
  double lowest = 0.0;        // least value of factor · record / target
  std::size_t lowest_at = 0;  // its index
};
/// Fits a record to a target. \pre equal lengths of at least 1, all values above 0
SpectrumFit fit(std::span<const double> record, std::span<const double> target);

/// `count` periods [s] from `shortest` to `longest` in equal ratios.
std::vector<double> periods_between(double shortest, double longest, int count);

}  // namespace voussoir::io
