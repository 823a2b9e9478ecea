// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "solver/simulation.h"
#include "solver/stages.h"

/// How long a step takes, on a machine that others use, too.
namespace voussoir::io {

/// Some steps, a hundredth of a second of them.
struct Sample {
  double step = 0.0;            // s
  solver::StageTimes stages{};  // s a step
  std::vector<double> cores;    // s, by thread: solver::core_times beside them, the longer of before and after
};

/// Which of these samples of one team were quiet: each of its cores was as fast beside them as beside any, or nearly.
std::vector<bool> quiet(std::span<const Sample> samples);

/// What a step takes with so many threads.
struct Timing {
  int threads = 1;
  // Medians over batches of samples, whatever the machine did.
  double step = 0.0;            // s
  double speedup = 1.0;         // against one thread: of batches beside each other
  double handover = 0.0;        // s, solver::handover_now
  solver::StageTimes stages{};  // s a step
  // Medians over those samples that were quiet.
  int samples = 0, quiet = 0;                    // all, and these; none with more threads than the machine has cores
  double quiet_step = 0.0, quiet_speedup = 0.0;  // s, and against one thread; 0: none
};

struct TimingOptions {
  int batches = 15;  // for each number of threads; up to four times as many until there are enough quiet samples
  int steps = 0;     // in a batch; 0: as many as take 0.1 s
};

/// The numbers of threads take turns, batch by batch, so that whatever else the machine does meets them all.
/// \param counts  numbers of threads, the first of them 1
std::vector<Timing> time_steps(solver::Simulation& sim, std::span<const int> counts, const TimingOptions& o);

}  // namespace voussoir::io
