// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/schedule/out_of_cache.h"

#include <numeric>

#include "geometry/nth.h"

namespace voussoir::solver {

namespace {

/// A chain of tasks that wait for each other has one of each colour at most.
void rank_after_those_before(TaskOrder order, std::int32_t task, std::int32_t& next, std::vector<std::int32_t>& rank) {
  const auto t = static_cast<std::size_t>(task);
  if (rank[t] >= 0) return;
  for (std::int32_t k = order.first[t]; k < order.first[t + 1]; ++k) {
    rank_after_those_before(order, nth(order.before, k), next, rank);
  }
  rank[t] = next++;
}

}  // namespace

std::vector<std::int32_t> ranks_along_plan(TaskOrder order, std::span<const double> place) {
  std::vector<std::int32_t> along(place.size()), rank(place.size(), -1);
  std::iota(along.begin(), along.end(), 0);
  std::ranges::stable_sort(along, {}, [&](std::int32_t t) { return nth(place, t); });
  std::int32_t next = 0;
  for (const std::int32_t task : along) rank_after_those_before(order, task, next, rank);
  return rank;
}

std::vector<std::uint8_t> tasks_before_borders(TaskOrder order, std::span<const std::uint8_t> inside) {
  std::vector<std::uint8_t> first(inside.size());
  for (std::size_t task = inside.size(); task-- > 0;) {  // from the highest colour down: what a task waits for is of a lower one
    if (inside[task] == 0) first[task] = 1;
    if (first[task] == 0) continue;
    for (std::int32_t k = order.first[task]; k < order.first[task + 1]; ++k) nth(first, nth(order.before, k)) = 1;
  }
  return first;
}

}  // namespace voussoir::solver
