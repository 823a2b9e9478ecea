// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/schedule/task_shares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voussoir::solver {

TaskShares::OfTeam::OfTeam(int threads) : shares(static_cast<std::size_t>(threads)), borders(threads) {}

void TaskShares::OfTeam::give(std::size_t thread, std::int32_t end) {
  Share& s = shares[thread];
  const std::int32_t first = thread == 0 ? 0 : shares[thread - 1].last;
  s.had = end - first, s.done = 0, s.time = 0.0;
  s.next.store(first, std::memory_order_relaxed), s.begun.store(false, std::memory_order_relaxed);
  s.last = end;
}

/// By what each share would have taken its thread, had nobody helped; waiting for the tasks of others counts, too.
bool TaskShares::OfTeam::move_borders() {
  std::vector<double> times;
  double most = 0.0;
  for (const Share& s : shares) {
    times.push_back(s.done > 0 ? s.time * static_cast<double>(s.had) / static_cast<double>(s.done) : 0.0);
    most = std::max(most, times.back());
  }
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k].had > 0 && shares[k].done == 0) times[k] = 2.0 * most;  // a thread that came too late for any
  }
  return borders.note(times);
}

void TaskShares::be_patient(const Share& own, const Share& other, Patience patience) {
  BackOff back_off(patience);
  while (other.any_left() && Clock::now() < own.patient_until) back_off.wait();
}

bool TaskShares::begin(int threads) {
  OfTeam& team = teams_.try_emplace(threads, threads).first->second;
  const bool other = std::exchange(team_, &team) != &team;
  return (!other && threads > 1 && team.move_borders()) || other;
}

void TaskShares::deal(std::span<const std::int32_t> ends) {
  for (std::size_t k = 0; k < ends.size(); ++k) team_->give(k, ends[k]);
}

void TaskShares::deal(std::int64_t tasks) {
  for (std::size_t k = 0; k < team_->shares.size(); ++k) {
    team_->give(k, static_cast<std::int32_t>(std::lround(borders()[k] * static_cast<double>(tasks))));
  }
}

}  // namespace voussoir::solver
