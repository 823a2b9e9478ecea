// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "solver/run/recorder.h"
#include "solver/run/simulation.h"

/// The run plan: settle, shake, and tell a Recorder at the intervals the case asks for.
namespace voussoir::solver {

/// Steps of dt [s] between two rows that an interval [s] asks for: whole cycles of multi-rate stepping (Simulation::cycle).
std::int64_t in_cycles(double interval, double dt, std::int64_t cycle);

/// What a run carries from step to step beside the simulation.
struct RunState {
  Damage settling;              // when the shaking began; until then nothing
  double settling_crack = 0.0;  // s, below 0: of the first crack while it settled; 0: none
  std::int64_t steps = 0;       // since the beginning of the run
  bool shaking = false;         // the shaking has begun
  bool settled = true;          // gravity came to rest before it did
  double first_crack = -1.0;    // s, < 0: none
  double collapse = -1.0;       // s, of the first frame in which the building has collapsed, < 0: none
  double peak_base_shear = 0;   // N
};

/// Where a run is, for a progress line.
struct RunStatus {
  double time = 0.0, end = 0.0;  // s, of the next step
  bool settling = false;
  std::int64_t step = 0;    // since the beginning of the run
  std::int64_t broken = 0;  // segment sides
  double residual = 0.0;    // of the last energy row
  bool last = false;        // only the last step is left
};

/// Called before the first step, every few steps, and before the last. All rows up to here are with the recorder, so simulation and
/// RunState can be saved. Returns false to stop.
using Tick = std::function<bool(const RunStatus&)>;

struct RunResult {
  bool stopped = false;  // by the tick
  Summary summary;
};

/// Residual at which a run stops with NumericalError.
inline constexpr double kResidualLimit = 1e-2;

/// Runs, or goes on from `state`, until `end` [s of shaking], or until Time::after_collapse says. Rows up to the moment it stops are with
/// the recorder; on an exception too.
/// \param state  of a new run, or restored with the simulation; kept up to date
/// \throw NumericalError also when the ledger's residual passes kResidualLimit while it shakes
RunResult run(Simulation& sim, RunState& state, const cases::Case& c, double end, Recorder& out, const Tick& tick);

/// The step that a run until `end` [s] ends with; it has a row of the ledger.
std::int64_t last_step(double end, double dt, std::int64_t cycle);
std::int64_t last_step(const Simulation& sim, double end);

/// What the run has come to, so far.
Summary summarise(const Simulation& sim, const RunState& state);

}  // namespace voussoir::solver
