// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/vec3.h"

/// Accelerations of followed points, filtered like records of an instrument.
namespace voussoir::io {

class Hdf5File;

/// A causal Butterworth low-pass of fourth order: two second-order sections by the bilinear transform, with prewarped corner frequency (-3
/// dB). Starts from rest.
class LowPass {
 public:
  /// \pre 0 < corner [Hz] < half the rate [Hz]
  LowPass(double corner, double rate);
  double operator()(double value) noexcept;

 private:
  struct Section {
    double b0, b1, b2, a1, a2;
    double s1 = 0.0, s2 = 0.0;  // state, transposed direct form II
  };
  Section first_, second_;
};

inline constexpr double kInstrumentCorner = 50.0;  // Hz
/// Rows of /history at most: all of them are in memory at once, 24 bytes a row and point (6,000 s at 1 ms).
inline constexpr std::uint64_t kMostInstrumentRows = 6'000'000;

/// Acceleration of one followed element, at the rows of /history.
struct PointAcceleration {
  std::string name;
  std::vector<Vec3> acceleration;  // m/s2, absolute: base plus relative
  double peak_horizontal = 0.0;    // m/s2, largest sqrt(x² + y²)
};

struct PointAccelerations {
  std::vector<double> time;  // s, of the rows
  std::vector<PointAcceleration> points;
};

/// Accelerations of all followed points. The change of the centroid's absolute velocity between two rows of /history is exactly the mean of
/// its acceleration over that time: these means pass the low-pass of kInstrumentCorner; the first row is zero. Frequencies above half the
/// rate of the rows are therefore aliased only as far as the mean transmits them (950 Hz, rows at 1 kHz: a twentieth). The curve lags by
/// half an interval plus the filter's delay, 8.3 ms for slow motion.
/// \return empty if /history has fewer than two rows, more than `most_rows`, or fewer than four per period of the corner. For a run
/// without /motion (of an earlier version) accelerations are relative to the base
PointAccelerations point_accelerations(const Hdf5File& run, std::uint64_t most_rows = kMostInstrumentRows);

/// Writes the group /acceleration: `time`, and rows×3 by the names of the points. \throw FileError
void write_accelerations(Hdf5File& file, const PointAccelerations& a);

}  // namespace voussoir::io
