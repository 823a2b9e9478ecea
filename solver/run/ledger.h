// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "solver/joints/joint_energy.h"
#include "solver/run/recorder.h"
#include "solver/world/world.h"

/// The energy ledger. Kinetic energy is Σ ½ m v₋·v₊ (likewise in rotation): with the elastic energy at whole steps it is the invariant of
/// the scheme. Works and losses follow the trapezoid rule of the same scheme, so that a closed ledger means consistent forces, arms and
/// histories.
namespace voussoir::solver {

class Ledger {
 public:
  Ledger() = default;
  explicit Ledger(const World& w) : support_wrench_(6 * w.supports.size(), 0.0) {}

  /// Starts anew: zeroes all works and losses; the next row is the balance that the residual is measured against.
  void restart(World& w);

  /// Every step, when all forces are in the rows and before loads are added: work of supports.
  void add_support_work(const World& w);
  /// Every step: work of the loads over the last step [J].
  void add_load_work(double work) { loads_ += work; }

  /// Brackets the kick and drift of a step in which a row is due; before_kick when sides that came apart in it have retired.
  void before_kick(World& w);
  /// \param f  of the step, as for its kick
  EnergyRow after_drift(const World& w, const kernels::BodyForces& f, double time);

  [[nodiscard]] double kinetic_over_elastic() const { return std::abs(last_.kinetic) / (last_.strain + last_.contact + 1e-300); }
  [[nodiscard]] const EnergyRow& last() const { return last_; }
  [[nodiscard]] double worst_residual() const { return worst_; }

 private:
  friend struct FieldTable;
  [[nodiscard]] double kinetic(const World& w) const;
  void sum_losses(const World& w, const kernels::BodyForces& f, EnergyRow& row) const;

  bool fresh_ = true;
  double initial_ = 0.0, loads_ = 0.0, supports_ = 0.0, scale_ = 0.0, worst_ = 0.0;  // J
  std::vector<double> support_wrench_;                                               // 6 a support, of the last step
  std::vector<double> v_, w_, l_;                                                    // of the last half step, 3 an element
  StoredEnergy stored_;
  double patches_ = 0.0;      // J
  std::vector<double> dash_;  // dashpot force and torque now, 6 an element
  EnergyRow last_;
};

}  // namespace voussoir::solver
