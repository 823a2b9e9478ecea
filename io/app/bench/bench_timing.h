// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "solver/run/simulation.h"

/// Measurement of the time of a step on a machine that is also used by others.
namespace voussoir::io {

/// A tenth of a batch of steps.
struct Sample {
  int steps = 0;
  double time = 0.0;          // s, of all its steps
  std::vector<double> cores;  // s, by thread: longer solver::core_times of before and after the steps; 0: not available
};

/// By sample of one team (one number of threads): whether it was quiet, i.e. each core was about as fast as in the best sample.
std::vector<bool> quiet(std::span<const Sample> samples);

/// Time of a step for a number of threads: medians over batches.
struct Timing {
  int threads = 1;
  int steps = 1;  // in a batch
  // All samples.
  double step = 0.0;      // s
  double speedup = 1.0;   // relative to one thread, from batches measured in succession
  double handover = 0.0;  // s, solver::handover_now
  // Quiet samples of each batch only; none with more threads than the machine has cores.
  int samples = 0, quiet = 0;                    // number of all samples, and of quiet ones
  double quiet_step = 0.0, quiet_speedup = 0.0;  // s; 0: none
};

struct TimingOptions {
  int least = 15, most = 60;  // batches for each number of threads: more than the least until thirty samples of each were quiet
  int steps = 0;              // in a batch; 0: the number that takes 0.1 s
};

/// Measures all numbers of threads in turn, batch by batch, so that other load of the machine affects all equally. Restores the
/// simulation's number of threads.
/// \param counts  numbers of threads, the first of them 1
std::vector<Timing> time_steps(solver::Simulation& sim, std::span<const int> counts, const TimingOptions& o);

}  // namespace voussoir::io
