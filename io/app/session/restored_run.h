// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "io/output/results/checkpoint_file.h"
#include "solver/run/run.h"

namespace voussoir::io {

/// A run as it stood at a checkpoint. Pinned: the simulation refers to the case and the model.
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

/// Builds the case that a checkpoint holds and brings it to the state of the checkpoint. Warns if another build of the program wrote it.
/// \param value    the checkpoint's case, as read_case gives it; its duration may have been changed
/// \param options  of the simulation; kernels and step are those of the checkpoint
/// \throw FileError if it is of a model that this program builds differently, or holds what no state can
std::unique_ptr<RestoredRun> restore_run(const std::string& path, Checkpoint checkpoint, cases::Case value, solver::Options options);

}  // namespace voussoir::io
