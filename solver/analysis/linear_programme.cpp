// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/linear_programme.h"

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "solver/analysis/interior_point.h"

#ifdef VOUSSOIR_CLP
#include <coin/Clp_C_Interface.h>

#include <coin/CoinFinite.hpp>
#endif

namespace voussoir::solver {

namespace {

constexpr double kInsideBound = 1e-6;  // relative: nearer than this to its bound, the first unknown is at it

}  // namespace

#ifdef VOUSSOIR_CLP

bool has_linear_programmes() noexcept { return true; }

LpSolution LinearProgramme::solve(bool feasible, double bound) const {
  constexpr int kSolved = 0, kInfeasible = 1;  // Clp's status
  constexpr int kPerturbed = 50;               // Clp's way against cycling: these programmes are degenerate all over
  const std::unique_ptr<Clp_Simplex, void (*)(Clp_Simplex*)> lp(Clp_newModel(), Clp_deleteModel);
  const std::vector<CoinBigIndex> starts(starts_.begin(), starts_.end());
  std::vector<double> objective(starts.size() - 1, 0.0);
  objective.front() = 1.0;
  std::vector<double> most(objective.size(), COIN_DBL_MAX);
  most.front() = bound;
  Clp_setLogLevel(lp.get(), 0);
  Clp_loadProblem(lp.get(), static_cast<int>(objective.size()), static_cast<int>(right_.size()), starts.data(), equations_.data(),
                  coefficients_.data(), nullptr, most.data(), objective.data(), right_.data(), right_.data());
  Clp_setOptimizationDirection(lp.get(), -1.0);
  Clp_setPerturbation(lp.get(), kPerturbed);
  if (objective.size() >= kLpLarge && feasible) {
    Clp_initialBarrierSolve(lp.get());  // and over to a basis
    if (Clp_status(lp.get()) != kSolved) Clp_dual(lp.get(), 0);
  } else {
    Clp_dual(lp.get(), 0);
  }
  if (const int status = Clp_status(lp.get()); status != kSolved && status != kInfeasible) Clp_initialSolve(lp.get());
  const int status = Clp_status(lp.get());
  if (status == kInfeasible) return {LpOutcome::none, {}, {}};
  if (status != kSolved) throw std::runtime_error("limit analysis: Clp ends with the status " + std::to_string(status));
  const double *unknowns = Clp_primalColumnSolution(lp.get()), *prices = Clp_dualRowSolution(lp.get());
  const LpOutcome outcome = unknowns[0] > (1.0 - 1e-9) * bound ? LpOutcome::at_bound : LpOutcome::solved;
  return {outcome, {unknowns, unknowns + objective.size()}, {prices, prices + right_.size()}};
}

#else

bool has_linear_programmes() noexcept { return false; }

LpSolution LinearProgramme::solve(bool /*feasible*/, double /*bound*/) const {
  throw std::logic_error("this program was built without Clp");
}

#endif

/// The bound is one more equation: (first unknown + what is left) / bound = 1.
LpSolution LinearProgramme::solve_inside(double bound) const {
  const std::size_t columns = starts_.size() - 1, rows = right_.size();
  InteriorProgramme p;
  p.right = right_;
  p.right.push_back(1.0);
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t k = starts_[c]; k < starts_[c + 1]; ++k) p.add(static_cast<std::size_t>(equations_[k]), coefficients_[k]);
    if (c == 0) p.add(rows, 1.0 / bound);
    p.end_column(c == 0 ? -1.0 : 0.0);
  }
  p.add(rows, 1.0 / bound);
  p.end_column(0.0);
  std::optional<InteriorPoint> found = interior_point(p);
  if (!found) return {LpOutcome::none, {}, {}};
  const LpOutcome outcome = found->unknowns.front() > (1.0 - kInsideBound) * bound ? LpOutcome::at_bound : LpOutcome::solved;
  found->unknowns.pop_back();
  found->prices.pop_back();
  for (double& price : found->prices) price = -price;
  return {outcome, std::move(found->unknowns), std::move(found->prices)};
}

}  // namespace voussoir::solver
