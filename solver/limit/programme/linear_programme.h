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

/// Whether the first unknown is to be as large or as small as can be.
enum class LpGoal { most, least };

/// Upper bound of the first unknown: the dual simplex starts from it.
inline constexpr double kLpBound = 1e3;
/// From this number of unknowns on the barrier method is tried before the simplex methods, which take too long.
inline constexpr std::size_t kLpLarge = 5000;
/// From this number on, as in a house, the method of interior_point.h, which keeps the equations sparse.
inline constexpr std::size_t kLpHuge = 50000;

struct LpSolution {
  LpOutcome outcome = LpOutcome::solved;
  std::vector<double> unknowns;  // by column
  std::vector<double> prices;    // by equation: how fast the first unknown grows with its right-hand side
};

/// A linear programme by columns: the first of the unknowns as large (or small) as can be, all >= 0, under equations.
class LinearProgramme {
 public:
  explicit LinearProgramme(std::size_t equations, LpGoal goal = LpGoal::most, double bound = kLpBound)
      : right_(equations, 0.0), goal_(goal), bound_(bound) {}

  /// The right-hand side of an equation.
  double& right(std::size_t equation) { return right_[equation]; }
  /// A coefficient of the column in hand; each equation at most once a column.
  void add(std::size_t equation, double coefficient) {
    equations_.push_back(static_cast<int>(equation));
    coefficients_.push_back(coefficient);
  }
  void end_column() { starts_.push_back(equations_.size()); }
  [[nodiscard]] std::size_t columns() const noexcept { return starts_.size() - 1; }

  /// Methods are tried in turn until one gives unknowns and prices that prove each other optimal: equations, signs and gap to 1e-9 (the
  /// interior-point method: 1e-6) of the largest numbers in them. What a method says of itself is not believed.
  /// \param inside_from  unknowns from which on the interior-point method comes first and the simplex methods are left out
  /// \throw std::logic_error if this program has no linear programmes
  [[nodiscard]] LpSolution solve(std::size_t inside_from = kLpHuge) const;

 private:
  enum class Method { dual, primal, barrier, inside };
  [[nodiscard]] LpSolution by_clp(Method method) const;
  [[nodiscard]] LpSolution by_interior_point() const;
  /// Whether unknowns and prices prove each other optimal.
  [[nodiscard]] bool is_optimal(const LpSolution& s, double tolerance) const;
  [[nodiscard]] double cost() const noexcept { return goal_ == LpGoal::most ? 1.0 : -1.0; }

  std::vector<double> right_;
  LpGoal goal_;
  double bound_;
  std::vector<std::size_t> starts_{0};
  std::vector<int> equations_;
  std::vector<double> coefficients_;
};

}  // namespace voussoir::solver
