// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace voussoir::solver {

/// Shares tasks out among the threads of a team, step after step. A thread begins with its own share, and goes on with what others have
/// left.
///
/// What a thread takes from another's share it fetches from the other's cache, and the other has to fetch it back in the next step: then
/// both are slower, and the more is taken. So the shares follow what threads get done: after a while none has to help another, though one
/// of them has half a core only, or the harder half of the work.
class TaskShares {
 public:
  /// Before the team begins. Teams of different sizes have borders of their own. \return true if these are others than in the step before
  bool begin(int threads);

  /// By thread: where its share ends, from 0 (the first task's begin) to 1 (the last one's end).
  [[nodiscard]] std::span<const double> borders() const { return team_->borders; }

  /// Then. Thread k has the tasks [ends[k − 1], ends[k]).
  void deal(std::span<const std::int32_t> ends);

  /// So many tasks, all alike.
  void deal(std::int64_t tasks);

  /// Calls `work` with one task after the other, as long as any is left. \param thread  of the team
  template <class Work>
  void take(int thread, Work work) {
    std::vector<Share>& shares = team_->shares;
    const auto n = shares.size();
    std::int64_t done = 0;
    for (std::size_t k = 0; k < n; ++k) {
      Share& s = shares[(static_cast<std::size_t>(thread) + k) % n];
      while (s.next.load(std::memory_order_relaxed) < s.last) {
        const std::int32_t task = s.next.fetch_add(1, std::memory_order_relaxed);
        if (task >= s.last) break;
        work(task);
        ++done;
      }
    }
    shares[static_cast<std::size_t>(thread)].done += done;
  }

 private:
  struct alignas(64) Share {  // a cache line each
    std::atomic<std::int32_t> next{0};
    std::int32_t last = 0;
    std::int64_t had = 0, done = 0;  // tasks in this share, and by this thread, since the borders were looked at last
  };
  struct Team {
    explicit Team(int threads);
    void give(std::size_t thread, std::int32_t end);
    bool move_borders();
    std::vector<Share> shares;    // by thread
    std::vector<double> borders;  // by thread
    int steps = 0;                // since the borders were looked at last
  };
  std::map<int, Team> teams_;  // by number of threads
  Team* team_ = nullptr;       // in this step
};

}  // namespace voussoir::solver
