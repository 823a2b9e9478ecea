// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "solver/limit/balance.h"
#include "solver/limit/limit.h"
#include "solver/limit/limit_proof.h"
#include "solver/limit/programme/programmes.h"

namespace voussoir::solver {

/// Search for a collapse with Coulomb's flow rule, starting from the forces of the associated one.
class CoulombSearch {
 public:
  /// \param tick  called after each programme with the multiplier
  CoulombSearch(const LimitModel& model, const Balance& balance, const FrictionCone& cone, const Programmes& programmes,
                std::function<void(double)> tick)
      : model_(model), balance_(balance), cone_(cone), programmes_(programmes), tick_(std::move(tick)) {}

  /// Runs the search. \return a state with a valid proof, or else the last one of the iterations
  LimitState find(const ProgrammeForces& associated, double multiplier);

 private:
  /// Rotates the yield lines once. \return whether a solution was found
  bool iterate(LimitState& out);
  /// Searches from the last forces by pairs of programmes: a motion, then forces for it. \return whether the proof is valid
  bool search(LimitState& out);
  [[nodiscard]] double cost(const std::vector<kernels::Twist>& motion, std::size_t point, std::size_t corner) const;
  [[nodiscard]] TieCost tie_cost(const std::vector<kernels::Twist>& motion, std::size_t tie) const;
  /// Checks a motion with the forces for it, and stores the state if proven. \return whether the proof is valid
  bool prove(const ProgrammeSolution& moving, const ProgrammeSolution& resisting, LimitState& out);
  void took(LimitState& out, double factor) const;

  const LimitModel& model_;
  const Balance& balance_;
  const FrictionCone& cone_;
  const Programmes& programmes_;
  std::function<void(double)> tick_;
  std::vector<double> slope_, compression_;  // of the yield lines; mean of the compressions found
  ProgrammeForces found_;                    // last forces found
};

}  // namespace voussoir::solver
