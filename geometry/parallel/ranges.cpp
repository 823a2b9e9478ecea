// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/parallel/ranges.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace voussoir::geometry {
namespace {

/// Calls `work` on so many threads, this one among them, of which the system may give fewer than are asked for.
template <class Work>
void on_threads(std::size_t threads, const Work& work) {
  std::vector<std::thread> hired;
  hired.reserve(threads - 1);
  try {
    while (hired.size() + 1 < threads) hired.emplace_back(work);
  } catch (const std::system_error&) {  // those that there are do all of it
  } catch (const std::bad_alloc&) {
  }
  work();
  for (std::thread& t : hired) t.join();
}

}  // namespace

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
  const std::size_t team = std::min(ranges, static_cast<std::size_t>(std::max(threads, 1)));
  on_threads(std::max<std::size_t>(team, 1), take_ranges);
  if (error) std::rethrow_exception(error);
}

}  // namespace voussoir::geometry
