// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/words/headway.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/model.h"
#include "geometry/message.h"
#include "solver/supports/supports.h"

namespace voussoir::io {
namespace {

using geometry::printed;

/// The largest value of solver::moved in the histories of the supports [m]; infinity: one goes on for ever.
double wanted(const solver::World& w) {
  double most = 0.0;
  for (const auto& support : w.supports) {
    if (support.history->open_ended) return std::numeric_limits<double>::infinity();
    for (const double t : support.history->time) most = std::max(most, solver::moved_at(w, support, t));
  }
  return most;
}

std::string of_supports(const solver::Simulation& sim, double moved) {
  const double all = wanted(sim.world());
  if (!std::isfinite(all)) return printed("supports moved by %.1f mm, at %.2f s of their histories", 1e3 * moved, sim.path().clock());
  return printed("supports moved by %.1f of %.1f mm, %.2f of %g s of their histories", 1e3 * moved, 1e3 * all, sim.path().clock(),
                 sim.program().last_support());
}

}  // namespace

std::string headway(const solver::Simulation& sim) {
  const solver::LoadProgram& program = sim.program();
  const cases::Analysis& a = program.analysis();
  const solver::AssessmentRow row = program.row(sim.world(), sim.time());
  if (a.kind == cases::AnalysisKind::settlement) return of_supports(sim, row.support_moved);
  if (a.kind == cases::AnalysisKind::rest && program.last_support() == 0.0) return "the weights";
  if (a.kind == cases::AnalysisKind::rest)
    return printed("%.1f %% of the loads that grow and of the supports' movements", 100.0 * program.factor());
  const std::string so_far = printed("load factor %.4f, control point %.2f", program.factor(), 1e3 * row.displacement);
  if (a.kind == cases::AnalysisKind::cyclic)
    return so_far + printed(" mm, %lld of %lld half cycles", static_cast<long long>(program.half_cycles()),
                            static_cast<long long>(program.whole_half_cycles()));
  const bool tilt = a.kind == cases::AnalysisKind::tilt;
  return so_far + printed(" of %.4g mm, %s %.0f %% of its largest (ends at %.0f %%)", 1e3 * program.largest_displacement(),
                          tilt ? "multiplier" : "load", 100.0 * program.share_of_largest(), 100.0 * (1.0 - a.drop));
}

}  // namespace voussoir::io
