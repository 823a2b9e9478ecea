// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "io/output/results/checkpoints.h"
#include "io/output/results/results.h"
#include "solver/run/run.h"

/// Common part of new and resumed runs: from the completed set-up to the exit code.
namespace voussoir::io {

/// Facts for the checkpoints of a run, beside the state. \param toml  the resolved case
CheckpointFacts facts_of(const solver::Simulation& sim, const std::string& toml, const cases::GroundMotion& motion, bool reference_kernels);

/// Names of the followed elements, in order.
std::vector<std::string> history_names(const cases::Case& c);
/// Names of the cuts of a case, in order.
std::vector<std::string> cut_names(const cases::Case& c);

/// For a run whose files could not be written: prints whether `resume` can continue it later, or the case must be run again.
void print_way_on(const std::string& folder);

/// Runs, or continues from `plan`, to the end of the case; prints progress and results.
///
/// Checkpoints are written as scheduled and on signals: SIGUSR1 saves and continues, SIGINT and SIGTERM save and stop. Failure to write a
/// checkpoint is a warning, except for the first one and that of a stop.
/// \param sim  ends before the measures are taken, which need as much memory again
/// \param page_every  see LivePage
/// \return kDone, kNumericalFailure, or 128 + the signal that stopped it \throw FileError if results cannot be written
int run_session(const cases::Case& c, std::unique_ptr<solver::Simulation> sim, solver::RunState& plan, ResultsWriter& results,
                Checkpoints& checkpoints, const std::string& folder, bool quiet, double page_every = 0);

}  // namespace voussoir::io
