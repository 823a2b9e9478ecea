// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "cases/forward.h"
#include "io/output/results/results.h"
#include "solver/bench/step_work.h"
#include "solver/run/run.h"

/// Times of the parts of a step, measured separately, since reading clocks costs some hundredths of a step.
namespace voussoir::io {

/// Parts of a step. `scatter`: transfer of contact forces from slots to elements, and of the forces of all joints; the latter is measured
/// separately (solver::assembly_time) and subtracted from the parts of the joints. `waiting`: the remainder of the stage of forces.
/// `ledger`, `output`: at the intervals of the case, as in a run.
enum class StepPart : std::size_t { whole_joints, damaged_joints, contacts, assembly, waiting, search, damage, update, ledger, output };
inline constexpr std::array<const char*, 10> kStepPartNames = {"joints whole", "joints damaged", "contacts", "scatter", "waiting",
                                                               "search",       "damage",         "update",   "ledger",  "output"};
using StepParts = std::array<double, kStepPartNames.size()>;

/// Times for one number of threads.
struct StepSplit {
  int threads = 1;
  StepParts parts{};  // s per step: medians over batches; of search, ledger and output, which only few steps have, means over all batches
  solver::StepWork work;  // of a step: mean over batches
  // Means over all batches [s per step].
  solver::StageTimes stages{};
  solver::ForceTimes forces{};
  std::vector<double> tasks;  // by task: of joints by colour
  double alone = 0.0;         // of forces, on one thread
  [[nodiscard]] double step() const;
};

/// Times of the parts from the times of stages and forces [s].
/// \param scatter  s, of joints: at most the sum of their parts
/// \param whole_share  share of it for joints in whole blocks
StepParts parts_of(const solver::StageTimes& stages, const solver::ForceTimes& forces, double scatter, double whole_share);

/// A run that is measured; it advances meanwhile.
struct RunInHand {
  const cases::Case& value;
  solver::Simulation& sim;
  solver::RunState& plan;
  ResultsWriter& results;  // writes to disk only on request
};

/// Measures all numbers of threads in turn, as time_steps.
/// \param steps  in a batch, by number of threads; rounded up to a multiple of the run's tick
std::vector<StepSplit> split_steps(const RunInHand& run, std::span<const int> counts, std::span<const int> steps, int batches);

}  // namespace voussoir::io
