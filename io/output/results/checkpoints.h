// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "io/output/results/checkpoint_file.h"
#include "solver/run/run.h"

/// The checkpoints of a run: DIR/checkpoint-NNNNNN.h5; the newest two intact ones are kept.
namespace voussoir::io {

/// Number of checkpoints that are kept.
constexpr int kKeptCheckpoints = 2;

struct CheckpointSchedule {
  double wall_clock = 300.0;        // s of wall-clock time between two checkpoints
  std::optional<double> simulated;  // s of simulated time between two checkpoints, if reached sooner
};

class Checkpoints {
 public:
  /// \param facts  `time` and `rows` are set at every save
  /// \param from  checkpoint from which a resumed run continues: newer ones are damaged
  Checkpoints(std::string folder, CheckpointFacts facts, CheckpointSchedule schedule, const std::string& from = {});

  /// Whether to save: at the first call, when one of the intervals has passed, and before the last step.
  [[nodiscard]] bool due(const solver::RunStatus& s) const;
  /// Saves a checkpoint. \pre the results of all steps so far are on disk (ResultsWriter::flush), and `rows` is their number
  /// \throw FileError; the older checkpoints stay, and the next is due after another interval
  void save(solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows);
  /// Saves the state after a numerical failure as checkpoint-failed.h5, for inspection, not for resuming. \throw FileError
  void save_failed(solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows);

 private:
  using Clock = std::chrono::steady_clock;
  void write(const std::string& path, solver::Simulation& sim, solver::RunState& plan, const RowCounts& rows);
  void remove_old() const;

  std::string folder_;
  CheckpointFacts facts_;
  CheckpointSchedule schedule_;
  long next_ = 0;                              // number of the next checkpoint
  long damaged_first_ = 0, damaged_last_ = 0;  // checkpoints with numbers in [first, last) are damaged
  std::optional<Clock::time_point> tried_;     // time of the last attempt to save, successful or not
  double saved_at_ = 0.0;                      // s, simulated, of the last checkpoint
};

/// Paths of the checkpoints in a folder, newest first; checkpoint-failed.h5 is not included.
std::vector<std::string> checkpoint_files(const std::string& folder);

}  // namespace voussoir::io
