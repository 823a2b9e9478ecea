// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vec3.h"
#include "solver/world/world.h"

/// The motion from one state of rest to the next that the last two of them predict (kernels/THEORY.md, section 13). It leads the elements
/// while the load goes on: damping acts on what departs from it alone, and it has its own inertia, so a right prediction is followed
/// without any unbalanced force.
namespace voussoir::solver {

class Lead {
 public:
  Lead() = default;
  explicit Lead(const World& w);

  /// Takes a state of rest. \param way  of the moving end since the last one; 0: this is the first, or nothing follows from what was before
  void accept(const World& w, double way);

  /// What the prediction leaves open of the motion, in the norm of the fictitious masses, 0 to 1, as it was at the last point.
  [[nodiscard]] double open() const noexcept { return state_.open; }

  /// Begins an iteration in which the moving end moves on by `way` [m].
  void step(double way) noexcept { before_ = ahead_, ahead_ = state_.share * way; }
  /// Whether a motion is predicted in the last iteration or in this one.
  [[nodiscard]] bool leads() const noexcept { return before_ != 0.0 || ahead_ != 0.0; }
  /// Way that counts for the predicted motion, in the iteration behind and ahead.
  [[nodiscard]] double before() const noexcept { return before_; }
  [[nodiscard]] double ahead() const noexcept { return ahead_; }
  /// Predicted motion of an element for a way of 1: displacement, rotation.
  [[nodiscard]] Vec3 displacement(std::size_t i) const noexcept { return vector(rate_, i, 0); }
  [[nodiscard]] Vec3 rotation(std::size_t i) const noexcept { return vector(rate_, i, 3); }

 private:
  friend struct FieldTable;
  struct State {         // doubles only, see LoadProgram::State
    double known = 0.0;  // motions between two states of rest that are known: 0 or 1
    double share = 0.0;  // of the last motion that is predicted
    double open = 1.0;
  };
  static constexpr std::size_t kPose = 7, kRate = 6;

  [[nodiscard]] static Vec3 vector(const std::vector<double>& v, std::size_t i, std::size_t first) noexcept {
    const double* p = v.data() + i * kRate + first;
    return {p[0], p[1], p[2]};
  }

  State state_;
  double before_ = 0.0, ahead_ = 0.0;  // 0 at every state of rest
  std::vector<double> pose_, rate_;  // of each element: displacement and quaternion at the last state of rest; motion since the one before
};

}  // namespace voussoir::solver
