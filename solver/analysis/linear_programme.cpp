// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/linear_programme.h"

#include <memory>
#include <stdexcept>
#include <string>

#ifdef VOUSSOIR_CLP
#include <coin/Clp_C_Interface.h>

#include <coin/CoinFinite.hpp>
#endif

namespace voussoir::solver {

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
  if (status == kInfeasible) return {LpOutcome::infeasible, {}, {}};
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

}  // namespace voussoir::solver
