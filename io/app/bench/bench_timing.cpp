// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/bench/bench_timing.h"

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "solver/bench/machine.h"

namespace voussoir::io {

namespace {

constexpr double kBatch = 0.1;  // s, of all steps of a batch
constexpr int kSamples = 10;    // in a batch: the load of a machine changes within less than a batch
constexpr int kEnoughQuiet = 30;
constexpr double kQuiet = 1.05;  // ratio to the best time of a core: a core whose other hardware thread is busy takes 1.1 to 2

/// Measurements with one number of threads in one turn.
struct Batch {
  std::vector<Sample> samples;
  double handover = 0.0;  // s
};

/// All measurements with one number of threads.
struct Team {
  int threads = 1, steps = 1;
  std::vector<Batch> batches;
};

Sample take_sample(solver::Simulation& sim, int steps) {
  Sample s{.steps = steps, .time = 0.0, .cores = solver::core_times(sim.world().team)};
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) sim.step({});
  s.time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::vector<double> after = solver::core_times(sim.world().team);
  for (std::size_t k = 0; k < after.size(); ++k) {
    const bool given = s.cores[k] > 0.0 && after[k] > 0.0;
    s.cores[k] = given ? std::max(s.cores[k], after[k]) : 0.0;
  }
  return s;
}

Batch take_batch(solver::Simulation& sim, int steps) {
  Batch b;
  for (int i = 0; i < steps; ++i) sim.step({});  // another team has other shares, and other rows in its caches
  const int samples = std::min(kSamples, steps);
  for (int k = 0; k < samples; ++k) b.samples.push_back(take_sample(sim, steps * (k + 1) / samples - steps * k / samples));
  b.handover = solver::handover_now(sim.world().team);
  return b;
}

int steps_in_a_batch(solver::Simulation& sim, const TimingOptions& o) {
  if (o.steps > 0) return o.steps;
  return std::max(kSamples, static_cast<int>(kBatch * kSamples / take_sample(sim, kSamples).time));
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

/// Time of a step in a batch, over the chosen samples; 0: none.
double step_of(const Batch& b, const std::vector<bool>& chosen) {
  double sum = 0.0;
  std::int64_t steps = 0;
  for (std::size_t k = 0; k < b.samples.size(); ++k) {
    if (chosen[k]) sum += b.samples[k].time, steps += b.samples[k].steps;
  }
  return steps > 0 ? sum / static_cast<double>(steps) : 0.0;
}

/// By batch and sample: whether it was quiet.
std::vector<std::vector<bool>> quiet_samples(const Team& team) {
  std::vector<Sample> all;
  for (const Batch& b : team.batches) all.insert(all.end(), b.samples.begin(), b.samples.end());
  std::vector<bool> is_quiet(all.size(), false);
  if (team.threads <= solver::processors()) is_quiet = quiet(all);
  std::vector<std::vector<bool>> by_batch;
  auto next = is_quiet.begin();
  for (const Batch& b : team.batches) {
    const auto end = next + static_cast<std::ptrdiff_t>(b.samples.size());
    by_batch.emplace_back(next, end);
    next = end;
  }
  return by_batch;
}

std::int64_t count(const std::vector<std::vector<bool>>& chosen) {
  std::int64_t n = 0;
  for (const std::vector<bool>& batch : chosen) n += std::ranges::count(batch, true);
  return n;
}

bool enough(const std::vector<Team>& teams, const TimingOptions& o) {
  const int taken = static_cast<int>(teams.front().batches.size());
  if (taken < o.least) return false;
  return taken >= o.most || std::ranges::all_of(teams, [](const Team& t) {
           return t.threads > solver::processors() || count(quiet_samples(t)) >= kEnoughQuiet;
         });
}

/// Time of a step and speed-up relative to one thread, over the batches with a chosen sample.
struct Steps {
  double step = 0.0, speedup = 0.0;
};
Steps steps_of(const Team& team, const std::vector<std::vector<bool>>& chosen, const Team& one,
               const std::vector<std::vector<bool>>& chosen_of_one) {
  std::vector<double> steps, speedups;
  for (std::size_t b = 0; b < team.batches.size(); ++b) {
    const double step = step_of(team.batches[b], chosen[b]), on_one = step_of(one.batches[b], chosen_of_one[b]);
    if (step > 0.0) steps.push_back(step);
    if (step > 0.0 && on_one > 0.0) speedups.push_back(on_one / step);
  }
  return {median(steps), median(speedups)};
}

/// \param one  the team of one thread, with a batch beside each of `team`
Timing timing_of(const Team& team, const Team& one) {
  const std::vector<bool> all(kSamples, true);
  const std::vector<std::vector<bool>> every(team.batches.size(), all), those = quiet_samples(team);
  Timing t;
  t.threads = team.threads, t.steps = team.steps;
  const Steps steps = steps_of(team, every, one, every), quiet_steps = steps_of(team, those, one, quiet_samples(one));
  t.step = steps.step, t.speedup = steps.speedup;
  std::vector<double> handovers;
  for (const Batch& b : team.batches) handovers.push_back(b.handover);
  t.handover = median(std::move(handovers));
  for (const Batch& b : team.batches) t.samples += static_cast<int>(b.samples.size());
  t.quiet = static_cast<int>(count(those));
  t.quiet_step = quiet_steps.step, t.quiet_speedup = quiet_steps.speedup;
  return t;
}

}  // namespace

std::vector<bool> quiet(std::span<const Sample> samples) {
  std::vector<double> best;
  for (const Sample& s : samples) {
    best.resize(std::max(best.size(), s.cores.size()), 1e300);
    for (std::size_t k = 0; k < s.cores.size(); ++k) {
      if (s.cores[k] > 0.0) best[k] = std::min(best[k], s.cores[k]);
    }
  }
  std::vector<bool> quiet;
  for (const Sample& s : samples) {
    bool all = true;
    for (std::size_t k = 0; k < s.cores.size(); ++k) all &= s.cores[k] > 0.0 && s.cores[k] <= kQuiet * best[k];
    quiet.push_back(all);
  }
  return quiet;
}

std::vector<Timing> time_steps(solver::Simulation& sim, std::span<const int> counts, const TimingOptions& o) {
  const int before = sim.threads();
  std::vector<Team> teams;
  for (const int threads : counts) {
    sim.set_threads(threads);
    teams.push_back({threads, steps_in_a_batch(sim, o), {}});
  }
  while (!enough(teams, o)) {
    for (Team& team : teams) {
      sim.set_threads(team.threads);
      team.batches.push_back(take_batch(sim, team.steps));
    }
  }
  sim.set_threads(before);
  std::vector<Timing> timings;
  for (const Team& team : teams) timings.push_back(timing_of(team, teams.front()));
  return timings;
}

}  // namespace voussoir::io
