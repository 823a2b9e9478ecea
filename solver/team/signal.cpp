// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/team/signal.h"

#include <chrono>
#include <thread>

namespace voussoir::solver {

bool BackOff::yield() {
  if (left_.yields <= 0) return false;
  --left_.yields;
  std::this_thread::yield();
  return true;
}

void BackOff::wait() {
  constexpr std::chrono::microseconds kNap{50};
  if (!spin_or_yield()) std::this_thread::sleep_for(kNap);
}

// One that is about to sleep counts itself before it looks at the counter for the last time, and one that raises looks for sleepers after
// it has raised it. All four are in one order (seq_cst), so at least one of the two sees the other.
void Signal::raise() {
  value_.fetch_add(1, std::memory_order_seq_cst);
  if (asleep_.load(std::memory_order_seq_cst) > 0) value_.notify_all();
}

void Signal::sleep_while(std::uint32_t before) {
  asleep_.fetch_add(1, std::memory_order_seq_cst);
  value_.wait(before, std::memory_order_seq_cst);
  asleep_.fetch_sub(1, std::memory_order_seq_cst);
}

}  // namespace voussoir::solver
