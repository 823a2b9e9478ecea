// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace voussoir::solver {

/// Whether this program was built with Clp (COIN-OR's linear programmes, EPL-2.0), which solves those of limit analysis.
[[nodiscard]] bool has_linear_programmes() noexcept;

/// none: it has no solution, or none was found to the accuracy needed; at_bound: the first unknown is.
enum class LpOutcome { solved, none, at_bound };

/// Upper bound of the first unknown: the dual simplex starts from it.
inline constexpr double kLpBound = 1e3;
/// From this number of unknowns on the interior-point method is tried before the dual simplex, which takes too long.
inline constexpr std::size_t kLpLarge = 5000;
/// From this number on, as in a house, solve_inside() is asked, which keeps the equations sparse.
inline constexpr std::size_t kLpHuge = 50000;

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

  /// By Clp.
  /// \param feasible  known to be: large ones are solved in another way, which would take long to find that they are not
  /// \param bound     of the first unknown
  /// \throw std::logic_error if this program has no linear programmes \throw std::runtime_error if Clp gives up
  [[nodiscard]] LpSolution solve(bool feasible, double bound = kLpBound) const;
  /// By the method of interior_point.h, which does not converge where there is no solution, and may fail to where there is one.
  [[nodiscard]] LpSolution solve_inside(double bound = kLpBound) const;

 private:
  std::vector<double> right_;
  std::vector<std::size_t> starts_{0};
  std::vector<int> equations_;
  std::vector<double> coefficients_;
};

}  // namespace voussoir::solver
