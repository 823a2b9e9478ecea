// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "solver/schedule/share_borders.h"

namespace voussoir::solver {

/// Leaves a core to its other thread for a moment, where the processor can.
inline void pause_briefly() noexcept {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Shares tasks out among the threads of a team, step after step. A thread does its own share, and helps where others are late.
///
/// What a thread takes from another's share it fetches from the other's cache, and the other has to fetch it back in the next step: that is
/// slower than to wait a little, and makes both late in the next step. So shares follow what they take (ShareBorders), and a thread has
/// some patience before it helps.
class TaskShares {
 public:
  /// \param patience  of the time that its own share took a thread: so much more it gives the others for theirs
  explicit TaskShares(double patience) : patience_(patience) {}

  /// Before the team begins. Teams of different sizes have borders of their own. \return true if these are others than in the step before
  bool begin(int threads);

  /// See ShareBorders.
  [[nodiscard]] std::span<const double> borders() const { return team_->borders.ends(); }

  /// Then. Thread k has the tasks [ends[k − 1], ends[k]).
  void deal(std::span<const std::int32_t> ends);

  /// So many tasks, all alike.
  void deal(std::int64_t tasks);

  /// Then, by each thread of the team: calls `work` with one task of its share after the other, as long as any is left.
  template <class Work>
  void take_own(int thread, Work work) {
    Share& own = team_->shares[static_cast<std::size_t>(thread)];
    const Clock::time_point begin = Clock::now();
    own.done = take(own, work);
    const Clock::time_point end = Clock::now();
    own.time = std::chrono::duration<double>(end - begin).count();
    own.patient_until = end + std::chrono::duration_cast<Clock::duration>(patience_ * (end - begin));
  }

  /// Then: the same with what others have left, once they have had time enough. \param team  threads that take part: the system may have
  /// given fewer than there are shares
  template <class Work>
  void help(int thread, int team, Work work) {
    std::vector<Share>& shares = team_->shares;
    const auto n = shares.size(), self = static_cast<std::size_t>(thread);
    for (std::size_t k = 1; k < n; ++k) {
      const std::size_t next = (self + k) % n;
      Share& other = shares[next];
      if (next < static_cast<std::size_t>(team)) be_patient(shares[self], other);
      take(other, work);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct alignas(128) Share {  // two cache lines each: cores fetch them in pairs
    std::atomic<std::int32_t> next{0};
    std::int32_t last = 0;
    std::int64_t had = 0, done = 0;  // tasks in it; of these by its own thread
    double time = 0.0;               // s, that these took
    Clock::time_point patient_until;
    [[nodiscard]] bool any_left() const { return next.load(std::memory_order_relaxed) < last; }
  };
  struct Team {
    explicit Team(int threads);
    void give(std::size_t thread, std::int32_t end);
    bool move_borders();
    std::vector<Share> shares;  // by thread
    ShareBorders borders;
  };

  static void be_patient(const Share& own, const Share& other);

  template <class Work>
  static std::int64_t take(Share& s, Work& work) {
    std::int64_t done = 0;
    while (s.any_left()) {
      const std::int32_t task = s.next.fetch_add(1, std::memory_order_relaxed);
      if (task >= s.last) break;
      work(task);
      ++done;
    }
    return done;
  }

  double patience_;
  std::map<int, Team> teams_;  // by number of threads
  Team* team_ = nullptr;       // in this step
};

}  // namespace voussoir::solver
