// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/tables/analysis.h"
#include "geometry/vec3.h"
#include "io/output/measures/capacity/capacity_curve.h"
#include "io/output/measures/capacity/hanging_walls.h"
#include "io/output/measures/capacity/performance.h"

/// Results of a quasi-static analysis: the capacity curve, its bilinear forms, the multiplier, the mechanism. Definitions and sources:
/// io/MEASURES.md.
namespace voussoir::io {

class Hdf5File;

/// One cycle: between two upward zero crossings of the displacement of the forces.
struct Loop {
  double begin = 0.0, end = 0.0;                 // s
  double most = 0.0, least = 0.0;                // m, largest and smallest displacement
  double most_factor = 0.0, least_factor = 0.0;  // largest and smallest load factor
  double first_factor = 0.0, last_factor = 0.0;  // load factor at both ends: equal for a closed loop
  double area = 0.0;                             // J, work of the growing forces
  double dissipated = 0.0;                       // J, all losses of the ledger
  double stored = 0.0;                           // J, growth of the stored energy
  double other_work = 0.0;                       // J, of the other loads: input of the ledger other than the area
  double viscous_damping = 0.0;  // equivalent viscous damping: the area over 4π times the elastic energy of the loop's secant
};

/// The element whose displacement is that of the curve.
struct ControlPoint {
  std::int64_t element = 0;
  std::string part;  // of the building, or name of the block
  Vec3 position;     // m, of its centroid at the start, in the axes of the case file
  bool timber;       // a beam or rafter
};

struct Capacity {
  cases::AnalysisKind kind = cases::AnalysisKind::pushover;
  double drop = 0.2;                    // analysis.drop
  std::optional<ControlPoint> control;  // none: a run of an earlier version, which does not tell
  std::string ended;                    // reason for the end of the run: see MEASURES.md
  double multiplier = 0.0;              // the largest load factor
  double multiplier_at_rest = 0.0;      // largest mean over a tenth of the pace, without the part borne by inertia and mass damping
  double motion_share = 0.0;            // of that mean, the part borne by inertia and mass damping
  double unbalanced = Bilinear::kNone;  // analysis.solver = "equilibrium": largest of the rows; then the shares of motion are 0
  double lost_residual = Bilinear::kNone;  // residual of the ledger where no further state of rest was found; NaN: another end
  double kinetic_share = 0.0;           // largest kinetic energy over the work put in until then
  double fallen_before = 0.0;           // of the mass: what moved by more than half its least size while gravity was put on
  double multiplier_time = 0.0, multiplier_displacement = 0.0;                       // of multiplier_at_rest: s, m of the control point
  double peak_shear = 0.0, peak_displacement = 0.0, peak_time = 0.0;                 // N, m, s
  double first_stiffness = Bilinear::kNone;                                          // N/m
  double ultimate_displacement = Bilinear::kNone, ultimate_drift = Bilinear::kNone;  // m, 1
  double near_collapse = Bilinear::kNone;  // m, of the control point: base shear at 80 % of its largest, whatever `drop` is
  Bilinear ec8, ntc;
  std::optional<Performance> performance;                  // with a demand
  double least_factor = 0.0;                               // cyclic: largest factor in the opposite direction
  double loop_area = 0.0, dissipated = 0.0, stored = 0.0;  // J: work of the pattern's forces; losses; growth of the stored energy
  std::vector<Loop> loops;                                 // cyclic: complete cycles
  double collapse_movement = Bilinear::kNone, collapse_time = Bilinear::kNone;  // settlement: m of a support, s, at which it begins to fall
  std::vector<HangingWall> hanging;                                             // settlement: walls that the ground has left, at the end
  std::vector<std::string> mechanism, mechanism_at_end;                         // bodies that move as one, with their motion
  double mechanism_time = 0.0;                                                  // s, time of the frame
  CapacityCurve curve;

  /// Whether each row is a state of rest: times then count iterations, and speeds are those of the search.
  [[nodiscard]] bool by_rest() const noexcept { return !std::isnan(unbalanced); }
};

/// Complete cycles of a curve. \param weight  N, of all forces at a load factor of 1
std::vector<Loop> loops_of(const CapacityCurve& curve, double weight);

/// The capacity of a run with its mechanism and, where the case has a demand, its performance; nothing for a time history, or for an
/// analysis without rows. \throw FileError
std::optional<Capacity> capacity_of(const Hdf5File& run);
/// The same against another demand than the case's. \throw FileError; cases::InputError at `option` if the run is no pushover
std::optional<Capacity> capacity_under(const Hdf5File& run, const DemandSpectrum& demand, const std::string& option);
/// The capacity of a run without the mechanism.
std::optional<Capacity> capacity_figures(const Hdf5File& run);
/// Whether the analysis has a largest load, after which a mechanism moves.
inline bool has_peak(const Capacity& c) noexcept { return c.kind == cases::AnalysisKind::pushover || c.kind == cases::AnalysisKind::tilt; }

/// The capacity from a curve, without frames and mechanism.
Capacity capacity_of(cases::AnalysisKind kind, double drop, double pace, double weight, double quiet, CapacityCurve curve);

}  // namespace voussoir::io
