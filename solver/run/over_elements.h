// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/nth.h"
#include "kernels/integrate.h"
#include "kernels/prefetch.h"
#include "solver/schedule/task_shares.h"
#include "solver/world/world.h"

/// One pass of a team over all elements, as in the update.
namespace voussoir::solver {

/// What one thread has found, on lines of its own.
struct alignas(128) Most {
  double value = 0.0;
};

/// Calls `work(first, last)` for all elements, batch by batch: the rows of one stay near. \return the most of what it returns
template <class Work>
double over_elements(World& w, TaskShares& shares, std::vector<Most>& room, Work work) {
  constexpr std::int64_t kElementsAtATime = 2 * kernels::kBatch;  // that a thread takes
  const std::int64_t rows = w.elements.rows;
  shares.begin(w.team.size());
  shares.deal((rows + kElementsAtATime - 1) / kElementsAtATime);
  room.assign(static_cast<std::size_t>(w.team.size()), {});
  w.team.run([&](int thread) {
    double most = 0.0;
    const auto do_run = [&](std::int32_t run) {
      const std::int64_t last = std::min((run + 1) * kElementsAtATime, rows);
      for (std::int64_t i = run * kElementsAtATime; i < last; i += kernels::kBatch) most = std::max(most, work(i, i + kernels::kBatch));
    };
    shares.take_own(thread, do_run);
    shares.help(thread, w.team, do_run);
    kernels::finish_stores();  // of poses, where they are streaming
    nth(room, thread).value = most;
  });
  double most = 0.0;
  for (const Most& m : room) most = std::max(most, m.value);
  return most;
}

}  // namespace voussoir::solver
