// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/programme/linear_programme.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "solver/limit/programme/interior_point.h"

#ifdef VOUSSOIR_CLP
#include <coin/Clp_C_Interface.h>

#include <coin/CoinFinite.hpp>
#endif

namespace voussoir::solver {

namespace {

constexpr double kExact = 1e-9, kInside = 1e-6;  // of the largest numbers: what a basis and an interior point must prove

}  // namespace

#ifdef VOUSSOIR_CLP

bool has_linear_programmes() noexcept { return true; }

LpSolution LinearProgramme::by_clp(Method method) const {
  constexpr int kPerturbed = 50, kAsIs = 100;  // Clp's way against cycling: these programmes are degenerate all over
  constexpr double kTolerance = 1e-10;
  const std::unique_ptr<Clp_Simplex, void (*)(Clp_Simplex*)> lp(Clp_newModel(), Clp_deleteModel);
  const std::vector<CoinBigIndex> starts(starts_.begin(), starts_.end());
  std::vector<double> objective(columns(), 0.0), most(columns(), COIN_DBL_MAX);
  objective.front() = cost(), most.front() = bound_;
  Clp_setLogLevel(lp.get(), 0);
  Clp_loadProblem(lp.get(), static_cast<int>(objective.size()), static_cast<int>(right_.size()), starts.data(), equations_.data(),
                  coefficients_.data(), nullptr, most.data(), objective.data(), right_.data(), right_.data());
  Clp_setOptimizationDirection(lp.get(), -1.0);
  Clp_setPrimalTolerance(lp.get(), kTolerance);
  Clp_setDualTolerance(lp.get(), kTolerance);
  Clp_setPerturbation(lp.get(), method == Method::primal ? kAsIs : kPerturbed);
  if (method == Method::dual) Clp_dual(lp.get(), 0);
  if (method == Method::primal) Clp_primal(lp.get(), 0);
  if (method == Method::barrier) Clp_initialBarrierSolve(lp.get());  // and over to a basis
  const double *unknowns = Clp_primalColumnSolution(lp.get()), *prices = Clp_dualRowSolution(lp.get());
  return {LpOutcome::solved, {unknowns, unknowns + objective.size()}, {prices, prices + right_.size()}};
}

#else

bool has_linear_programmes() noexcept { return false; }

LpSolution LinearProgramme::by_clp(Method /*method*/) const { throw std::logic_error("this program was built without Clp"); }

#endif

/// The bound is one more equation: (first unknown + what is left) / bound = 1.
LpSolution LinearProgramme::by_interior_point(const LpWatch& watch) const {
  const std::size_t rows = right_.size();
  InteriorProgramme p;
  p.right = right_;
  p.right.push_back(1.0);
  for (std::size_t c = 0; c < columns(); ++c) {
    for (std::size_t k = starts_[c]; k < starts_[c + 1]; ++k) p.add(static_cast<std::size_t>(equations_[k]), coefficients_[k]);
    if (c == 0) p.add(rows, 1.0 / bound_);
    p.end_column(c == 0 ? -cost() : 0.0);
  }
  p.add(rows, 1.0 / bound_);
  p.end_column(0.0);
  std::optional<InteriorPoint> found = interior_point(p, watch);
  if (!found) return {LpOutcome::none, {}, {}};
  found->unknowns.pop_back();
  found->prices.pop_back();
  for (double& price : found->prices) price = -price;
  return {LpOutcome::solved, std::move(found->unknowns), std::move(found->prices)};
}

bool LinearProgramme::is_optimal(const LpSolution& s, double tolerance) const {
  if (s.unknowns.size() != columns() || s.prices.size() != right_.size()) return false;
  std::vector<double> left = right_;
  double largest = 1.0, dearest = 1.0, worth = 0.0, worst = 0.0, bound_price = 0.0;
  for (const double b : right_) largest = std::max(largest, std::abs(b));
  for (const double x : s.unknowns) largest = std::max(largest, std::abs(x));
  for (const double y : s.prices) dearest = std::max(dearest, std::abs(y));
  for (std::size_t r = 0; r < right_.size(); ++r) worth += right_[r] * s.prices[r];
  for (std::size_t c = 0; c < columns(); ++c) {
    double price = 0.0;
    for (std::size_t k = starts_[c]; k < starts_[c + 1]; ++k) {
      const auto row = static_cast<std::size_t>(equations_[k]);
      left[row] -= coefficients_[k] * s.unknowns[c];
      price += coefficients_[k] * s.prices[row];
    }
    if (c == 0)
      bound_price = std::max(0.0, cost() - price);
    else
      worst = std::max(worst, -price / dearest);
    worst = std::max(worst, -s.unknowns[c] / largest);
  }
  for (const double l : left) worst = std::max(worst, std::abs(l) / largest);
  const double value = cost() * s.unknowns.front(), bound = worth + bound_price * bound_;
  const double scale = std::max({std::abs(value), 1e-3, tolerance * dearest});
  return std::isfinite(worst + value + bound) && worst <= tolerance && s.unknowns.front() <= bound_ * (1.0 + tolerance) &&
         std::abs(bound - value) <= 1e3 * tolerance * scale;
}

LpSolution LinearProgramme::solve(const LpOptions& options) const {
  std::vector<Method> methods{Method::dual, Method::primal, Method::barrier, Method::inside};
  if (columns() >= options.inside_from)
    methods = {Method::inside};
  else if (columns() >= kLpLarge)
    methods = {Method::barrier, Method::dual, Method::primal, Method::inside};
  for (const Method method : methods) {
    LpSolution found = method == Method::inside ? by_interior_point(options.watch) : by_clp(method);
    const double tolerance = method == Method::inside ? kInside : kExact;
    if (!is_optimal(found, tolerance)) continue;
    if (goal_ == LpGoal::most && found.unknowns.front() > (1.0 - tolerance) * bound_) found.outcome = LpOutcome::at_bound;
    return found;
  }
  return {LpOutcome::none, {}, {}};
}

}  // namespace voussoir::solver
