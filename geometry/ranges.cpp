// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/ranges.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace voussoir::geometry {

void for_ranges(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t, std::size_t)>& work) {
  const std::size_t ranges = range_count(count);
  std::atomic<std::size_t> next = 0;
  std::mutex lock;
  std::size_t failed = ranges;  // the lowest range that threw
  std::exception_ptr error;
  // Ranges are taken in ascending order, so all below one that throws have begun, and come to their end.
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
  {
    std::vector<std::jthread> helpers;
    const std::size_t wanted = std::min(ranges, static_cast<std::size_t>(std::max(threads, 1)));
    try {
      while (helpers.size() + 1 < wanted) helpers.emplace_back(take_ranges);
    } catch (const std::system_error&) {  // the system has no more threads: those that there are do it
    }
    take_ranges();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace voussoir::geometry
