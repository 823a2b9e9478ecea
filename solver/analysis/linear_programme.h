// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace voussoir::solver {

/// Whether this program was built with Clp (COIN-OR's linear programmes, EPL-2.0), which solves those of limit analysis.
[[nodiscard]] bool has_linear_programmes() noexcept;

enum class LpOutcome { solved, infeasible, unbounded };

/// What is larger counts as unbounded: the first unknown has this as its upper bound, so that the dual simplex can start at it.
inline constexpr double kLpUnbounded = 1e3;

struct LpSolution {
  LpOutcome outcome = LpOutcome::solved;
  std::vector<double> unknowns;  // by column
  std::vector<double> prices;    // by equation: how fast the maximum grows with its right-hand side
};

/// A linear programme by columns: maximise the first of the unknowns, all >= 0, under equations.
class LinearProgramme {
 public:
  explicit LinearProgramme(std::size_t equations) : right_(equations, 0.0) {}

  /// The right-hand side of an equation.
  double& right(std::size_t equation) { return right_[equation]; }
  /// A coefficient of the column in hand; each equation at most once a column.
  void add(std::size_t equation, double coefficient) {
    equations_.push_back(static_cast<int>(equation));
    coefficients_.push_back(coefficient);
  }
  void end_column() { starts_.push_back(equations_.size()); }

  /// \throw std::logic_error if this program has no linear programmes \throw std::runtime_error if Clp gives up
  [[nodiscard]] LpSolution solve() const;

 private:
  std::vector<double> right_;
  std::vector<std::size_t> starts_{0};
  std::vector<int> equations_;
  std::vector<double> coefficients_;
};

}  // namespace voussoir::solver
