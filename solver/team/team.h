// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <thread>
#include <type_traits>
#include <vector>

#include "geometry/nth.h"
#include "solver/team/signal.h"

/// The threads that compute a step together. README.md beside this file says why they are organised like this.
namespace voussoir::solver {

/// What ends a wait for a thread of the team that has thrown. Team::run does not pass it on.
struct TeamBroken {};

/// Numbers from 0 on, each of which goes to one of the threads that ask.
class Tickets {
 public:
  /// Before a job.
  void begin(std::int64_t count, std::int64_t at_a_time) {
    next_.store(0, std::memory_order_relaxed);
    count_ = count, at_a_time_ = at_a_time;
  }
  /// In it: calls `work(first, last)` as long as any are left.
  template <class Work>
  void take(Work&& work) {
    while (next_.load(std::memory_order_relaxed) < count_) {
      const std::int64_t first = next_.fetch_add(at_a_time_, std::memory_order_relaxed);
      if (first < count_) work(first, std::min(first + at_a_time_, count_));
    }
  }

 private:
  alignas(128) std::atomic<std::int64_t> next_{0};
  std::int64_t count_ = 0, at_a_time_ = 1;
};

/// Some threads; the first is the one that calls. The others are started when they are first needed, and sleep between jobs that lie far
/// apart. One thread gives jobs to a team, one at a time; a job gives none.
///
/// Whatever that thread did before it gave a job is seen by all who take part in it, and what these did is seen by it afterwards. Who
/// takes part is chance: nothing that is computed may depend on it.
class Team {
 public:
  explicit Team(int threads = 1) { set_size(threads); }
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Threads of the next jobs, at least 1. It may change between any two jobs.
  void set_size(int threads);
  [[nodiscard]] int size() const { return size_; }

  /// From now on no job leaves out who comes late: for tests, which want all threads at work however little there is to do.
  void wait_for_all(bool on) { all_must_come_ = on; }

  /// Calls `work(thread)` on threads 0 to size() - 1, thread 0 being the one that calls, and returns once all calls have. Threads that
  /// have not come when thread 0 has ended its call are left out. So any part of the calls must do all there is to do: each thread its own
  /// share, then what others have left of theirs (TaskShares, share_out). \throw what one of the calls has thrown
  template <class Work>
  void run(Work&& work) {
    run_job(job_of(work), all_must_come_);
  }

  /// The same, but leaves out none: each thread makes its call once the system gives it a core.
  template <class Work>
  void run_on_all(Work&& work) {
    run_job(job_of(work), true);
  }

  /// Calls `work(first, last)`, or `work(first, last, thread)`, for ranges of at most so many, which together are [0, count). A thread
  /// begins with its own part of them, in each job the same part, and goes on with what others have left.
  template <class Work>
  void share_out(std::int64_t count, std::int64_t at_a_time, Work&& work) {
    if (count <= 0) return;
    if (size_ == 1 || count <= at_a_time) return call_for(work, 0, count, 0);
    deal(count);
    run([&](int thread) {
      for (int k = 0; k < size_; ++k) {
        Part& part = nth(parts_, (thread + k) % size_);
        while (part.next.load(std::memory_order_relaxed) < part.last) {
          const std::int64_t first = part.next.fetch_add(at_a_time, std::memory_order_relaxed);
          if (first < part.last) call_for(work, first, std::min(first + at_a_time, part.last), thread);
        }
      }
    });
  }

  /// Whether a call of the job at hand has thrown: nobody may wait any more for what it was to do.
  [[nodiscard]] bool is_broken() const { return broken_.load(std::memory_order_relaxed); }
  /// For waits within a job.
  [[nodiscard]] Patience patience() const;

 private:
  struct Job {
    void (*call)(void* work, int thread) = nullptr;
    void* work = nullptr;
  };
  template <class Work>
  static Job job_of(Work& work) {
    return {[](void* w, int thread) { (*static_cast<Work*>(w))(thread); }, const_cast<std::remove_const_t<Work>*>(&work)};
  }
  template <class Work>
  static void call_for(Work& work, std::int64_t first, std::int64_t last, int thread) {
    if constexpr (std::is_invocable_v<Work&, std::int64_t, std::int64_t, int>) {
      work(first, last, thread);
    } else {
      work(first, last);
    }
  }
  struct alignas(128) Part {  // two cache lines: cores fetch them in pairs
    std::atomic<std::int64_t> next{0};
    std::int64_t last = 0;
  };

  void run_job(Job job, bool all);
  void open_door(int threads);
  void shut_door(int others);
  void call(int thread) noexcept;
  void serve(int thread);
  [[nodiscard]] bool has_news(std::uint64_t last_job) const;
  bool enter(std::uint64_t& last_job);
  void leave();
  void hire(int threads);
  void deal(std::int64_t count);

  // Of the thread that gives jobs; who is in a job may read them.
  int size_ = 1;
  bool all_must_come_ = false;
  std::uint64_t jobs_ = 0;  // so far
  std::vector<Part> parts_;
  std::vector<std::thread> hired_;  // threads 1, 2, ...

  // What threads look at while they spin, and the job behind it, on lines that nothing else is on.
  alignas(128) std::atomic<std::uint64_t> door_{0};  // number of the job, kShut, how many hired threads are in it
  std::atomic<int> called_for_{1};                   // threads, by the last job
  std::atomic<bool> ends_{false};                    // hired threads are to end
  bool all_ = false;                                 // must come to this job
  Job job_;
  std::atomic<int> came_{0};  // hired threads, to a job to which all must come

  alignas(128) std::atomic<bool> broken_{false};
  std::exception_ptr error_;    // of the call that broke the job
  alignas(128) Signal given_;   // raised with each job
  alignas(128) Signal left_;    // raised by the last to leave a job whose door is shut, and by each that comes where all must
  alignas(128) Signal wanted_;  // raised when more threads are called for than by the job before
};

}  // namespace voussoir::solver
