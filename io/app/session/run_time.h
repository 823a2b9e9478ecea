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

/// Wall-clock time of a step of the intact model, shaken at once [s]: what has not moved yet takes a quarter of it. An analysis by dynamics
/// settles meanwhile, since its load is chosen only afterwards. Makes a few steps. \throw solver::NumericalError
double shaken_step(const cases::Case& c, solver::Simulation& sim);

/// The same at one rate, at which all settle. \param sim, step  of the case at its own rates; returned if that is one
/// \throw solver::NumericalError
double one_rate_step(const cases::Case& c, const cases::Model& model, const cases::GroundMotion& motion, const solver::Simulation& sim,
                     double step);

/// Of a time history or an analysis by dynamics. \param step, one_rate  s, shaken_step and one_rate_step
RunTime run_time(const cases::Case& c, const solver::Simulation& sim, double step, double one_rate);

/// The run at every other rate that its step allows, each measured by a few steps. Empty for what has one rate only, and for more than
/// 100,000 elements, whose set-up takes long. \param one_rate  s, as for run_time
std::vector<RateTime> other_rates(const cases::Case& c, const cases::Model& model, const cases::GroundMotion& motion,
                                  const solver::Options& o, double one_rate);

/// Of an analysis by states of rest, where not much breaks [s]; kMuchBreaks times that where much does. Makes a few steps.
/// \throw solver::NumericalError
double rest_time(const cases::Analysis& a, solver::Simulation& sim);
inline constexpr double kMuchBreaks = 5.0;  // as measured on ready houses (cases/catalogue/capacity.md)

}  // namespace voussoir::io
