// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "cases/forward.h"
#include "cases/tables/analysis.h"
#include "solver/run/recorder.h"
#include "solver/world/world.h"

/// Loading of the structure in a quasi-static analysis (kernels/THEORY.md, section 11); each step advances the load once.
///
/// The forces of the pattern, p_i at a load factor of 1 and N in all, act through a spring, as in a testing machine:
///
///   λ = κ (w − q),   q̇ = Σ p_i·v_i / N,   ẇ = min((w_0 + w) / pace, fastest)
///
/// q is the displacement conjugate to the forces, so the spring has a potential: it takes energy from its moving end alone and cannot make
/// the structure swing up. It adds a stiffness matrix of rank one, by which no squared frequency rises by more than
/// κ Σ (p_i²/m_i + T_i·J_i⁻¹·T_i) / N, T_i the torque of p_i.
namespace voussoir::solver {

class LoadProgram {
 public:
  LoadProgram() = default;
  /// With `analysis.level`, also prevents rotation of the pushed blocks by an inverse inertia of 0. A drive is needed before time zero: by
  /// set(), or from a saved state.
  LoadProgram(const cases::Case& c, World& w);

  /// Whether the case is a quasi-static analysis; otherwise this class has no effect.
  [[nodiscard]] bool active() const noexcept { return cases::is_assessment(analysis_); }
  [[nodiscard]] const cases::Analysis& analysis() const noexcept { return analysis_; }
  [[nodiscard]] const Drive& drive() const noexcept { return drive_; }
  /// Sets the drive. \param shape  by element, where cases::has_push_shape: times mass and gravity it is the force at a load factor of 1;
  /// else empty
  void set(const Drive& drive, const std::vector<Vec3>& shape);

  /// Begins loading at time zero. \throw std::logic_error without a drive
  void begin(const World& w);
  /// Where each row is a state of rest: how far the moving end goes in the step ahead [m], instead of the drive's pace.
  void pull(double on) noexcept { pull_ = on; }
  /// Takes a state of rest as a point of the curve; the analysis may end there. \pre as for row()
  void rest_at(const World& w, double base_shear, std::int64_t step);
  /// Direction of the push, unit.
  [[nodiscard]] Vec3 across() const noexcept { return across_; }
  /// Of the push along its direction: -1 on the way back of a cycle.
  [[nodiscard]] double sense() const noexcept { return state_.sense; }
  /// m, of the moving end, until a reversal of the cycles.
  [[nodiscard]] double way_left() const noexcept;
  /// m, of the moving end so far.
  [[nodiscard]] double way() const noexcept { return std::abs(state_.target); }
  /// s, end of the histories of supports.
  [[nodiscard]] double last_support() const noexcept { return last_support_; }
  /// Ends the analysis before this step.
  void end_at(std::int64_t step) noexcept { state_.ended = state_.ended == 0.0 ? static_cast<double>(step) : state_.ended; }
  /// Advances the load at step n. To be called every step, when the rows have the internal forces of n and velocities are those of n − ½.
  void advance(const World& w, std::int64_t step);

  /// The element whose displacement is that of the capacity curve.
  [[nodiscard]] std::int32_t control() const noexcept { return control_; }
  [[nodiscard]] double factor() const noexcept { return state_.factor; }
  /// The load now over its largest so far: base shear, or the load factor of a tilt and where no base shear grows; 1 before there is any.
  [[nodiscard]] double share_of_largest() const noexcept;
  /// Reversals of the cycles so far, and in all (cyclic).
  [[nodiscard]] std::int64_t half_cycles() const noexcept { return static_cast<std::int64_t>(state_.half_cycles); }
  [[nodiscard]] std::int64_t whole_half_cycles() const noexcept {
    return 2 * std::int64_t{analysis_.cycles} * static_cast<std::int64_t>(analysis_.amplitudes.size());
  }
  /// Displacement of the control point at which the analysis ends [m]: analysis.largest_drift of its height.
  [[nodiscard]] double largest_displacement() const noexcept { return analysis_.largest_drift * height_; }
  /// Body acceleration in addition to gravity at this step, and its mean over the last interval [m/s2].
  [[nodiscard]] Vec3 acceleration() const noexcept { return field(state_.factor); }
  [[nodiscard]] Vec3 mean_acceleration() const noexcept { return 0.5 * (field(state_.factor) + field(state_.factor_before)); }
  /// Adds the forces of a push with a shape to the rows. \return their work over the last interval [J]
  double add_forces(World& w) const;
  /// Time in the histories of supports at time t [s].
  [[nodiscard]] double support_time(double t) const noexcept { return follows_supports(analysis_) ? drive_.speed * t : t; }

  /// The step before which the analysis reached its end; 0: not yet.
  [[nodiscard]] std::int64_t ended() const noexcept { return static_cast<std::int64_t>(state_.ended); }
  [[nodiscard]] AssessmentRow row(const World& w, double time) const;

 private:
  friend struct FieldTable;
  struct State {  // doubles only, including counters and flags, since checkpoints store it as one row of doubles (state/field_table.cpp)
    double factor = 0.0, factor_before = 0.0;       // at this step and the last one
    double target = 0.0, moved = 0.0, speed = 0.0;  // m: w, q; m/s: rate of q over the last interval
    double looks = 0.0;                             // number of samples of base shear and load factor since the last means
    double shear_sum = 0.0, factor_sum = 0.0;       // N, 1; sums of these samples
    double shear = 0.0, most_shear = 0.0;           // N, mean over a first period, largest so far
    double mean_factor = 0.0, most_factor = 0.0;    // likewise for the load factor
    double sense = 1.0, half_cycles = 0.0;          // cyclic: direction of the push, number of reversals so far
    double ended = 0.0;                             // see ended()
    Vec3 start;                                     // m, position of the control point at time zero
  };

  [[nodiscard]] Vec3 field(double factor) const noexcept;
  [[nodiscard]] double rate_of(const World& w) const;
  [[nodiscard]] double end_rate() const;
  void look(const World& w);
  void turn_round();
  [[nodiscard]] bool is_over(const World& w) const;
  [[nodiscard]] double control_displacement(const World& w) const;

  cases::Analysis analysis_;
  Vec3 down_, across_;         // unit vectors: gravity, the push
  double gravity_ = 0.0;       // m/s2
  double mass_ = 0.0;          // kg, moving mass
  double last_support_ = 0.0;  // s, end of the histories of supports; infinity: one has no end
  std::int32_t control_ = 0;   // element
  double height_ = 1.0;        // m, height of the control element above the base
  bool no_shear_ = false;      // only moments or vertical loads grow: base shear says nothing of them
  Drive drive_;
  std::vector<Vec3> shape_;
  double pull_ = 0.0;  // m
  State state_;
};

}  // namespace voussoir::solver
