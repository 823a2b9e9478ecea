// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "solver/limit/programme/interior_point.h"

namespace voussoir::solver {

/// Whether this program was built with Clp (linear programming of COIN-OR, EPL-2.0), which limit analysis needs.
[[nodiscard]] bool has_linear_programmes() noexcept;

/// none: there is no solution, or none was found to the required accuracy; at_bound: the first unknown is at its bound.
enum class LpOutcome { solved, none, at_bound };

/// Whether to maximise or minimise the first unknown.
enum class LpGoal { most, least };

/// Upper bound of the first unknown, from which the dual simplex starts.
inline constexpr double kLpBound = 1e3;
/// Number of unknowns from which on the barrier method is tried before the simplex methods, which take too long.
inline constexpr std::size_t kLpLarge = 5000;
/// Number of unknowns, as of a house, from which on the method of interior_point.h is used, which keeps the equations sparse.
inline constexpr std::size_t kLpHuge = 50000;

struct LpOptions {
  std::size_t inside_from = kLpHuge;  // number of unknowns from which on the interior-point method comes first, without the simplex methods
  LpWatch watch{};                    // of the interior-point method; may be empty
};

struct LpSolution {
  LpOutcome outcome = LpOutcome::solved;
  std::vector<double> unknowns;  // by column
  std::vector<double> prices;    // by equation: derivative of the first unknown with respect to the right-hand side
};

/// A linear programme by columns: maximises (or minimises) the first of the unknowns, all >= 0, subject to equations.
class LinearProgramme {
 public:
  explicit LinearProgramme(std::size_t equations, LpGoal goal = LpGoal::most, double bound = kLpBound)
      : right_(equations, 0.0), goal_(goal), bound_(bound) {}

  /// Right-hand side of an equation.
  double& right(std::size_t equation) { return right_[equation]; }
  /// Sets a coefficient of the current column; each equation at most once per column.
  void add(std::size_t equation, double coefficient) {
    equations_.push_back(static_cast<int>(equation));
    coefficients_.push_back(coefficient);
  }
  void end_column() { starts_.push_back(equations_.size()); }
  [[nodiscard]] std::size_t columns() const noexcept { return starts_.size() - 1; }

  /// Solves the programme. Methods are tried in turn until one gives unknowns and prices that prove each other optimal: equations, signs
  /// and gap to 1e-9 (interior-point method: 1e-6) of the largest numbers in each. The status reported by a method is not relied on.
  /// \throw std::logic_error if this program has no linear programmes
  [[nodiscard]] LpSolution solve(const LpOptions& options = {}) const;

 private:
  enum class Method { dual, primal, barrier, inside };
  [[nodiscard]] LpSolution by_clp(Method method) const;
  [[nodiscard]] LpSolution by_interior_point(const LpWatch& watch) const;
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
