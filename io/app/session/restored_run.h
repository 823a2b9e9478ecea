// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "cases/case.h"
#include "io/output/results/checkpoint_file.h"
#include "solver/run/run.h"

namespace voussoir::io {

/// A run restored from a checkpoint. Not movable, since the simulation refers to the case and the model.
struct RestoredRun {
  std::string path;  // of the checkpoint, for messages
  CheckpointFacts facts;
  cases::Case value;
  cases::Model model;
  solver::RunState plan;
  std::unique_ptr<solver::Simulation> sim;

  RestoredRun() = default;
  RestoredRun(const RestoredRun&) = delete;
  RestoredRun& operator=(const RestoredRun&) = delete;
};

/// Builds the case of a checkpoint and restores the state. Warns if another build of the program wrote the checkpoint.
/// \param value  the checkpoint's case, from read_case; its duration may have been changed
/// \param options  of the simulation; kernels and step are those of the checkpoint
/// \throw FileError if this program builds another model from the case, or if the checkpoint's data are no valid state
std::unique_ptr<RestoredRun> restore_run(const std::string& path, Checkpoint checkpoint, cases::Case value, solver::Options options);

}  // namespace voussoir::io
