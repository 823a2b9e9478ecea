// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace voussoir::solver {

/// Hands the tasks of one colour to the threads of a team. A thread begins with those among the elements that it updates, whose rows are in
/// its own cache, and goes on with what others have left. Which thread does a task changes no bit (decomposition.h).
class TaskShares {
 public:
  /// Before the team begins.
  /// \param places  by task, ascending: where its elements lie among all, from 0 to 1
  void deal(std::span<const double> places, int threads) {
    const auto n = static_cast<std::size_t>(threads);
    if (shares_.size() != n) shares_ = std::vector<Share>(n);
    std::int32_t first = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double end = static_cast<double>(k + 1) / threads;
      const auto last =
          static_cast<std::int32_t>(k + 1 == n ? places.size() : std::lower_bound(places.begin(), places.end(), end) - places.begin());
      shares_[k].next.store(first, std::memory_order_relaxed);
      shares_[k].last = first = last;
    }
  }

  /// Calls `work` with one task after the other, as long as any is left. \param thread  of the team
  template <class Work>
  void take(int thread, Work work) {
    const auto n = shares_.size();
    for (std::size_t k = 0; k < n; ++k) {
      Share& s = shares_[(static_cast<std::size_t>(thread) + k) % n];
      while (s.next.load(std::memory_order_relaxed) < s.last) {
        const std::int32_t task = s.next.fetch_add(1, std::memory_order_relaxed);
        if (task < s.last) work(task);
      }
    }
  }

 private:
  struct alignas(64) Share {  // a cache line each
    std::atomic<std::int32_t> next{0};
    std::int32_t last = 0;
  };
  std::vector<Share> shares_;  // by thread
};

}  // namespace voussoir::solver
