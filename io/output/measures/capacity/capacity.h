// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cases/analysis.h"

/// What a quasi-static analysis has found: the capacity curve, its bilinear forms, the multiplier, the mechanism. Definitions and their
/// sources: io/MEASURES.md.
namespace voussoir::io {

class Hdf5File;

/// Rows of /assessment and the energies of the same times.
struct CapacityCurve {
  std::vector<double> time;                                            // s
  std::vector<double> factor, displacement, drift, moved, base_shear;  // 1, m, 1, m, N
  std::vector<double> support_moved, over;                             // m, 0 or 1
  std::vector<double> input, kinetic, damping, losses, stored;         // J; losses include damping, stored includes kinetic
};

/// An elastic-perfectly plastic curve.
struct Bilinear {
  double stiffness = kNone, force = kNone, yield = kNone, ultimate = kNone, ductility = kNone;  // N/m, N, m, m, 1
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
};

/// One cycle: from where the displacement of the forces passes zero upwards to where it does so again.
struct Loop {
  double begin = 0.0, end = 0.0;                 // s
  double most = 0.0, least = 0.0;                // m, of the displacement
  double most_factor = 0.0, least_factor = 0.0;  // load factor
  double first_factor = 0.0, last_factor = 0.0;  // load factor at its two ends: the loop is closed where they are equal
  double area = 0.0;                             // J, work of the forces that grow
  double dissipated = 0.0;                       // J, all losses of the ledger
  double stored = 0.0;                           // J, what the stores have gained
  double other_work = 0.0;                       // J, of the other loads: what the ledger was given beside the area
  double viscous_damping = 0.0;                  // equivalent: the area over 4π times the elastic energy of the loop's secant
};

struct Capacity {
  cases::AnalysisKind kind = cases::AnalysisKind::pushover;
  double drop = 0.2;                // analysis.drop
  std::string ended;                // why: see MEASURES.md
  double multiplier = 0.0;          // the largest load factor
  double multiplier_at_rest = 0.0;  // the largest mean over a tenth of the pace, without what inertia and mass damping bore
  double motion_share = 0.0;        // of that mean, what inertia and mass damping bore
  double kinetic_share = 0.0;       // the largest kinetic energy over the work put in, until then
  double multiplier_time = 0.0, multiplier_displacement = 0.0;                       // of that at rest: s, m of the control point
  double peak_shear = 0.0, peak_displacement = 0.0, peak_time = 0.0;                 // N, m, s
  double first_stiffness = Bilinear::kNone;                                          // N/m
  double ultimate_displacement = Bilinear::kNone, ultimate_drift = Bilinear::kNone;  // m, 1
  Bilinear ec8, ntc;
  double least_factor = 0.0;                               // cyclic: the largest the other way
  double loop_area = 0.0, dissipated = 0.0, stored = 0.0;  // J: work of the pattern's forces; losses; what stores have gained
  std::vector<Loop> loops;                                 // cyclic: its whole cycles
  double collapse_movement = Bilinear::kNone, collapse_time = Bilinear::kNone;  // settlement: m of a support, s, from which on it falls
  std::vector<std::string> mechanism, mechanism_at_end;                         // bodies that move as one, and what they do
  double mechanism_time = 0.0;                                                  // s, of the frame
  CapacityCurve curve;
};

/// Cycles that are whole. \param weight  N, of all forces at a load factor of 1
std::vector<Loop> loops_of(const CapacityCurve& curve, double weight);

/// Nothing of a time history, or of an analysis that has no rows yet. \throw FileError
std::optional<Capacity> capacity_of(const Hdf5File& run);
/// The same without the mechanism.
std::optional<Capacity> capacity_figures(const Hdf5File& run);
/// Whether a load grows up to a largest one, after which a mechanism moves.
inline bool has_peak(const Capacity& c) noexcept { return c.kind == cases::AnalysisKind::pushover || c.kind == cases::AnalysisKind::tilt; }

/// The curve alone, without frames: for tests and what needs no mechanism.
Capacity capacity_of(cases::AnalysisKind kind, double drop, double pace, double weight, double quiet, CapacityCurve curve);

}  // namespace voussoir::io
