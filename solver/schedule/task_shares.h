// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "geometry/nth.h"
#include "solver/schedule/share_borders.h"
#include "solver/team/team.h"

namespace voussoir::solver {

/// Divides tasks among the threads of a team, step after step. A thread does its own share, and helps where others are late.
///
/// Tasks taken from another thread's share are fetched from that thread's cache, which has to fetch them back in the next step: this is
/// slower than waiting a little, and makes both threads late in the next step. Therefore shares follow the measured times (ShareBorders),
/// and a thread waits for some time before it helps.
class TaskShares {
 public:
  /// \param patience  waiting time before a thread helps, as a fraction of the time of its own share
  explicit TaskShares(double patience) : patience_(patience) {}

  /// Begins a step. To be called before the team begins. Teams of different sizes have separate borders. \return true if borders differ
  /// from those of the step before
  bool begin(int threads);

  /// Ends of the shares, see ShareBorders::ends.
  [[nodiscard]] std::span<const double> borders() const { return team_->borders.ends(); }

  /// Deals tasks by given ends: thread k gets the tasks [ends[k − 1], ends[k]). To be called after begin().
  void deal(std::span<const std::int32_t> ends);

  /// Deals `tasks` equal tasks by the borders.
  void deal(std::int64_t tasks);

  /// Calls `work` with one task of the thread's share after the other, while any is left. To be called by each thread of the team after
  /// deal().
  template <class Work>
  void take_own(int thread, Work work) {
    Share& own = nth(team_->shares, thread);
    own.begun.store(true, std::memory_order_relaxed);
    const Clock::time_point begin = Clock::now();
    own.done = take(own, work);
    const Clock::time_point end = Clock::now();
    own.time = std::chrono::duration<double>(end - begin).count();
    own.patient_until = end + std::chrono::duration_cast<Clock::duration>(patience_ * (end - begin));
  }

  /// Calls `work` with tasks left in the shares of threads that are late, or, without waiting, of threads that have not come. To be called
  /// after take_own(). When the first thread of a team returns from here, each task has been taken by a thread.
  template <class Work>
  void help(int thread, const Team& team, Work work) {
    std::vector<Share>& shares = team_->shares;
    const auto n = shares.size(), self = static_cast<std::size_t>(thread);
    for (std::size_t k = 1; k < n; ++k) {
      const std::size_t next = (self + k) % n;
      Share& other = shares[next];
      if (other.begun.load(std::memory_order_relaxed)) be_patient(shares[self], other, team.patience());
      take(other, work);
    }
  }

  /// Calls `work` with the next task of a thread's share, unless that task is after `last`. \return true if it was called
  template <class Work>
  bool take_one(std::size_t thread, std::int32_t last, Work work) {
    Share& s = team_->shares[thread];
    std::int32_t task = s.next.load(std::memory_order_relaxed);
    do {
      if (task > last) return false;
    } while (!s.next.compare_exchange_weak(task, task + 1, std::memory_order_relaxed));
    work(task);
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct alignas(128) Share {  // two cache lines each, since cores fetch them in pairs
    std::atomic<std::int32_t> next{0};
    std::atomic<bool> begun{false};  // true: its thread has come
    std::int32_t last = 0;
    std::int64_t had = 0, done = 0;  // number of tasks in the share; number done by its own thread
    double time = 0.0;               // s, of the latter
    Clock::time_point patient_until;
    [[nodiscard]] bool any_left() const { return next.load(std::memory_order_relaxed) < last; }
  };
  struct OfTeam {
    explicit OfTeam(int threads);
    void give(std::size_t thread, std::int32_t end);
    bool move_borders();
    std::vector<Share> shares;  // by thread
    ShareBorders borders;
  };

  static void be_patient(const Share& own, const Share& other, Patience patience);

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
  std::map<int, OfTeam> teams_;  // by number of threads
  OfTeam* team_ = nullptr;       // in this step
};

}  // namespace voussoir::solver
