// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/census.h"
#include "io/app/bench/bench_stages.h"
#include "io/app/bench/bench_table.h"
#include "io/app/bench/bench_timing.h"
#include "solver/bench/schedule.h"

/// The tables of `voussoir bench`.
namespace voussoir::io {

/// The table of step times, one row per number of threads.
Cells timing_header();
Cells timing_row(const Timing& t, const cases::Census& n);

/// Best performance of a machine for a number of threads.
struct MachineLimits {
  double flops = 0.0, bandwidth = 0.0;  // flop/s, byte/s
};

/// The table of step times by part, and their share of the limits: a row for each part, and one for the sum.
Cells stage_header();
std::vector<Cells> stage_rows(const StepSplit& split, MachineLimits best);

/// The table of step times predicted for more cores (solver/bench/schedule.h).
Cells schedule_header();
/// \param scale  of all predicted times, since reading clocks took part of the time from which they were derived
/// \param on_one  s, of a step on one core \param measured  s, of a step on the predicted number of cores; 0: not measured
Cells schedule_row(const solver::PredictedStep& p, double scale, double on_one, double measured);

}  // namespace voussoir::io
