// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

/// Table [motion] of the case file.
namespace voussoir::cases {

enum class Baseline { none, mean, linear, parabolic };
/// Treatment of the components of a motion before scaling (io/input/motion/treatment.h).
struct MotionTreatment {
  std::optional<double> from, to;         // s of the record: the window used as motion; its start is time zero
  Baseline baseline = Baseline::none;     // subtracted from the window
  std::array<double, 2> taper{0.0, 0.0};  // s, at the start and at the end
};

enum class IntensityMeasure { pga, pgv, sa };
/// The horizontal value that a level prescribes. each: the value of each of the two components, which then have a factor each; EN
/// 1998-1:2004, 3.2.2.1(3)P, gives both the same spectrum. The others are one value of both components, which then have one factor: the
/// geometric mean, the median over all horizontal directions, the larger of the two.
enum class IntensityOf { each, geometric_mean, rotd50, larger };
/// Intensity level to which a motion is scaled (io/input/motion/spectra/intensity.h).
struct MotionIntensity {
  IntensityMeasure measure = IntensityMeasure::pga;
  double level = 0.0;              // m/s2; for PGV m/s
  std::optional<double> period{};  // s, for Sa only
  IntensityOf components = IntensityOf::each;
};

/// Base acceleration: a record (name or folder) with a direction; or files for x, y, z; or files for L, T, V with a direction.
struct Motion {
  std::optional<std::string> record;              // "bam-like", "bam-like#7", a folder holding record.toml, or a file that holds L, T and V
  std::string direction = "LTV";                  // which of L, T, V acts along x, y, z
  std::array<std::optional<std::string>, 3> xyz;  // files; keys x, y, z
  std::array<std::optional<std::string>, 3> ltv;  // files; keys L, T, V
  std::optional<std::string> unit;                // "g", "m/s2", "cm/s2": for formats without a unit
  std::optional<double> dt;                       // s: for formats without a time step
  MotionTreatment treatment;                      // keys from, to, baseline, taper
  std::array<double, 3> scale{1.0, 1.0, 1.0};     // of L, T, V (or of x, y, z for files given as such)
  std::optional<MotionIntensity> intensity;       // level reached after `scale` by one more factor for all components
};

}  // namespace voussoir::cases
