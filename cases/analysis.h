// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec3.h"

/// What a run is to find out: a history of the shaking, or a capacity by slow loading.
namespace voussoir::cases {

enum class AnalysisKind : std::uint8_t { time_history, pushover, tilt, settlement, cyclic };
/// How the forces of a pushover are spread: as the masses, as the masses times the first mode, or the loads that grow.
enum class LoadPattern : std::uint8_t { mass, mode, given };

/// Table [analysis]. Of a time history only `kind` counts.
struct Analysis {
  AnalysisKind kind = AnalysisKind::time_history;
  LoadPattern pattern = LoadPattern::mass;
  std::array<double, 2> direction{1.0, 0.0};  // horizontal, x and y; any length
  std::optional<Vec3> control;                // m; a point whose displacement is that of the capacity curve
  double drop = 0.2;                          // the end: this share of the largest base shear (of the multiplier) is lost
  std::optional<double> share;                // of the first stiffness; a smaller tangent is under displacement control
  std::optional<double> pace;                 // s, in which the displacement grows e-fold
  std::optional<double> damping;              // 1/s, mass damping
  double longest = 300.0;                     // s, of the run
  double largest_factor = 5.0;                // load factor at which the run ends
  double largest_drift = 0.2;                 // of the control point, at which the run ends
  std::vector<double> amplitudes;             // m, of the cycles, one after another (cyclic)
  int cycles = 1;                             // at each amplitude
  bool level = false;                         // cyclic: the blocks that are pushed do not turn
};

/// Whether the run is a quasi-static analysis.
inline bool is_assessment(const Analysis& a) noexcept { return a.kind != AnalysisKind::time_history; }

}  // namespace voussoir::cases
