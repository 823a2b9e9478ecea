// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/bench_timing.h"

#include <omp.h>

#include <algorithm>

#include "solver/machine.h"

namespace voussoir::io {

namespace {

constexpr double kBatch = 0.1;    // s, of steps
constexpr int kSamples = 10;      // in a batch: what neighbours do changes within less than that
constexpr int kMostBatches = 4;   // times as many as asked for
constexpr int kEnoughQuiet = 30;  // samples
constexpr double kQuiet = 1.05;   // of what a core took at best: one whose other half is at work for others takes 1.1 to 2

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

struct Batch {
  std::vector<Sample> samples;  // as many steps each
  double handover = 0.0;        // s
};

/// The mean of some figure of its samples.
template <class Figure>
double mean(const Batch& b, Figure figure) {
  double sum = 0.0;
  for (const Sample& s : b.samples) sum += figure(s);
  return sum / static_cast<double>(b.samples.size());
}
double mean_step(const Batch& b) {
  return mean(b, [](const Sample& s) { return s.step; });
}

Sample take_sample(solver::Simulation& sim, int steps) {
  const int threads = omp_get_max_threads();
  Sample sample;
  sample.cores = solver::core_times(threads);
  const solver::StageTimes before = sim.stage_times();
  const double start = omp_get_wtime();
  for (int i = 0; i < steps; ++i) sim.step({});
  sample.step = (omp_get_wtime() - start) / steps;
  for (std::size_t k = 0; k < before.size(); ++k) sample.stages[k] = (sim.stage_times()[k] - before[k]) / steps;
  const std::vector<double> after = solver::core_times(threads);
  for (std::size_t k = 0; k < after.size(); ++k) sample.cores[k] = std::max(sample.cores[k], after[k]);
  return sample;
}

Batch take_batch(solver::Simulation& sim, int steps) {
  Batch b;
  for (int i = 0; i < steps; ++i) sim.step({});  // another team has other shares, and other rows in its caches
  for (int k = 0; k < kSamples; ++k) b.samples.push_back(take_sample(sim, std::max(1, steps / kSamples)));
  b.handover = solver::handover_now(omp_get_max_threads());
  return b;
}

int steps_in_a_batch(solver::Simulation& sim, const TimingOptions& o) {
  if (o.steps > 0) return o.steps;
  return std::max(kSamples, static_cast<int>(kBatch / take_sample(sim, kSamples).step));
}

/// All that was measured with one number of threads.
struct Team {
  int threads = 1, steps = 1;
  std::vector<Batch> batches;

  [[nodiscard]] std::vector<Sample> quiet_samples() const {
    if (threads > omp_get_num_procs()) return {};
    std::vector<Sample> all, those;
    for (const Batch& b : batches) all.insert(all.end(), b.samples.begin(), b.samples.end());
    const std::vector<bool> is_quiet = quiet(all);
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (is_quiet[k]) those.push_back(all[k]);
    }
    return those;
  }
};

bool enough(const std::vector<Team>& teams, const TimingOptions& o) {
  const int taken = static_cast<int>(teams.front().batches.size());
  if (taken < o.batches) return false;
  return taken >= kMostBatches * o.batches || std::ranges::all_of(teams, [](const Team& t) {
           return t.threads > omp_get_num_procs() || t.quiet_samples().size() >= kEnoughQuiet;
         });
}

/// \param one  the team of one thread, with a batch beside each of these
Timing timing_of(const Team& team, const Team& one) {
  const auto over_batches = [&](auto figure) {
    std::vector<double> figures;
    for (std::size_t b = 0; b < team.batches.size(); ++b) figures.push_back(figure(b));
    return median(std::move(figures));
  };
  const auto quiet_step = [](const std::vector<Sample>& samples) {
    std::vector<double> steps;
    for (const Sample& s : samples) steps.push_back(s.step);
    return median(std::move(steps));
  };
  Timing t;
  t.threads = team.threads;
  t.step = over_batches([&](std::size_t b) { return mean_step(team.batches[b]); });
  t.speedup = over_batches([&](std::size_t b) { return mean_step(one.batches[b]) / mean_step(team.batches[b]); });
  t.handover = over_batches([&](std::size_t b) { return team.batches[b].handover; });
  for (std::size_t k = 0; k < t.stages.size(); ++k) {
    t.stages[k] = over_batches([&](std::size_t b) { return mean(team.batches[b], [&](const Sample& s) { return s.stages[k]; }); });
  }
  const std::vector<Sample> those = team.quiet_samples();
  t.samples = static_cast<int>(team.batches.size()) * kSamples;
  t.quiet = static_cast<int>(those.size());
  t.quiet_step = quiet_step(those);
  if (t.quiet > 0) t.quiet_speedup = quiet_step(one.quiet_samples()) / t.quiet_step;
  return t;
}

}  // namespace

std::vector<bool> quiet(std::span<const Sample> samples) {
  std::vector<double> best;
  for (const Sample& s : samples) {
    best.resize(std::max(best.size(), s.cores.size()), 1e300);
    for (std::size_t k = 0; k < s.cores.size(); ++k) best[k] = std::min(best[k], s.cores[k]);
  }
  std::vector<bool> quiet;
  for (const Sample& s : samples) {
    bool all = true;
    for (std::size_t k = 0; k < s.cores.size(); ++k) all &= s.cores[k] <= kQuiet * best[k];
    quiet.push_back(all);
  }
  return quiet;
}

std::vector<Timing> time_steps(solver::Simulation& sim, std::span<const int> counts, const TimingOptions& o) {
  std::vector<Team> teams;
  for (const int threads : counts) {
    omp_set_num_threads(threads);
    teams.push_back({threads, steps_in_a_batch(sim, o), {}});
  }
  while (!enough(teams, o)) {
    for (Team& team : teams) {
      omp_set_num_threads(team.threads);
      team.batches.push_back(take_batch(sim, team.steps));
    }
  }
  std::vector<Timing> timings;
  for (const Team& team : teams) timings.push_back(timing_of(team, teams.front()));
  return timings;
}

}  // namespace voussoir::io
