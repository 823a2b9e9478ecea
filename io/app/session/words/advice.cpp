// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/words/advice.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "cases/case.h"
#include "cases/names.h"
#include "geometry/nth.h"
#include "io/app/session/progress.h"
#include "solver/setup/setup.h"

namespace voussoir::io {

namespace {

constexpr double kBetweenLooks = 0.1;  // s, simulated
constexpr double kWorthIt = 0.1;       // of the time
constexpr double kWait = 1.0;          // s, for after_collapse
// With four rates, of Flat20N (perf/LOG.md, several rates): searches took 2.5 times as long, since they wait for the first step of a cycle
// and then find more; forces and the update 1.35 times what the elements evaluated say, since those near a contact are evaluated more
// often.
constexpr double kMoreSearch = 2.5, kMoreEvaluated = 1.35;

double of(const solver::StageTimes& t, solver::Stage s) { return nth(t, s); }

/// Estimated time of the run at this rate [s]; nothing where it would be no shorter step for step.
std::optional<double> time_at_rate(const cases::Case& c, const solver::Simulation& sim, const RunClock& clock, int multirate) {
  const std::optional<double> share = solver::share_evaluated(sim.world(), c, multirate);
  if (!share) return std::nullopt;
  using enum solver::Stage;
  const solver::StageTimes& t = clock.shaking();
  const double evaluated = of(t, forces) + of(t, damage) + of(t, update);
  const double kept = std::min(1.0, kMoreEvaluated * *share);
  return clock.total() - evaluated * (1.0 - kept) + of(t, search) * (kMoreSearch - 1.0);
}

std::string percent(double share) { return std::to_string(static_cast<int>(100.0 * share + 0.5)) + " %"; }

void add_collapse(std::vector<std::string>& lines, const cases::Case& c, const RunClock& clock, double collapse) {
  if (c.time.after_collapse || is_assessment(c.analysis) || collapse < 0.0) return;
  const double later = clock.after(collapse + kWait);
  if (later < kWorthIt * clock.total()) return;
  lines.push_back("with time.after_collapse = 1 the run would have ended at " + cases::text(collapse + kWait) + " s and taken " +
                  format_duration(later) + " less of " + format_duration(clock.total()));
}

void add_rates(std::vector<std::string>& lines, const cases::Case& c, const solver::Simulation& sim, const RunClock& clock) {
  if (sim.cycle() != 1) return;
  double least = (1.0 - kWorthIt) * clock.total();
  int best = 0;
  for (const int multirate : {2, 4, 8}) {
    const std::optional<double> time = time_at_rate(c, sim, clock, multirate);
    if (time && *time < least) least = *time, best = multirate;
  }
  if (best == 0) return;
  lines.push_back("with time.multirate = " + std::to_string(best) + " it would have taken about " + percent(least / clock.total()) +
                  " of the time");
}

void add_output(std::vector<std::string>& lines, const RunClock& clock) {
  const double share = of(clock.shaking(), solver::Stage::output) / clock.total();
  if (share < kWorthIt) return;
  lines.push_back("writing frames and rows of results took " + percent(share) +
                  " of the time: lengthen output.frame_interval or output.history_interval");
}

void add_threads(std::vector<std::string>& lines, const solver::TeamSize& pace) {
  if (pace.time_of_fewer() < 0.5 * pace.time_of_all() || pace.time_of_all() == 0.0) return;
  lines.push_back("fewer threads than " + std::to_string(pace.most()) + " were faster for " +
                  percent(pace.time_of_fewer() / pace.time_of_all()) +
                  " of the time: other programs used some of the cores, or the model is small for so many");
}

}  // namespace

void RunClock::note(double time, bool settling, double wall, const solver::StageTimes& stages) {
  if (settling) {
    settled_ = stages;
  } else {
    for (std::size_t k = 0; k < stages.size(); ++k) shaking_[k] = stages[k] - settled_[k];
  }
  const bool further = looks_.size() < 2 || time >= looks_[looks_.size() - 2].first + kBetweenLooks;
  if (further)
    looks_.emplace_back(time, wall);
  else
    looks_.back() = {time, wall};
}

double RunClock::after(double time) const {
  const auto later = std::ranges::find_if(looks_, [&](const auto& l) { return l.first >= time; });
  return later == looks_.end() ? 0.0 : total() - later->second;
}

std::string advice_lines(const cases::Case& c, const solver::Simulation& sim, const RunClock& clock, double collapse) {
  if (clock.total() < kWorthAdvice) return {};
  std::vector<std::string> lines;
  add_collapse(lines, c, clock, collapse);
  add_rates(lines, c, sim, clock);
  add_output(lines, clock);
  add_threads(lines, sim.pace());
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "faster               " : "                     ") + line + "\n";
  return text;
}

}  // namespace voussoir::io
