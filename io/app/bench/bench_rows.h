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

/// What a step takes with some number of threads.
Cells timing_header();
Cells timing_row(bool gather, const Timing& t, const cases::Census& n);

/// What a machine can do with some number of threads at best.
struct MachineLimits {
  double flops = 0.0, bandwidth = 0.0;  // flop/s, byte/s
};

/// Where it goes, and what that is of the limits: a row for each part, and one for all.
Cells stage_header();
std::vector<Cells> stage_rows(bool gather, const StepSplit& split, MachineLimits best);

/// What the model of the schedule (solver/bench/schedule.h) says of more cores.
Cells schedule_header();
/// \param scale  of all its times, since looking at clocks took some of what it was made from
/// \param on_one  s, of a step on one core \param measured  s, on as many as these; 0: not measured
Cells schedule_row(const solver::PredictedStep& p, double scale, double on_one, double measured);

}  // namespace voussoir::io
