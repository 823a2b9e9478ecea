// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec3.h"

/// The kind of a run: a time history of the shaking, or a quasi-static analysis that finds a capacity.
namespace voussoir::cases {

enum class AnalysisKind : std::uint8_t { time_history, pushover, tilt, settlement, cyclic, rest };
/// Distribution of the forces of a pushover: by mass, by mass times the first mode, the given loads marked as growing, or by mass times
/// height above the base.
enum class LoadPattern : std::uint8_t { mass, mode, given, triangular };

/// How a quasi-static analysis goes: by slow motion, or from one state of rest to the next (kernels/THEORY.md, section 13).
enum class Solver : std::uint8_t { dynamics, equilibrium };

/// Table [analysis]. A time history uses `kind` only.
struct Analysis {
  AnalysisKind kind = AnalysisKind::time_history;
  std::optional<Solver> solver;  // of a quasi-static analysis; none: equilibrium, but dynamics where `pace` or `damping` is given
  LoadPattern pattern = LoadPattern::mass;
  std::array<double, 2> direction{1.0, 0.0};  // horizontal, x and y; any length
  double eccentricity = 0.0;       // pushover by mass, mode or height: shift of the resultant over the width of the plan across the push
  std::optional<Vec3> control;     // m; the nearest element is the control point of the capacity curve; none: one on top
  std::string control_name;        // in place of the point: of a block, a stone or a part of the house (cases/loads/control_point.h)
  double drop = 0.2;               // the run ends when this share of the largest base shear (of the multiplier) is lost
  std::optional<double> share;     // stiffness of the loading spring over the initial one of the structure; none: 0.5, cyclic: 5
  std::optional<double> pace;      // s, time of an e-fold growth of the displacement; none: 20 first periods, at least 2 s
  std::optional<double> damping;   // 1/s, mass damping; none: a tenth of critical at the first frequency, or less
  double longest = 300.0;          // s, of the run
  double largest_factor = 5.0;     // load factor at which the run ends
  double largest_drift = 0.2;      // of the control point: drift at which the run ends
  std::vector<double> amplitudes;  // m, of the cycles, one after another (cyclic)
  int cycles = 1;                  // at each amplitude
  bool level = false;              // cyclic: the pushed blocks do not rotate
  std::string demand;              // spectrum that the capacity of a pushover is compared with (io/MEASURES.md); empty: none
  double demand_damping = 0.05;    // of critical, of this spectrum
  // Of the solver `equilibrium` alone.
  double tolerance = 1e-4;  // largest unbalanced force over the mean weight of an element, at which a state counts as one of rest
  double path_step = 0.02;  // of the largest load factor so far: how far it goes at most from one state to the next
};

/// Whether the run is a quasi-static analysis.
inline bool is_assessment(const Analysis& a) noexcept { return a.kind != AnalysisKind::time_history; }

/// Whether a pushover has a distribution of its forces over the elements, in place of one acceleration of all masses or given loads.
inline bool has_push_shape(const Analysis& a) noexcept {
  if (a.kind != AnalysisKind::pushover || a.pattern == LoadPattern::given) return false;
  return a.pattern != LoadPattern::mass || a.eccentricity != 0.0;
}

/// Whether the run goes along the histories of supports, to their end.
inline bool follows_supports(AnalysisKind kind) noexcept { return kind == AnalysisKind::settlement || kind == AnalysisKind::rest; }
inline bool follows_supports(const Analysis& a) noexcept { return follows_supports(a.kind); }

/// Whether each row of the run is a state of rest.
inline bool finds_rest(const Analysis& a) noexcept {
  const Solver unless_said = a.pace || a.damping ? Solver::dynamics : Solver::equilibrium;
  return is_assessment(a) && a.solver.value_or(unless_said) == Solver::equilibrium;
}

}  // namespace voussoir::cases
