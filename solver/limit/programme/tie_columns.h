// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "solver/limit/balance.h"
#include "solver/limit/programme/linear_programme.h"

namespace voussoir::solver {

/// Costs of the two unknowns of a tie, per unit: of its force, and of the rest up to its yield force; >= 0, one of them zero.
struct TieCost {
  double force = 0.0, left = 0.0;
};
using TieCosts = std::function<TieCost(std::size_t tie)>;  // of Balance::ties

/// Which unknowns ties have in a programme.
struct TieUse {
  bool yielding = true;                    // false: ties that yield are left out
  TieCosts costs{};                        // empty: none
  std::optional<std::size_t> cost_row{};  // the equation that takes the costs; without it, what costs something is left out
};

/// Unknowns of ties: the force of each, and of each tie that yields the rest up to its yield force.
class TieColumns {
 public:
  /// Number of further equations of a programme with ties that yield: their limits.
  static std::size_t limits(const Balance& balance);

  /// Adds the unknowns after those that `lp` has. \param first_limit  number of the first of those equations
  TieColumns(const Balance& balance, LinearProgramme& lp, std::size_t first_limit, const TieUse& use);

  /// Forces of all ties, in mean weights.
  [[nodiscard]] std::vector<double> forces(const std::vector<double>& unknowns) const;

 private:
  std::vector<std::optional<std::size_t>> column_;  // by tie: of its force
};

}  // namespace voussoir::solver
