// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/nth.h"
#include "solver/schedule/task_shares.h"
#include "solver/world/array.h"
#include "solver/world/world.h"

namespace voussoir::solver {

/// The order in which a team of threads does the tasks of all joints (colouring.h). Two tasks that write to one element are done in the
/// order of their colours, whichever threads do them: the sums of an element thus have one order, and the same bits, with any number of
/// threads. There is no other waiting, and no barrier between colours.
///
/// Each thread has a queue, colour by colour, of neighbouring tasks, so that their rows stay in its own cache. A task waits for tasks of
/// lower colours only, which precede it in any queue, or are active: of the active tasks, the one of the lowest colour never waits.
///
/// In an out-of-cache model a thread would fetch its share from memory once for each colour. There (out_of_cache.h) tasks at the borders of
/// shares, and all that they wait for, come first, colour by colour; then the others along the plan, each immediately after the tasks that
/// it waits for. Again, all tasks that a task waits for precede it in its queue, or come first in another.
class JointTasks {
 public:
  JointTasks() = default;
  explicit JointTasks(const World& w);

  /// Begins a step. To be called before the team is given its job.
  void begin(Team& team);

  /// Calls `work(task, next)` for each task of the thread's own queue. To be called by each thread of the team that comes, after begin().
  /// Others may still be working when it returns.
  /// `next`: elements that the following task writes to, to be prefetched meanwhile; empty if the model is not out of cache.
  template <class Work>
  void run_own(int thread, Work work) {
    shares_.take_own(thread, [&](std::int32_t i) { run(i, work); });
  }

  /// The queues of a team for given ends of shares (ShareBorders::ends).
  struct Plan {
    std::vector<std::size_t> owner;    // by task: owner of its queue
    std::vector<std::uint8_t> inside;  // by task: 1 if it neither waits for a task of another thread nor is waited for by one
    std::vector<std::int32_t> queues;  // one queue after the other
    std::vector<std::int32_t> ends;    // by thread: end of its queue
  };
  [[nodiscard]] Plan plan(std::span<const double> borders) const;
  /// Tasks that a task waits for.
  [[nodiscard]] std::span<const std::int32_t> before(std::size_t task) const {
    return std::span(before_).subspan(static_cast<std::size_t>(first_before_[task]),
                                      static_cast<std::size_t>(first_before_[task + 1] - first_before_[task]));
  }

  /// Switches the timing of tasks on or off. Times accumulate, without waiting.
  void time_tasks(bool on) { times_.assign(on ? flag_.size() : 0, 0.0); }
  [[nodiscard]] const std::vector<double>& task_times() const { return times_; }  // s; empty: off

  /// Does remaining tasks of other queues, until there are none. To be called after run_own().
  template <class Work>
  void help(int thread, Work work) {
    shares_.help(thread, *team_, [&](std::int32_t i) { run(i, work); });
  }

 private:
  // Tasks take a hundredth of a thread's time each, and the rows that they write are written again in the update: little patience.
  static constexpr double kPatience = 0.1;

  void queue_up();
  void place_flags(const Plan& plan);

  /// Does the task at place i of all queues.
  template <class Work>
  void run(std::int32_t i, Work& work) {
    const auto task = static_cast<std::size_t>(nth(queues_, i));
    for (const std::int32_t other : before(task)) wait_for(other, work);
    const Clock::time_point start = times_.empty() ? Clock::time_point{} : Clock::now();
    work(task, elements_at(static_cast<std::size_t>(i) + 1));
    if (!times_.empty()) times_[task] += std::chrono::duration<double>(Clock::now() - start).count();
    done_[flag_[task]].store(step_, std::memory_order_release);
  }

  /// Elements of the task at a place of all queues.
  [[nodiscard]] std::span<const std::int32_t> elements_at(std::size_t place) const {
    if (elements_.empty() || place >= queues_.size()) return {};
    return nth(elements_, queues_[place]);
  }

  /// Waits until a task is done. If nobody has begun it after a while, its thread may not have come: then the tasks up to it are done here.
  /// These wait only for tasks of lower colours, so the recursion ends.
  template <class Work>
  void wait_for(std::int32_t task, Work& work) {
    const auto t = static_cast<std::size_t>(task);
    const Flag& step = done_[flag_[t]];
    if (step.load(std::memory_order_acquire) == step_) return;
    BackOff back_off(team_->patience());
    for (int turn = 0; step.load(std::memory_order_acquire) != step_; ++turn) {
      if (turn < kTurns) {
        pause_briefly();
      } else if (team_->is_broken()) {
        throw TeamBroken{};
      } else if (!shares_.take_one(owner_[t], queue_place_[t], [&](std::int32_t i) { run(i, work); })) {
        back_off.wait();
      }
    }
  }

  using Clock = std::chrono::steady_clock;
  static constexpr int kTurns = 500;  // some ten microseconds
  using Flag = std::atomic<std::uint32_t>;
  std::uint32_t step_ = 0;  // number of the round; finished tasks have it as mark
  Team* team_ = nullptr;    // of this step
  TaskShares shares_{kPatience};
  std::vector<std::int32_t> queues_, ends_;          // one queue after the other; end of each
  std::vector<std::size_t> owner_;                   // by task: owner of its queue
  std::vector<std::int32_t> queue_place_;            // by task: its position in `queues_`
  std::vector<Flag, CacheAligned<Flag>> done_;       // last round in which a task was done
  std::vector<std::size_t> flag_;                    // by task: its index in done_
  std::vector<std::int32_t> first_before_, before_;  // by task: tasks that it waits for
  std::vector<std::int32_t> colour_;                 // by task
  std::vector<std::int32_t> rank_;  // by task of an out-of-cache model: rank along the plan, after the tasks that it waits for
  std::vector<std::vector<std::int32_t>> elements_;  // by task of an out-of-cache model: elements that it writes to, ascending
  std::vector<double> place_;                        // by task: position of its elements among all, from 0 to 1
  std::vector<double> times_;                        // by task: accumulated time [s]; empty: not timed
};

}  // namespace voussoir::solver
