// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/bench_stages.h"

#include <omp.h>

#include <algorithm>
#include <numeric>

#include "solver/step_work.h"

namespace voussoir::io {

namespace {

/// What a batch took, s of all its steps.
struct Batch {
  std::int64_t steps = 0;
  solver::StageTimes stages{};
  solver::ForceTimes forces{};  // of the mean thread
  double scatter = 0.0;         // s a step, likewise: of joints, by colour
};

template <std::size_t n>
std::array<double, n> since(const std::array<double, n>& before, std::array<double, n> now) {
  for (std::size_t k = 0; k < n; ++k) now[k] -= before[k];
  return now;
}

Batch take_batch(const RunInHand& run, const cases::Case& endless, int steps, solver::JointTasks& tasks) {
  constexpr double kNever = 1e6;  // s
  solver::Simulation& sim = run.sim;
  const solver::StageTimes stages = sim.stage_times();
  const solver::ForceTimes forces = sim.part_times();
  const std::int64_t first = run.plan.steps;
  double scatter = 0.0;
  int scatters = 0;
  solver::run(sim, run.plan, endless, kNever, run.results, [&](const solver::RunStatus& at) {
    if (!sim.world().options.gather && at.step > first) {  // not of a step that another team has done
      scatter += solver::scatter_again(sim.world(), tasks), ++scatters;
    }
    return at.step < first + steps;
  });
  Batch b{run.plan.steps - first, since(stages, sim.stage_times()), since(forces, sim.part_times()), 0.0};
  for (double& t : b.forces) t /= omp_get_max_threads();
  if (scatters > 0) b.scatter = scatter / scatters / omp_get_max_threads();
  return b;
}

/// Of all sides that hand out forces, the share of those in whole blocks.
double whole_share(const solver::World& w) {
  const solver::StepWork work = solver::step_work(w);
  const double sides = work.whole_sides + work.damaged_sides;
  return sides > 0.0 ? work.whole_sides / sides : 0.0;
}

StepParts parts_of(const Batch& b, double whole_share) {
  const auto steps = static_cast<double>(b.steps);
  const auto stage = [&](solver::Stage s) { return b.stages[static_cast<std::size_t>(s)] / steps; };
  const auto force = [&](solver::ForcePart p) { return b.forces[static_cast<std::size_t>(p)] / steps; };
  StepParts parts{};
  const auto put = [&](StepPart p, double time) { parts[static_cast<std::size_t>(p)] = std::max(time, 0.0); };
  put(StepPart::whole_joints, force(solver::ForcePart::whole_joints) - whole_share * b.scatter);
  put(StepPart::damaged_joints, force(solver::ForcePart::damaged_joints) - (1.0 - whole_share) * b.scatter);
  put(StepPart::contacts, force(solver::ForcePart::contacts));
  put(StepPart::scatter, force(solver::ForcePart::scatter) + b.scatter);
  put(StepPart::waiting, stage(solver::Stage::forces) - std::accumulate(b.forces.begin(), b.forces.end(), 0.0) / steps);
  put(StepPart::search, stage(solver::Stage::search));
  put(StepPart::damage, stage(solver::Stage::damage));
  put(StepPart::update, stage(solver::Stage::update));
  put(StepPart::ledger, stage(solver::Stage::ledger));
  put(StepPart::output, stage(solver::Stage::output));
  return parts;
}

bool is_rare(std::size_t part) {
  const auto p = static_cast<StepPart>(part);
  return p == StepPart::search || p == StepPart::ledger || p == StepPart::output;
}

/// \param batches  what each step of each took, and how many steps it had
double over_batches(const std::vector<StepParts>& batches, const std::vector<double>& steps, std::size_t part) {
  std::vector<double> times;
  for (const StepParts& b : batches) times.push_back(b[part]);
  if (is_rare(part)) {
    return std::inner_product(times.begin(), times.end(), steps.begin(), 0.0) / std::accumulate(steps.begin(), steps.end(), 0.0);
  }
  std::ranges::sort(times);
  return 0.5 * (times[(times.size() - 1) / 2] + times[times.size() / 2]);
}

/// All that was measured with one number of threads.
struct Team {
  int threads = 1, steps_in_a_batch = 1;
  std::vector<StepParts> batches;
  std::vector<double> steps;  // of each
};

}  // namespace

double StepSplit::step() const { return std::accumulate(parts.begin(), parts.end(), 0.0); }

std::vector<StepSplit> split_steps(const RunInHand& run, std::span<const int> counts, std::span<const int> steps, int batches) {
  const int before = omp_get_max_threads();
  cases::Case endless = run.value;
  endless.time.after_collapse.reset();
  solver::JointTasks tasks(run.sim.world());
  std::vector<Team> teams;
  for (std::size_t k = 0; k < counts.size(); ++k) teams.push_back({counts[k], steps[k], {}, {}});
  run.sim.time_parts(true);
  for (int b = 0; b < batches; ++b) {
    for (Team& team : teams) {
      omp_set_num_threads(team.threads);
      take_batch(run, endless, 1, tasks);  // another team has other shares, and other rows in its caches
      const Batch batch = take_batch(run, endless, team.steps_in_a_batch, tasks);
      team.batches.push_back(parts_of(batch, whole_share(run.sim.world())));
      team.steps.push_back(static_cast<double>(batch.steps));
    }
  }
  run.sim.time_parts(false);
  omp_set_num_threads(before);
  // A run writes its rows to the disk every so often.
  const double start = omp_get_wtime();
  run.results.flush();
  const double writing = (omp_get_wtime() - start) / ResultsOptions{}.interval;
  std::vector<StepSplit> splits;
  for (const Team& team : teams) {
    StepSplit s{.threads = team.threads, .parts = {}};
    for (std::size_t part = 0; part < s.parts.size(); ++part) s.parts[part] = over_batches(team.batches, team.steps, part);
    s.parts[static_cast<std::size_t>(StepPart::output)] += writing * s.step();
    splits.push_back(s);
  }
  return splits;
}

}  // namespace voussoir::io
