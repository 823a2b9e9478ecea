// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "solver/joints/joint_energy.h"
#include "solver/run/recorder.h"
#include "solver/world/world.h"

/// The energy ledger. Kinetic energy is Σ ½ m v₋·v₊ (likewise in rotation): with the elastic energy at whole steps it is the invariant of
/// the scheme. Work and losses are computed by the trapezoid rule of the scheme, so a small residual shows that forces, arms and histories
/// are consistent.
namespace voussoir::solver {

class Ledger {
 public:
  Ledger() = default;
  explicit Ledger(const World& w) : support_wrench_(6 * w.supports.size(), 0.0) {}

  /// Restarts the ledger: zeroes all work and losses; the next row is the reference of the residual.
  void restart(World& w);

  /// Adds the work of supports. To be called every step, when all forces are in the rows and before loads are added.
  void add_support_work(const World& w);
  /// Adds the work of the loads over the last step [J]. To be called every step.
  void add_load_work(double work) { loads_ += work; }

  /// Begins a row, before the kick of a step in which a row is due, when sides that came apart in the step have retired. after_drift()
  /// completes it.
  void before_kick(World& w);
  /// Completes and returns the row, after the drift. \param f  of the step, as for its kick
  /// \param counts  the row is a result: its residual is one of those of which the worst is told
  EnergyRow after_drift(const World& w, const kernels::BodyForces& f, double time, bool counts);

  [[nodiscard]] double kinetic_over_elastic() const { return std::abs(last_.kinetic) / (last_.strain + last_.contact + 1e-300); }
  [[nodiscard]] const EnergyRow& last() const { return last_; }
  [[nodiscard]] double worst_residual() const { return worst_; }

 private:
  friend struct FieldTable;
  [[nodiscard]] double kinetic(const World& w) const;
  void sum_losses(const World& w, const kernels::BodyForces& f, EnergyRow& row) const;

  bool fresh_ = true;
  double initial_ = 0.0, loads_ = 0.0, supports_ = 0.0, scale_ = 0.0, worst_ = 0.0;  // J
  std::vector<double> support_wrench_;                                               // 6 per support, of the last step
  std::vector<double> v_, w_, l_;                                                    // of the last half step, 3 per element
  StoredEnergy stored_;
  double patches_ = 0.0;      // J
  std::vector<double> dash_;  // current dashpot force and torque, 6 per element
  EnergyRow last_;
};

}  // namespace voussoir::solver
