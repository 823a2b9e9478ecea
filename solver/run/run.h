// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "cases/forward.h"
#include "solver/run/recorder.h"
#include "solver/run/simulation.h"

/// The plan of a run: settle, shake, and call a Recorder at the intervals of the case.
namespace voussoir::solver {

/// Number of steps of dt [s] in an interval [s] between two rows: whole cycles of multi-rate stepping (Simulation::cycle).
std::int64_t in_cycles(double interval, double dt, std::int64_t cycle);

/// State of the plan of a run, beside that of the simulation.
struct RunState {
  Damage settling;              // at the start of the shaking; zero before
  double settling_crack = 0.0;  // s, below 0: first crack while settling; 0: none
  std::int64_t steps = 0;       // number since the beginning of the run
  bool shaking = false;         // the shaking has begun
  bool settled = true;          // gravity came to rest before the shaking
  double first_crack = -1.0;    // s, < 0: none
  double collapse = -1.0;       // s, first frame in which the building is collapsed, < 0: none
  double peak_base_shear = 0;   // N
};

/// Position of a run, for a progress line.
struct RunStatus {
  double time = 0.0, end = 0.0;  // s, of the next step
  bool settling = false;
  std::int64_t step = 0;                  // since the beginning of the run
  std::int64_t broken = 0;                // segment sides
  double residual = 0.0;                  // of the last energy row
  bool last = false;                      // only the last step remains
  std::int64_t states = -1;               // of rest so far; -1: the run has none
  double factor = 0.0, unbalanced = 0.0;  // load factor; how far from rest: of runs with states of rest
};

/// Called before the first step, every few steps, and before the last. All rows so far are with the recorder, so simulation and RunState
/// can be saved. Returns false to stop.
using Tick = std::function<bool(const RunStatus&)>;

struct RunResult {
  bool stopped = false;  // by the tick
  Summary summary;
};

/// Residual at which a run stops with NumericalError.
inline constexpr double kResidualLimit = 1e-2;

/// Runs, or continues from `state`, until `end` [s of shaking], or until the end by Time::after_collapse. All rows up to the stop have been
/// recorded, also after an exception.
/// \param state  of a new run, or restored with the simulation; kept up to date
/// \throw NumericalError also if the ledger's residual exceeds kResidualLimit during the shaking
RunResult run(Simulation& sim, RunState& state, const cases::Case& c, double end, Recorder& out, const Tick& tick);

/// The last step of a run until `end` [s]; it has a row of the ledger.
std::int64_t last_step(double end, double dt, std::int64_t cycle);
std::int64_t last_step(const Simulation& sim, double end);

/// Results of the run so far.
Summary summarise(const Simulation& sim, const RunState& state);

}  // namespace voussoir::solver
