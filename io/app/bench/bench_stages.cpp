// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/bench/bench_stages.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "cases/case.h"
#include "geometry/nth.h"
#include "solver/bench/assembly_time.h"

namespace voussoir::io {

namespace {

/// Times of a batch [s per step].
struct StagesBatch {
  std::int64_t steps = 0;
  StepParts parts{};
  solver::StepWork work;  // of the last step
  solver::StageTimes stages{};
  solver::ForceTimes forces{};
  std::vector<double> tasks;
  double alone = 0.0;  // s, of forces on one thread
};

template <std::size_t n>
std::array<double, n> a_step(const std::array<double, n>& before, std::array<double, n> now, std::int64_t steps) {
  for (std::size_t k = 0; k < n; ++k) now[k] = (now[k] - before[k]) / static_cast<double>(steps);
  return now;
}

/// Share of sides in whole blocks among all sides with forces.
double whole_share(const solver::StepWork& work) {
  const double sides = work.whole_sides + work.damaged_sides;
  return sides > 0.0 ? work.whole_sides / sides : 0.0;
}

StagesBatch take_batch(const RunInHand& run, const cases::Case& endless, int steps, solver::JointTasks& tasks) {
  constexpr double kNever = 1e6;  // s
  solver::Simulation& sim = run.sim;
  const solver::StageTimes stages = sim.stage_times();
  const solver::ForceTimes forces = sim.part_times();
  const std::vector<double> before = sim.joint_tasks().task_times();
  const double alone = sim.alone_time();
  const std::int64_t first = run.plan.steps;
  double scatter = 0.0;
  int scatters = 0;
  solver::run(sim, run.plan, endless, kNever, run.results, [&](const solver::RunStatus& at) {
    if (at.step > first) {  // the first step was done by another team
      scatter += solver::assembly_time(sim.world(), tasks), ++scatters;
    }
    return at.step < first + steps;
  });
  StagesBatch b{.steps = run.plan.steps - first, .work = solver::step_work(sim.world()), .tasks = sim.joint_tasks().task_times()};
  b.stages = a_step(stages, sim.stage_times(), b.steps), b.forces = a_step(forces, sim.part_times(), b.steps);
  b.parts = parts_of(b.stages, b.forces, scatters > 0 ? scatter / scatters : 0.0, whole_share(b.work));
  b.alone = (sim.alone_time() - alone) / static_cast<double>(b.steps);
  for (std::size_t k = 0; k < b.tasks.size(); ++k) b.tasks[k] = (b.tasks[k] - before[k]) / static_cast<double>(b.steps);
  return b;
}

bool is_rare(std::size_t part) {
  const auto p = static_cast<StepPart>(part);
  return p == StepPart::search || p == StepPart::ledger || p == StepPart::output;
}

double over_batches(const std::vector<StagesBatch>& batches, std::size_t part) {
  if (is_rare(part)) {
    double sum = 0.0, steps = 0.0;
    for (const StagesBatch& b : batches) sum += b.parts[part] * static_cast<double>(b.steps), steps += static_cast<double>(b.steps);
    return sum / steps;
  }
  std::vector<double> times;
  for (const StagesBatch& b : batches) times.push_back(b.parts[part]);
  std::ranges::sort(times);
  return 0.5 * (times[(times.size() - 1) / 2] + times[times.size() / 2]);
}

solver::StepWork mean_work(const std::vector<StagesBatch>& batches) {
  solver::StepWork mean;
  const auto n = static_cast<double>(batches.size());
  for (const StagesBatch& b : batches) {
    using Part = solver::Work solver::StepWork::*;
    using W = solver::StepWork;
    for (const Part part : {&W::whole_joints, &W::damaged_joints, &W::contacts, &W::assembly, &W::update}) {
      (mean.*part).operations += (b.work.*part).operations / n, (mean.*part).bytes += (b.work.*part).bytes / n;
    }
    mean.whole_sides += b.work.whole_sides / n, mean.damaged_sides += b.work.damaged_sides / n;
  }
  return mean;
}

double all_steps(const std::vector<StagesBatch>& batches) {
  double steps = 0.0;
  for (const StagesBatch& b : batches) steps += static_cast<double>(b.steps);
  return steps;
}

/// Mean over all steps of one of their arrays.
template <class Array>
Array mean_times(const std::vector<StagesBatch>& batches, Array StagesBatch::*times) {
  Array mean = batches.front().*times;
  std::ranges::fill(mean, 0.0);
  for (const StagesBatch& b : batches) {
    const double share = static_cast<double>(b.steps) / all_steps(batches);
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += share * (b.*times)[k];
  }
  return mean;
}

double mean_alone(const std::vector<StagesBatch>& batches) {
  double mean = 0.0;
  for (const StagesBatch& b : batches) mean += static_cast<double>(b.steps) / all_steps(batches) * b.alone;
  return mean;
}

/// All measurements with one number of threads.
struct StagesTeam {
  int threads = 1, steps_in_a_batch = 1;
  std::vector<StagesBatch> batches;
};

}  // namespace

double StepSplit::step() const { return std::accumulate(parts.begin(), parts.end(), 0.0); }

StepParts parts_of(const solver::StageTimes& stages, const solver::ForceTimes& forces, double scatter, double whole_share) {
  const auto stage = [&](solver::Stage s) { return nth(stages, s); };
  const auto force = [&](solver::ForcePart p) { return nth(forces, p); };
  StepParts parts{};
  const auto put = [&](StepPart p, double time) { nth(parts, p) = time; };
  const double whole = force(solver::ForcePart::whole_joints), damaged = force(solver::ForcePart::damaged_joints);
  const double of_whole = std::min(whole, whole_share * scatter), of_damaged = std::min(damaged, (1.0 - whole_share) * scatter);
  put(StepPart::whole_joints, whole - of_whole);
  put(StepPart::damaged_joints, damaged - of_damaged);
  put(StepPart::contacts, force(solver::ForcePart::contacts));
  put(StepPart::assembly, force(solver::ForcePart::assembly) + of_whole + of_damaged);
  put(StepPart::waiting, std::max(0.0, stage(solver::Stage::forces) - std::accumulate(forces.begin(), forces.end(), 0.0)));
  put(StepPart::search, stage(solver::Stage::search));
  put(StepPart::damage, stage(solver::Stage::damage));
  put(StepPart::update, stage(solver::Stage::update));
  put(StepPart::ledger, stage(solver::Stage::ledger));
  put(StepPart::output, stage(solver::Stage::output));
  return parts;
}

std::vector<StepSplit> split_steps(const RunInHand& run, std::span<const int> counts, std::span<const int> steps, int batches) {
  const int before = run.sim.threads();
  cases::Case endless = run.value;
  endless.time.after_collapse.reset();
  solver::JointTasks tasks(run.sim.world());
  std::vector<StagesTeam> teams;
  for (std::size_t k = 0; k < counts.size(); ++k) teams.push_back({counts[k], steps[k], {}});
  run.sim.time_parts(true);
  for (int b = 0; b < batches; ++b) {
    for (StagesTeam& team : teams) {
      run.sim.set_threads(team.threads);
      take_batch(run, endless, 1, tasks);  // another team has other shares, and other rows in its caches
      team.batches.push_back(take_batch(run, endless, team.steps_in_a_batch, tasks));
    }
  }
  run.sim.time_parts(false);
  run.sim.set_threads(before);
  // A run writes its rows to disk at intervals.
  const auto start = std::chrono::steady_clock::now();
  run.results.flush();
  const double writing = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / ResultsOptions{}.interval;
  std::vector<StepSplit> splits;
  for (const StagesTeam& team : teams) {
    StepSplit s{.threads = team.threads,
                .work = mean_work(team.batches),
                .stages = mean_times(team.batches, &StagesBatch::stages),
                .forces = mean_times(team.batches, &StagesBatch::forces),
                .tasks = mean_times(team.batches, &StagesBatch::tasks),
                .alone = mean_alone(team.batches)};
    for (std::size_t part = 0; part < s.parts.size(); ++part) s.parts[part] = over_batches(team.batches, part);
    nth(s.parts, StepPart::output) += writing * s.step();
    splits.push_back(s);
  }
  return splits;
}

}  // namespace voussoir::io
