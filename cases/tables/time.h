// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/vec3.h"

/// Tables [gravity], [time] and [damping] of the case file.
namespace voussoir::cases {

struct Gravity {
  Vec3 acceleration{0.0, 0.0, -9.8};  // m/s2
  bool settle = true;                 // ramp gravity and wait for rest before time zero
  std::optional<double> ramp;         // s; default five periods of damping.frequency, else 1 s
  double settle_limit = 3.0;          // s, after the ramp
};

inline constexpr double kLongestRun = 1e6;  // s of shaking: far above any record, and few enough steps to count

struct Time {
  std::optional<double> step;            // s; absent = "auto"
  double duration = 10.0;                // s, after settling
  std::optional<double> after_collapse;  // s; the run ends this long after the building has collapsed, or at its duration
  int multirate = 1;                     // steps from one evaluation of soft pairs to the next; 1: all pairs in every step
};

struct Damping {
  double ratio = 0.0;               // fraction of critical damping at `frequency`
  std::optional<double> frequency;  // Hz
  bool own_frequency = false;       // frequency = "auto": frequency of the mode with the largest mass in y; set by io
  std::optional<double> alpha;      // 1/s; instead of ratio and frequency
  bool debris = true;               // "keep" | "off": mass damping of elements without a bond
  bool inertial = false;            // key: frame, "ground" | "inertial": frame of the damped velocities
};

}  // namespace voussoir::cases
