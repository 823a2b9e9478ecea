// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/parallel/ranges.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

namespace voussoir::geometry {

void for_ranges(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t, std::size_t)>& work) {
  const std::size_t ranges = range_count(count);
  std::atomic<std::size_t> next = 0;
  std::mutex lock;
  std::size_t failed = ranges;  // the lowest range that threw
  std::exception_ptr error;
  // Ranges are taken in ascending order, so all ranges below one that throws have begun, and are completed.
  const auto take_ranges = [&] {
    for (std::size_t r = next++; r < ranges; r = next++) {
      try {
        work(r, r * kBlocksAtATime, std::min(count, (r + 1) * kBlocksAtATime));
      } catch (...) {
        next = ranges;
        const std::scoped_lock hold(lock);
        if (r < failed) failed = r, error = std::current_exception();
      }
    }
  };
  const int team = static_cast<int>(std::min<std::size_t>(ranges, static_cast<std::size_t>(std::max(threads, 1))));
  if (team < 2) {
    take_ranges();
  } else {
#pragma omp parallel num_threads(team)
    take_ranges();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace voussoir::geometry
