// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

/// Large linear programmes by an interior-point method (Mehrotra 1992; Wright, Primal-Dual Interior-Point Methods, 1997, chapter 10).
/// Programmes of a house have half a million unknowns but few equations, whose normal matrix is as sparse as the house's stiffness.
namespace voussoir::solver {

/// Minimise costs · x subject to matrix · x = right, x >= 0; the matrix by columns. Each step solves normal equations; the first column,
/// which may have entries in all rows, is treated separately.
struct InteriorProgramme {
  std::vector<std::size_t> starts{0};  // start of each column in `rows` and `entries`, and the end
  std::vector<std::size_t> rows;
  std::vector<double> entries;
  std::vector<double> right, costs;

  void add(std::size_t row, double entry) { rows.push_back(row), entries.push_back(entry); }
  void end_column(double cost) { starts.push_back(rows.size()), costs.push_back(cost); }
};

struct InteriorPoint {
  std::vector<double> unknowns, prices;  // prices: of the equations
  int iterations = 0;
};

/// Called after each iteration with the gap between both programmes, relative to their value.
using LpWatch = std::function<void(int iteration, double gap)>;

/// A solution with residuals below 1e-8 of their scales. Where rounding does not allow the gap that is asked for, the point of least gap,
/// 1e-6 at most; none if the method does not get there (there may be no solution).
/// \param gap  between both programmes, relative to 1 plus their value: what is enough
std::optional<InteriorPoint> interior_point(const InteriorProgramme& programme, const LpWatch& watch = {}, double gap = 1e-8);

}  // namespace voussoir::solver
