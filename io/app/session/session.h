// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/output/results/checkpoints.h"
#include "io/output/results/results.h"
#include "solver/run/run.h"

/// What a new run and a resumed one have in common: the time between "everything is ready" and the exit code.
namespace voussoir::io {

/// What a checkpoint of this run says beside the state. \param toml  the resolved case
CheckpointFacts facts_of(const solver::Simulation& sim, const std::string& toml, const cases::GroundMotion& motion, bool reference_kernels);

/// Names of the followed elements, in order.
std::vector<std::string> history_names(const cases::Case& c);
/// Names of the cuts of a case, in order.
std::vector<std::string> cut_names(const cases::Case& c);

/// Of a run whose files cannot be written: tells whether `resume` goes on once they can, or the case is to be run anew.
void print_way_on(const std::string& folder);

/// Runs, or goes on from `plan`, to the end of the case; tells people how it goes and what came out.
///
/// Checkpoints are written as scheduled and on signals: SIGUSR1 saves and goes on, SIGINT and SIGTERM save and stop. A checkpoint that
/// cannot be written, but for the first and that of a stop, is a warning. \param page_every  see LivePage \return kDone, kNumericalFailure,
/// or 128 + the signal that stopped it \throw FileError if results cannot be written
int run_session(const cases::Case& c, solver::Simulation& sim, solver::RunState& plan, ResultsWriter& results, Checkpoints& checkpoints,
                const std::string& folder, bool quiet, double page_every = 0);

}  // namespace voussoir::io
