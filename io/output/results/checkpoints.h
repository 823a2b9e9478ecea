// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "io/output/results/checkpoint_file.h"
#include "solver/run/run.h"

/// The checkpoints of a run: DIR/checkpoint-NNNNNN.h5, the newest two that are whole kept.
namespace voussoir::io {

struct CheckpointSchedule {
  double wall_clock = 300.0;        // s between two
  std::optional<double> simulated;  // s of simulated time between two, if that comes sooner
};

class Checkpoints {
 public:
  /// \param facts  `time` and `rows` are filled in at every save
  /// \param from  what a resumed run goes on from: those newer than it are damaged
  Checkpoints(std::string folder, CheckpointFacts facts, CheckpointSchedule schedule, const std::string& from = {});

  /// At the first call, when one of the intervals has passed, and before the last step.
  [[nodiscard]] bool due(const solver::RunStatus& s) const;
  /// \pre the results of all steps so far are on disk (ResultsWriter::flush), `rows` counts them
  /// \throw FileError; the older checkpoints stay, and the next is due after another interval
  void save(solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows);
  /// The state in which the numbers went wrong, as checkpoint-failed.h5: to look at, not to go on from. \throw FileError
  void save_failed(solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows);

 private:
  using Clock = std::chrono::steady_clock;
  void write(const std::string& path, solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows);
  void remove_old() const;

  std::string folder_;
  CheckpointFacts facts_;
  CheckpointSchedule schedule_;
  long next_ = 0;                              // number
  long damaged_first_ = 0, damaged_last_ = 0;  // numbers in [first, last) are of damaged files
  std::optional<Clock::time_point> tried_;     // the last save, also one that failed
  double saved_at_ = 0.0;                      // s, simulated
};

/// Paths of the checkpoints in a folder, newest first; without checkpoint-failed.h5.
std::vector<std::string> checkpoint_files(const std::string& folder);

}  // namespace voussoir::io
