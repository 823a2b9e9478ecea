// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "cases/case.h"
#include "solver/equilibrium/lead.h"
#include "solver/world/world.h"

/// Relaxation: the motion that leads a structure to a state of rest. Masses are fictitious and time has no meaning (kernels/THEORY.md,
/// section 13).
namespace voussoir::solver {

/// The case as a relaxation computes it: nothing that depends on a rate (dashpots, restitution, mass damping).
cases::Case without_rates(const cases::Case& c);

class Relaxation {
 public:
  Relaxation() = default;  // none
  /// Gives the elements their fictitious masses. \throw cases::InputError if nothing weighs
  Relaxation(const cases::Case& c, World& w);

  [[nodiscard]] bool on() const noexcept { return on_; }
  /// Before the kick, when the rows have all forces but weights: adds the weights under the acceleration [m/s2], measures how far the
  /// structure is from rest and sets the mass damping of the step.
  /// \param on_the_way  the load still goes on to the next point \param lead  the motion that is predicted for it
  void look(World& w, Vec3 acceleration, bool on_the_way, const Lead& lead);
  /// Finds the masses that belong to a restored state. \pre the world has that state
  void restore(World& w);

  /// Largest unbalanced force over the mean weight of an element, or moment over that and the element's radius, in the last step.
  [[nodiscard]] double unbalanced() const noexcept { return state_.unbalanced; }
  /// 1/s, of the slowest motion that takes part, by the quotient of Rayleigh.
  [[nodiscard]] double frequency() const noexcept { return state_.frequency; }
  [[nodiscard]] double typical_force() const noexcept { return typical_; }  // N

 private:
  friend struct FieldTable;
  struct State {             // doubles only, see LoadProgram::State
    double power = 0.0;      // W, of the unbalanced forces of the last step with the velocities behind it, less the predicted ones
    double frequency = 0.0;  // rad/s
    double unbalanced = 1e300;
    double alpha = 0.0, turning = 0.0;  // 1/s, damping of the last step; J, energy of rotation behind it
  };
  struct alignas(64) Sums {
    double power = 0.0, square = 0.0, kinetic = 0.0, turning = 0.0, most = 0.0;
  };

  [[nodiscard]] Sums look_at(World& w, std::size_t i, Vec3 acceleration, const Lead& lead) const;
  [[nodiscard]] Sums all_of(World& w, Vec3 acceleration, const Lead& lead);
  void renew_masses(World& w);

  bool on_ = false;
  double typical_ = 0.0;     // N
  std::size_t patches_ = 0;  // for which the masses were found
  std::vector<Sums> by_batch_;
  State state_;
};

}  // namespace voussoir::solver
