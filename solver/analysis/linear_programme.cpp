// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/linear_programme.h"

#include <memory>
#include <stdexcept>
#include <string>

#ifdef VOUSSOIR_CLP
#include <coin/Clp_C_Interface.h>
#endif

namespace voussoir::solver {

#ifdef VOUSSOIR_CLP

bool has_linear_programmes() noexcept { return true; }

LpSolution LinearProgramme::solve() const {
  constexpr int kSolved = 0, kInfeasible = 1, kUnbounded = 2;  // Clp's status
  const std::unique_ptr<Clp_Simplex, void (*)(Clp_Simplex*)> lp(Clp_newModel(), Clp_deleteModel);
  const std::vector<CoinBigIndex> starts(starts_.begin(), starts_.end());
  std::vector<double> objective(starts.size() - 1, 0.0);
  objective.front() = 1.0;
  Clp_setLogLevel(lp.get(), 0);
  Clp_loadProblem(lp.get(), static_cast<int>(objective.size()), static_cast<int>(right_.size()), starts.data(), equations_.data(),
                  coefficients_.data(), nullptr, nullptr, objective.data(), right_.data(), right_.data());
  Clp_setOptimizationDirection(lp.get(), -1.0);
  Clp_initialSolve(lp.get());
  switch (Clp_status(lp.get())) {
    case kSolved:
      break;
    case kInfeasible:
      return {LpOutcome::infeasible, {}, {}};
    case kUnbounded:
      return {LpOutcome::unbounded, {}, {}};
    default:
      throw std::runtime_error("limit analysis: Clp ends with the status " + std::to_string(Clp_status(lp.get())));
  }
  const double *unknowns = Clp_primalColumnSolution(lp.get()), *prices = Clp_dualRowSolution(lp.get());
  return {LpOutcome::solved, {unknowns, unknowns + objective.size()}, {prices, prices + right_.size()}};
}

#else

bool has_linear_programmes() noexcept { return false; }

LpSolution LinearProgramme::solve() const { throw std::logic_error("this program was built without Clp"); }

#endif

}  // namespace voussoir::solver
