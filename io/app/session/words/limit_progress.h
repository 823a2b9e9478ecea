// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "io/app/session/progress.h"
#include "solver/limit/limit.h"

namespace voussoir::io {

/// Progress of a limit analysis on standard error: on a terminal one line that is overwritten, elsewhere a line at intervals.
class LimitProgress {
 public:
  /// \param quiet  nothing is written \param coulomb  whether more than one linear programme is to come
  LimitProgress(bool quiet, bool coulomb);
  LimitProgress(const LimitProgress&) = delete;
  LimitProgress& operator=(const LimitProgress&) = delete;
  /// Ends the line on a terminal.
  ~LimitProgress();

  /// Lets the analysis tell what it does. The progress has to outlive it.
  void watch(solver::LimitOptions& options);

 private:
  using Clock = std::chrono::steady_clock;
  void took(int programmes, double multiplier);
  void iterated(int iteration, double gap);
  void write(const char* text);

  Progress::Mode mode_;
  int least_, most_;  // number of programmes that the analysis takes
  Clock::time_point last_ = Clock::now();
  bool pending_ = false;  // a line on a terminal has no end
};

}  // namespace voussoir::io
