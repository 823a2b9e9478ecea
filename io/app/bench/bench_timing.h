// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "solver/run/simulation.h"

/// How long a step takes, on a machine that others use, too.
namespace voussoir::io {

/// Some steps, a tenth of a batch.
struct Sample {
  int steps = 0;
  double time = 0.0;          // s, of all of them
  std::vector<double> cores;  // s, by thread: solver::core_times beside them, the longer of before and after; 0: not given
};

/// Which of these samples of one team were quiet: each of its cores was as fast beside them as beside any, or nearly.
std::vector<bool> quiet(std::span<const Sample> samples);

/// What a step takes with so many threads: medians over batches.
struct Timing {
  int threads = 1;
  int steps = 1;  // in a batch
  // Whatever the machine did.
  double step = 0.0;      // s
  double speedup = 1.0;   // against one thread, of batches beside each other
  double handover = 0.0;  // s, solver::handover_now
  // The same by those samples of each batch that were quiet; none with more threads than the machine has cores.
  int samples = 0, quiet = 0;                    // all, and these
  double quiet_step = 0.0, quiet_speedup = 0.0;  // s; 0: none
};

struct TimingOptions {
  int least = 15, most = 60;  // batches for each number of threads: more than the least until thirty samples of each were quiet
  int steps = 0;              // in a batch; 0: as many as take 0.1 s
};

/// The numbers of threads take turns, batch by batch, so that whatever else the machine does meets them all. The simulation has its own
/// number of threads again afterwards.
/// \param counts  numbers of threads, the first of them 1
std::vector<Timing> time_steps(solver::Simulation& sim, std::span<const int> counts, const TimingOptions& o);

}  // namespace voussoir::io
