// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "solver/recorder.h"
#include "solver/simulation.h"

/// The run plan: settle, shake, and tell a Recorder at the intervals the case asks for.
namespace voussoir::solver {

/// Where a run is, for a progress line.
struct RunStatus {
  double time = 0.0, end = 0.0;  // s
  bool settling = false;
  std::int64_t step = 0;    // since the beginning of the run
  std::int64_t broken = 0;  // segment sides
  double residual = 0.0;    // of the last energy row
};

/// Called every few steps; returns false to stop the run after this step.
using Tick = std::function<bool(const RunStatus&)>;

struct RunResult {
  bool stopped = false;  // by the tick
  Summary summary;
};

/// Residual at which a run stops with NumericalError.
inline constexpr double kResidualLimit = 1e-2;

/// Runs until `end` [s of shaking]. Rows up to the moment it stops are with the recorder; on an exception too.
/// \throw NumericalError also when the ledger's residual passes kResidualLimit
RunResult run(Simulation& sim, const cases::Case& c, double end, Recorder& out, const Tick& tick);

/// What the run has come to, so far.
Summary summarise(const Simulation& sim, double first_crack, double peak_base_shear, bool settled);

}  // namespace voussoir::solver
