// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/programme/tie_columns.h"

#include <algorithm>
#include <cmath>

namespace voussoir::solver {
namespace {

bool yields(const BalanceTie& t) { return std::isfinite(t.most); }

}  // namespace

std::size_t TieColumns::limits(const Balance& balance) { return static_cast<std::size_t>(std::ranges::count_if(balance.ties(), yields)); }

TieColumns::TieColumns(const Balance& balance, LinearProgramme& lp, std::size_t first_limit, const TieUse& use)
    : column_(balance.ties().size()) {
  std::size_t limit = first_limit;
  for (std::size_t k = 0; k < column_.size(); ++k) {
    const BalanceTie& tie = balance.ties()[k];
    if (yields(tie) && !use.yielding) continue;
    const double scale = 1.0 / std::max(1.0, tie.most);  // of its limit: numbers near 1
    const TieCost cost = use.costs ? use.costs(k) : TieCost{};
    const auto costs = [&](double price) {
      if (price > 0.0) lp.add(*use.cost_row, price);
    };
    if (use.cost_row || cost.force == 0.0) {
      balance.at_tie(tie, [&](std::size_t row, double value) { lp.add(row, value); });
      if (yields(tie)) lp.add(limit, scale);
      costs(cost.force);
      column_[k] = lp.columns();
      lp.end_column();
    }
    if (!yields(tie)) continue;
    if (use.cost_row || cost.left == 0.0) {
      lp.add(limit, scale);
      costs(cost.left);
      lp.end_column();
    }
    lp.right(limit++) = scale * tie.most;
  }
}

std::vector<double> TieColumns::forces(const std::vector<double>& unknowns) const {
  std::vector<double> all(column_.size(), 0.0);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (column_[k]) all[k] = unknowns[*column_[k]];
  return all;
}

}  // namespace voussoir::solver
