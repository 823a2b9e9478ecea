// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/team/team.h"

#include <omp.h>

#include <new>
#include <system_error>
#include <utility>

#include "geometry/nth.h"
#include "solver/team/place.h"

namespace voussoir::solver {

namespace {

// The door of a job, one number: how many hired threads are in it, whether it is shut, and above these the number of the job.
constexpr std::uint64_t kOne = 1, kShut = std::uint64_t{1} << 16, kNumber = kShut << 1;

std::uint64_t inside(std::uint64_t door) { return door & (kShut - 1); }
bool is_shut(std::uint64_t door) { return (door & kShut) != 0; }
std::uint64_t number_of(std::uint64_t door) { return door / kNumber; }

}  // namespace

Team::~Team() {
  ends_.store(true, std::memory_order_seq_cst);
  given_.raise();
  wanted_.raise();
  for (std::thread& t : hired_) t.join();
}

void Team::set_size(int threads) {
  constexpr int kMost = 1 << 15;  // far below what the door can count
  size_ = std::clamp(threads, 1, kMost);
}

Patience Team::patience() const {
  static const int processors = omp_get_num_procs();
  return called_for_.load(std::memory_order_relaxed) <= processors ? Patience{} : kNoCoreToSpare;
}

void Team::run_job(Job job, bool all) {
  if (size_ == 1) return job.call(job.work, 0);
  hire(size_);
  job_ = job, all_ = all;
  const int others = std::min(size_ - 1, static_cast<int>(hired_.size()));
  open_door(others + 1);
  call(0);
  shut_door(others);
  if (std::exception_ptr error = std::exchange(error_, nullptr)) {
    broken_.store(false, std::memory_order_relaxed);
    std::rethrow_exception(error);
  }
}

/// Threads are started here, in place of all at once: many teams never need them. If the system gives fewer, the others do their work.
void Team::hire(int threads) {
  try {
    while (static_cast<int>(hired_.size()) + 1 < threads) {
      const int thread = static_cast<int>(hired_.size()) + 1;
      hired_.emplace_back([this, thread] { serve(thread); });
    }
  } catch (const std::system_error&) {
    return;
  } catch (const std::bad_alloc&) {
    return;
  }
}

void Team::open_door(int threads) {
  const int before = called_for_.load(std::memory_order_relaxed);
  if (threads != before) called_for_.store(threads, std::memory_order_seq_cst);
  came_.store(0, std::memory_order_relaxed);
  door_.store(++jobs_ * kNumber, std::memory_order_seq_cst);
  given_.raise();
  if (threads > before) wanted_.raise();
}

void Team::shut_door(int others) {
  if (all_) left_.wait_until([&] { return came_.load(std::memory_order_seq_cst) == others; }, patience());
  if (inside(door_.fetch_or(kShut, std::memory_order_seq_cst)) == 0) return;
  left_.wait_until([&] { return inside(door_.load(std::memory_order_seq_cst)) == 0; }, patience());
}

void Team::call(int thread) noexcept {
  try {
    job_.call(job_.work, thread);
  } catch (const TeamBroken&) {
    // Another has thrown what matters.
  } catch (...) {
    if (!broken_.exchange(true, std::memory_order_relaxed)) error_ = std::current_exception();
  }
}

/// Whether there is a job that is another than this one, done or not.
bool Team::has_news(std::uint64_t last_job) const {
  return number_of(door_.load(std::memory_order_seq_cst)) != last_job || ends_.load(std::memory_order_seq_cst);
}

/// \param last_job  the last that this thread has been in, or come too late for
bool Team::enter(std::uint64_t& last_job) {
  std::uint64_t door = door_.load(std::memory_order_seq_cst);
  do {
    last_job = number_of(door);
    if (is_shut(door)) return false;
  } while (!door_.compare_exchange_weak(door, door + kOne, std::memory_order_seq_cst));
  return true;
}

void Team::leave() {
  const std::uint64_t door = door_.fetch_sub(kOne, std::memory_order_seq_cst);
  if (is_shut(door) && inside(door) == 1) left_.raise();
}

/// What a hired thread does until the team ends.
void Team::serve(int thread) {
  place_thread(thread);
  const auto is_called = [&] { return thread < called_for_.load(std::memory_order_seq_cst) || ends_.load(std::memory_order_seq_cst); };
  std::uint64_t last_job = 0;
  for (;;) {
    given_.wait_until([&] { return has_news(last_job); }, patience());
    // Those that are not called for sleep elsewhere, or each job would wake them.
    if (!is_called()) wanted_.wait_until(is_called, kNoCoreToSpare);
    if (ends_.load(std::memory_order_seq_cst)) return;
    if (!has_news(last_job) || !enter(last_job)) continue;
    // A job that has begun since may call for fewer.
    if (thread < called_for_.load(std::memory_order_relaxed)) {
      if (all_) came_.fetch_add(1, std::memory_order_seq_cst), left_.raise();
      call(thread);
    }
    leave();
  }
}

void Team::deal(std::int64_t count) {
  if (parts_.size() != static_cast<std::size_t>(size_)) parts_ = std::vector<Part>(static_cast<std::size_t>(size_));
  for (std::int64_t k = 0; k < size_; ++k) {
    Part& p = nth(parts_, k);
    p.next.store(count * k / size_, std::memory_order_relaxed);
    p.last = count * (k + 1) / size_;
  }
}

}  // namespace voussoir::solver
