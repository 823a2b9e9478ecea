// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/analysis/drive.h"
#include "solver/run/run.h"
#include "solver/state/saved_state.h"

/// Quasi-static analyses that are stopped and gone on with.
namespace voussoir::testing {

/// What a run has given to a recorder of type Rows, and its state at the end.
template <class Rows>
struct Outcome {
  Rows out;
  solver::SavedState state;
};

/// Runs an analysis with some numbers of threads in turn, stopped after so many steps and gone on with from its state.
template <class Rows>
Outcome<Rows> run_in_legs(const cases::Case& c, std::set<std::int64_t> stops = {}, const std::vector<int>& threads = {1}) {
  const cases::Model m = cases::build_model(c);
  Outcome<Rows> result;
  for (std::size_t leg = 0;; ++leg) {
    solver::Options o;
    o.threads = threads[leg % threads.size()];
    solver::Simulation sim(c, m, {}, o);
    solver::RunState plan;
    leg == 0 ? solver::choose_drive(sim, c) : solver::restore(sim, plan, result.state);
    const auto go_on = [&](const solver::RunStatus& s) {
      if (stops.empty() || s.step < *stops.begin()) return true;
      stops.erase(stops.begin());
      return false;
    };
    const solver::RunResult r = solver::run(sim, plan, c, c.end(), result.out, go_on);
    result.state = solver::save(sim, plan);
    if (!r.stopped) return result;
  }
}

/// The names of the fields in which two states differ.
inline std::string difference(const solver::SavedState& a, const solver::SavedState& b) {
  std::string names;
  REQUIRE(a.size() == b.size());
  for (const auto& [name, f] : a) names += f.bytes != b.at(name).bytes ? name + " " : "";
  return names;
}

}  // namespace voussoir::testing
