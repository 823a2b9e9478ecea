// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/schedule/share_borders.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace voussoir::solver {

namespace {

constexpr int kSteps = 64;           // between two looks at the borders: enough for what happens by chance to even out
constexpr double kGain = 0.5;        // of what was too much,
constexpr double kMost = 0.2;        // of the mean time: in a step in which a thread lost its core it took any time
constexpr double kTolerated = 0.02;  // of the mean time
constexpr double kLeast = 0.25;      // of an equal share: one that has lost its core for a while must find back

}  // namespace

ShareBorders::ShareBorders(int threads) : excess_(static_cast<std::size_t>(threads), 0.0) {
  for (int k = 1; k <= threads; ++k) ends_.push_back(static_cast<double>(k) / threads);
}

bool ShareBorders::note(std::span<const double> times) {
  const double mean = std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  for (std::size_t k = 0; k < times.size() && mean > 0.0; ++k) excess_[k] += std::clamp(times[k] / mean - 1.0, -kMost, kMost);
  return ++steps_ >= kSteps && move();
}

/// A share shrinks by what it takes too long. What is tolerated leaves all borders where they are, or they would creep.
bool ShareBorders::move() {
  bool move = false;
  double first = 0.0, sum = 0.0;
  const double least = kLeast / static_cast<double>(ends_.size());
  std::vector<double> moved;
  for (std::size_t k = 0; k < ends_.size(); ++k) {
    const double excess = excess_[k] / steps_, length = ends_[k] - first;
    move |= std::abs(excess) > kTolerated;
    first = ends_[k];
    sum += std::max(least, length * (1.0 - kGain * excess));
    moved.push_back(sum);
  }
  steps_ = 0;
  std::ranges::fill(excess_, 0.0);
  if (!move) return false;
  for (double& end : moved) end /= sum;
  ends_ = std::move(moved);
  return true;
}

}  // namespace voussoir::solver
