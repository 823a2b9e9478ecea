// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

/// Force of each [[load]] and displacement of the place where it acts, along the force, over a run (io/MEASURES.md).
namespace voussoir::io {

class Hdf5File;

/// The rows of one load. Force and displacement count along the direction of the force where that is first largest, but
/// for round-off: of one that turns with its block, its first direction.
struct LoadCurve {
  std::string name, place;           // "load 1"; "on front wall, storey 2, at (1.20, 0.10, 5.15) m"
  std::vector<double> time;          // s
  std::vector<double> force;         // N
  std::vector<double> displacement;  // m, from time zero; NaN: the load acts nowhere
};

struct LoadMeasures {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::string name, place;                                                    // of the curve
  double peak_force = 0;                                                      // N, the largest
  double peak_force_time = 0;                                                 // s, of it
  double displacement_at_peak = 0;                                            // m, at that time; NaN: acts nowhere
  double peak_displacement = kNone;                                           // m, the largest in magnitude
  double peak_displacement_time = kNone, force_at_peak_displacement = kNone;  // s, N
  double end_force = 0, end_displacement = 0;                                 // N, m
};

/// The loads of a run that have a force at some time; those that are moments alone are left out. Empty for a run without rows of loads.
/// \throw FileError
std::vector<LoadCurve> load_curves(const Hdf5File& run);

std::vector<LoadMeasures> load_measures(const Hdf5File& run);

}  // namespace voussoir::io
