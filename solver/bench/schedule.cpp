// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/schedule.h"

#include <algorithm>
#include <numeric>

#include "geometry/nth.h"

namespace voussoir::solver {

namespace {

constexpr int kMoves = 40;    // of borders, until they have found their places
constexpr int kNotes = 64;    // rounds between two moves (ShareBorders)
constexpr int kBarriers = 4;  // a step: into the team and out of it, for forces and for the update

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Borders and queues of a team that has worked on these tasks for a while; the best that it had, for borders go to and fro.
QueueTimes settled(const JointTasks& tasks, const MeasuredStep& m, int cores) {
  ShareBorders borders(cores);
  QueueTimes best;
  for (int move = 0; move < kMoves; ++move) {
    QueueTimes now = go_through(tasks, tasks.plan(borders.ends()), m.tasks, m.handover);
    for (int k = 0; k < kNotes; ++k) borders.note(now.end);
    if (best.end.empty() || std::ranges::max(now.end) < std::ranges::max(best.end)) best = std::move(now);
  }
  return best;
}

/// What one thread does of all stages but the forces.
double alone_of_stages(const MeasuredStep& m) {
  const auto at = [](const StageTimes& times, Stage s) { return nth(times, s); };
  double alone = at(m.one, Stage::damage) + at(m.one, Stage::output);
  for (const Stage s : {Stage::search, Stage::ledger}) alone += std::clamp(2.0 * at(m.two, s) - at(m.one, s), 0.0, at(m.one, s));
  return alone;
}

}  // namespace

QueueTimes go_through(const JointTasks& tasks, const JointTasks::Plan& plan, const std::vector<double>& times, double handover) {
  const std::size_t threads = plan.ends.size();
  QueueTimes out{std::vector<double>(threads, 0.0), std::vector<double>(threads, 0.0)};
  std::vector<double> done(times.size(), -1.0);  // when; before 0: not yet
  std::vector<std::int32_t> next(threads, 0);
  for (std::size_t t = 1; t < threads; ++t) next[t] = plan.ends[t - 1];
  for (std::size_t left = times.size(); left > 0;) {
    for (std::size_t t = 0; t < threads; ++t) {
      for (; next[t] < plan.ends[t]; ++next[t], --left) {
        const auto task = static_cast<std::size_t>(nth(plan.queues, next[t]));
        const std::span<const std::int32_t> before = tasks.before(task);
        if (std::ranges::any_of(before, [&](std::int32_t b) { return nth(done, b) < 0.0; })) break;
        double begin = out.end[t];
        for (const std::int32_t b : before) {
          const auto other = static_cast<std::size_t>(b);
          begin = std::max(begin, done[other] + (plan.owner[other] == t ? 0.0 : handover));
        }
        out.waited[t] += begin - out.end[t];
        out.end[t] = done[task] = begin + times[task];
      }
    }
  }
  return out;
}

PredictedStep predict(const JointTasks& tasks, const MeasuredStep& m, int cores) {
  const double n = cores;
  const QueueTimes joints = settled(tasks, m, cores);
  const auto part = [&](ForcePart p) { return nth(m.parts, p); };
  const double all_tasks = std::accumulate(m.tasks.begin(), m.tasks.end(), 0.0);
  const double contacts = part(ForcePart::contacts) + part(ForcePart::assembly);
  const double forces = nth(m.one, Stage::forces);
  const double stages = std::accumulate(m.one.begin(), m.one.end(), 0.0) - forces;
  const double alone = alone_of_stages(m);
  PredictedStep p{.cores = cores};
  p.joints = all_tasks / n, p.contacts = contacts / n;
  const double barriers = cores > 1 ? kBarriers * n * m.handover : 0.0;
  p.waiting = mean(joints.waited) + std::ranges::max(joints.end) - mean(joints.end) + barriers;
  p.alone = alone + m.alone;
  p.others = (stages - alone) / n;
  p.step = p.joints + p.contacts + p.waiting + p.others + p.alone;
  return p;
}

}  // namespace voussoir::solver
