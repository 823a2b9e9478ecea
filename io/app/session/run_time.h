// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "cases/forward.h"
#include "cases/model.h"
#include "solver/run/simulation.h"

/// How long a run takes. Steps of the intact model are timed on this machine.
namespace voussoir::io {

/// Wall-clock times of a step of the intact model [s].
struct StepTimes {
  double settling = 0.0, shaking = 0.0;
};

/// Wall-clock time of a run [s].
struct RunTime {
  double intact = 0.0;    // if nothing breaks
  double collapse = 0.0;  // if it collapses, within a factor of two: by how much has fallen when
};

/// `time.multirate` and the time of a run with it.
struct RateTime {
  int multirate = 1;
  RunTime time;
};

/// Makes a few steps; then, at several rates, ends settling and makes a few more. \pre no step has been made
/// \throw solver::NumericalError
StepTimes time_steps(solver::Simulation& sim);

/// Of a time history or an analysis by dynamics, whose intact step was timed. \param one_rate  s, time of its step where all elements are
/// evaluated in every step
RunTime run_time(const cases::Case& c, const solver::Simulation& sim, const StepTimes& times, double one_rate);

/// Of a case with several rates [s]: time of a step of the intact model at one rate. \throw solver::NumericalError
double one_rate_step(const cases::Case& c, const cases::Model& model, const cases::GroundMotion& motion, const solver::Options& o);

/// The run at every other rate that its step allows, each measured by a few steps. Empty for what has one rate only, and for more than
/// 100,000 elements, whose set-up takes long. \param one_rate  s, as for run_time
std::vector<RateTime> other_rates(const cases::Case& c, const cases::Model& model, const cases::GroundMotion& motion,
                                  const solver::Options& o, double one_rate);

/// Of an analysis by states of rest, where not much breaks [s]; kMuchBreaks times that where much does. \param step  s, time of a step
double rest_time(const cases::Analysis& a, double step);
inline constexpr double kMuchBreaks = 5.0;  // as measured on ready houses (cases/catalogue/capacity.md)

}  // namespace voussoir::io
