// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <omp.h>

#include <atomic>
#include <cstdint>
#include <span>
#include <thread>
#include <vector>

#include "solver/schedule/task_shares.h"
#include "solver/world/array.h"
#include "solver/world/world.h"

namespace voussoir::solver {

/// The order in which a team of threads does the tasks of all joints (decomposition.h). Two tasks that write to one element follow each
/// other by colour, whoever does them: so its sums have one order, and the same bits, with any number of threads. Nothing else waits; there
/// is no barrier between the colours.
///
/// Each thread has a queue, colour by colour, of tasks that lie together, so their rows stay in its own cache. A task waits for tasks of
/// lower colours only, which stand before it in any queue, or are at work: of those at work, the one of the lowest colour never waits.
///
/// In an out-of-cache model a thread would fetch its share from memory once for each colour. There (out_of_cache.h) only tasks at the
/// borders of shares, and those that they wait for, come first, colour by colour; then the others along the plan, each right after those
/// that it waits for. So again what a task waits for stands before it in its queue, or comes first in another.
class JointTasks {
 public:
  JointTasks() = default;
  explicit JointTasks(const World& w);

  /// Once a step, before a team of so many threads begins.
  void begin(int threads);

  /// Then, by every thread of the team: calls `work(task, next)` for each task of its own queue. Others may be at work still.
  /// `next`: elements that the task after it writes to, to be prefetched meanwhile; none if the model is not out of cache.
  template <class Work>
  void run_own(Work work) {
    if (omp_get_num_threads() != expected_) {  // the system gave fewer
#pragma omp single
      deal(given_ = omp_get_num_threads());
    }
    shares_.take_own(omp_get_thread_num(), [&](std::int32_t i) { run(i, work); });
  }

  /// The queues of a team whose shares end there (ShareBorders::ends).
  struct Plan {
    std::vector<std::size_t> owner;    // by task: whose queue it is in
    std::vector<std::uint8_t> inside;  // by task: 1 if it waits for no task of another thread, and none for it
    std::vector<std::int32_t> queues;  // one after the other
    std::vector<std::int32_t> ends;    // by thread: where its queue ends
  };
  [[nodiscard]] Plan plan(std::span<const double> borders) const;
  /// Those that a task waits for.
  [[nodiscard]] std::span<const std::int32_t> before(std::size_t task) const {
    return std::span(before_).subspan(static_cast<std::size_t>(first_before_[task]),
                                      static_cast<std::size_t>(first_before_[task + 1] - first_before_[task]));
  }

  /// From now on the time of each task is added up, without the time for which it waits.
  void time_tasks(bool on) { times_.assign(on ? flag_.size() : 0, 0.0); }
  [[nodiscard]] const std::vector<double>& task_times() const { return times_; }  // s; empty: off

  /// Then: for what is left of the queues of others, until none is.
  template <class Work>
  void help(Work work) {
    shares_.help(omp_get_thread_num(), omp_get_num_threads(), [&](std::int32_t i) { run(i, work); });
  }

 private:
  // Tasks take a hundredth of a thread's time each, and what they write is written again in the update: a little patience.
  static constexpr double kPatience = 0.1;

  void deal(int threads);
  void queue_up();
  void place_flags(const Plan& plan);

  /// The task at place i of all queues.
  template <class Work>
  void run(std::int32_t i, Work& work) {
    const auto task = static_cast<std::size_t>(queues_[static_cast<std::size_t>(i)]);
    for (const std::int32_t other : before(task)) wait_for(other);
    const double start = times_.empty() ? 0.0 : omp_get_wtime();
    work(task, elements_at(static_cast<std::size_t>(i) + 1));
    if (!times_.empty()) times_[task] += omp_get_wtime() - start;
    done_[flag_[task]].store(step_, std::memory_order_release);
  }

  /// Of the task at a place of all queues.
  [[nodiscard]] std::span<const std::int32_t> elements_at(std::size_t place) const {
    if (elements_.empty() || place >= queues_.size()) return {};
    return elements_[static_cast<std::size_t>(queues_[place])];
  }

  void wait_for(std::int32_t task) const {
    constexpr int kTurns = 200;  // some microseconds; then, with more threads than cores, its turn may have to come first
    const Flag& step = done_[flag_[static_cast<std::size_t>(task)]];
    for (int turn = 0; step.load(std::memory_order_acquire) != step_; ++turn) {
      if (turn >= kTurns) std::this_thread::yield();
      pause_briefly();
    }
  }

  using Flag = std::atomic<std::uint32_t>;
  std::uint32_t step_ = 0;                    // counts rounds; what is done bears its number
  int asked_ = 0, given_ = 0, expected_ = 0;  // threads, in the last step; and in this one
  TaskShares shares_{kPatience};
  std::vector<std::int32_t> queues_, ends_;          // one queue after the other; where each ends
  std::vector<Flag, CacheAligned<Flag>> done_;       // the last round in which a task was done
  std::vector<std::size_t> flag_;                    // by task: its place among these
  std::vector<std::int32_t> first_before_, before_;  // by task: those that it waits for
  std::vector<std::int32_t> colour_;                 // by task
  std::vector<std::int32_t> rank_;                   // by task of an out-of-cache model: along the plan, after those that it waits for
  std::vector<std::vector<std::int32_t>> elements_;  // by task of an out-of-cache model: those that it writes to, ascending
  std::vector<double> place_;                        // by task: where its elements lie among all, from 0 to 1
  std::vector<double> times_;                        // by task: s, so far; empty: not timed
};

}  // namespace voussoir::solver
