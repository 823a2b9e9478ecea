// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/vec3.h"

/// Accelerations of the followed points as an instrument there would write them.
namespace voussoir::io {

class Hdf5File;

/// A low-pass of Butterworth's, fourth order, causal: two second-order sections by the bilinear transform, its corner (-3 dB) kept in place
/// (prewarped). It starts from rest.
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

/// Of one followed element, in the rows of /history.
struct PointAcceleration {
  std::string name;
  std::vector<Vec3> acceleration;  // m/s2, absolute: of the base and relative to it
  double peak_horizontal = 0.0;    // m/s2, largest sqrt(x² + y²)
};

struct PointAccelerations {
  std::vector<double> time;  // s, of the rows
  std::vector<PointAcceleration> points;
};

/// Between two rows of /history the velocity of the centroid, relative plus the base's, grows by the mean of its acceleration over that
/// time, exactly: those means go through the low-pass of kInstrumentCorner; the first row is zero. So nothing above half the rate of the
/// rows is folded into what is shown but what the mean lets through (of 950 Hz, rows at 1 kHz: a twentieth), and the curve lags by half an
/// interval and the filter's delay, 8.3 ms for slow motion.
/// \return nothing where /history has less than two rows, or fewer than four in a period of the corner. Of a run that has no /motion (an
/// earlier version's) they are those relative to the base
PointAccelerations point_accelerations(const Hdf5File& run);

/// The group /acceleration: `time`, and rows×3 by the names of the points. \throw FileError
void write_accelerations(Hdf5File& file, const PointAccelerations& a);

}  // namespace voussoir::io
