// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/task_shares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voussoir::solver {

namespace {

constexpr int kSteps = 64;           // between two looks at the borders: enough for what happens by chance to even out
constexpr double kGain = 0.5;        // of what was missing,
constexpr double kMost = 0.2;        // of a share, which may have been missing for a moment only
constexpr double kTolerated = 0.02;  // of a share
constexpr double kLeast = 0.25;      // of an equal share: one that has lost its core for a while must find back

}  // namespace

TaskShares::Team::Team(int threads) : shares(static_cast<std::size_t>(threads)) {
  for (int k = 1; k <= threads; ++k) borders.push_back(static_cast<double>(k) / threads);
}

void TaskShares::Team::give(std::size_t thread, std::int32_t end) {
  Share& s = shares[thread];
  const std::int32_t first = thread == 0 ? 0 : shares[thread - 1].last;
  s.had += end - first;
  s.next.store(first, std::memory_order_relaxed);
  s.last = end;
}

/// A share grows by what its thread has done beyond it. What is tolerated leaves all borders where they are, or they would creep: tasks are
/// not divided, so some excess always stays.
bool TaskShares::Team::move_borders() {
  steps = 0;
  bool move = false;
  double first = 0.0, sum = 0.0;
  const double least = kLeast / static_cast<double>(shares.size());
  std::vector<double> moved;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    Share& s = shares[k];
    const double excess = static_cast<double>(s.done) / static_cast<double>(std::max<std::int64_t>(s.had, 1)) - 1.0;
    move |= std::abs(excess) > kTolerated;
    s.had = s.done = 0;
    const double length = borders[k] - first;
    first = borders[k];
    sum += std::max(least, length * (1.0 + kGain * std::clamp(excess, -kMost, kMost)));
    moved.push_back(sum);
  }
  if (!move) return false;
  for (double& b : moved) b /= sum;
  borders = std::move(moved);
  return true;
}

bool TaskShares::begin(int threads) {
  Team& team = teams_.try_emplace(threads, threads).first->second;
  const bool other = std::exchange(team_, &team) != &team;
  const bool moved = threads > 1 && ++team.steps >= kSteps && team.move_borders();
  return other || moved;
}

void TaskShares::deal(std::span<const std::int32_t> ends) {
  for (std::size_t k = 0; k < ends.size(); ++k) team_->give(k, ends[k]);
}

void TaskShares::deal(std::int64_t tasks) {
  for (std::size_t k = 0; k < team_->shares.size(); ++k) {
    team_->give(k, static_cast<std::int32_t>(std::lround(team_->borders[k] * static_cast<double>(tasks))));
  }
}

}  // namespace voussoir::solver
