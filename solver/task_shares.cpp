// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/task_shares.h"

#include <algorithm>
#include <cmath>

namespace voussoir::solver {

namespace {

constexpr int kSteps = 64;           // between two looks at the borders: enough for what happens by chance to even out
constexpr double kGain = 0.5;        // of what was missing,
constexpr double kMost = 0.2;        // of a share, which may have been missing for a moment only
constexpr double kTolerated = 0.02;  // of a share
constexpr double kLeast = 0.25;      // of an equal share: one that has lost its core for a while must find back

}  // namespace

bool TaskShares::begin(int threads) {
  if (static_cast<std::size_t>(threads) != shares_.size()) {
    set_equal(threads);
    return true;
  }
  return threads > 1 && ++steps_ == kSteps && move_borders();
}

void TaskShares::set_equal(int threads) {
  shares_ = std::vector<Share>(static_cast<std::size_t>(threads));
  borders_.clear();
  for (int k = 1; k <= threads; ++k) borders_.push_back(static_cast<double>(k) / threads);
  steps_ = 0;
}

/// A share grows by what its thread has done beyond it.
bool TaskShares::move_borders() {
  steps_ = 0;
  bool moved = false;
  double first = 0.0, sum = 0.0;
  const double least = kLeast / static_cast<double>(shares_.size());
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    Share& s = shares_[k];
    const double excess = static_cast<double>(s.done) / static_cast<double>(std::max<std::int64_t>(s.had, 1)) - 1.0;
    moved |= std::abs(excess) > kTolerated;
    s.had = s.done = 0;
    const double length = borders_[k] - first;
    first = borders_[k];
    sum += std::max(least, length * (1.0 + kGain * std::clamp(excess, -kMost, kMost)));
    borders_[k] = sum;
  }
  for (double& b : borders_) b /= sum;
  return moved;
}

void TaskShares::deal(std::span<const std::int32_t> ends) {
  for (std::size_t k = 0; k < shares_.size(); ++k) give(k, ends[k]);
}

void TaskShares::deal(std::int64_t tasks) {
  for (std::size_t k = 0; k < shares_.size(); ++k)
    give(k, static_cast<std::int32_t>(std::lround(borders_[k] * static_cast<double>(tasks))));
}

void TaskShares::give(std::size_t thread, std::int32_t end) {
  Share& s = shares_[thread];
  const std::int32_t first = thread == 0 ? 0 : shares_[thread - 1].last;
  s.had += end - first;
  s.next.store(first, std::memory_order_relaxed);
  s.last = end;
}

}  // namespace voussoir::solver
