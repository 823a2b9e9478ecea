// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/run_time.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

#include "cases/case.h"
#include "io/app/session/process.h"
#include "solver/setup/setup.h"
#include "solver/world/errors.h"

namespace voussoir::io {

namespace {

constexpr int kSpells = 5, kWarmUp = 16;
constexpr double kTrialTime = 0.06;   // s of wall-clock time, of a spell
constexpr int kMostTrialSteps = 400;  // of a spell
// A collapsing house took ten times as long as an intact one at one rate (perf/README.md). At several rates, so much of that is the same at
// any of them: searches, waiting, the time before it breaks. Flat20N: 0.38, Flat20W: 0.22 (perf/LOG.md, several rates).
constexpr double kCollapse = 10.0, kSameAtAnyRate = 0.3;
// The time of so many steps of the intact model in all. Where supports move it is a tenth, as two settlements of a house of 3,078 elements
// took.
constexpr double kRestSteps = 360'000.0, kSupportSteps = 0.1 * kRestSteps;
constexpr double kRamp = 1.0, kWaitForRest = 0.5;  // s, simulated: the default ramp, a typical waiting time
constexpr std::size_t kMostRebuilt = 100'000;      // whose other rates are tried

/// Wall-clock time of a step [s]: the median of some spells, each of whole cycles.
double time_a_step(solver::Simulation& sim) {
  using Clock = std::chrono::steady_clock;
  const auto cycle = static_cast<int>(sim.cycle());
  for (int i = 0; i < kWarmUp; ++i) sim.step({});
  std::array<double, kSpells> spells{};
  for (double& spell : spells) {
    const auto start = Clock::now();
    int steps = 0;
    double taken = 0.0;
    while (steps < kMostTrialSteps && taken < kTrialTime) {
      for (int i = 0; i < cycle; ++i) sim.step({});
      steps += cycle;
      taken = std::chrono::duration<double>(Clock::now() - start).count();
    }
    spell = taken / steps;
  }
  std::ranges::sort(spells);
  return spells[kSpells / 2];
}

/// Simulated time before the shaking begins [s].
double settling_time(const cases::Case& c) {
  if (!c.gravity.settle) return 0.0;
  const double ramp = c.gravity.ramp.value_or(c.damping.frequency ? 5.0 / *c.damping.frequency : kRamp);
  return ramp + std::min(c.gravity.settle_limit, kWaitForRest);
}

cases::Case at_rate(const cases::Case& c, int multirate) {
  cases::Case other = c;
  other.time.multirate = multirate;
  return other;
}

}  // namespace

double shaken_step(const cases::Case& c, solver::Simulation& sim) {
  if (sim.phase() == solver::Phase::settling && !cases::is_assessment(c.analysis)) sim.start_shaking();
  return time_a_step(sim);
}

double one_rate_step(const cases::Case& c, const cases::Model& model, const cases::GroundMotion& motion, const solver::Simulation& sim,
                     double step) {
  if (sim.cycle() == 1) return step;
  const cases::Case other = at_rate(c, 1);
  solver::Simulation at_one(other, model, motion, sim.world().options);
  return shaken_step(other, at_one);
}

RunTime run_time(const cases::Case& c, const solver::Simulation& sim, double step, double one_rate) {
  const double settling = settling_time(c) / sim.dt() * one_rate, steps = c.end() / sim.dt();
  const double share = solver::share_evaluated(sim.world(), c, c.multirate()).value_or(1.0);
  const double collapse = kCollapse * (kSameAtAnyRate + (1.0 - kSameAtAnyRate) * share) * one_rate;
  return {settling + steps * step, settling + steps * std::max(collapse, step)};
}

std::vector<RateTime> other_rates(const cases::Case& c, const cases::Model& model, const cases::GroundMotion& motion,
                                  const solver::Options& o, double one_rate) {
  std::vector<RateTime> found;
  if (model.blocks.size() > kMostRebuilt) return found;
  for (const int multirate : {1, 2, 4, 8}) {
    const cases::Case other = at_rate(c, multirate);
    if (multirate == c.multirate() || other.multirate() != multirate) continue;
    give_memory_back();  // of the rate before
    try {
      solver::Simulation sim(other, model, motion, o);
      give_memory_back();
      const double step = shaken_step(other, sim);
      found.push_back({multirate, run_time(other, sim, step, multirate == 1 ? step : one_rate)});
    } catch (const cases::InputError&) {  // supports that turn have one rate
    } catch (const solver::NumericalError&) {
    }
  }
  return found;
}

double rest_time(const cases::Analysis& a, solver::Simulation& sim) {
  return (cases::follows_supports(a) ? kSupportSteps : kRestSteps) * time_a_step(sim);
}

}  // namespace voussoir::io
