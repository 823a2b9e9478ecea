// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

/// How threads wait for each other: they spin, then yield, then sleep.
namespace voussoir::solver {

/// Leaves a core to its other thread for a moment, where the processor can.
inline void pause_briefly() noexcept {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// How long a thread that waits keeps its core. \invariant both are at least 0
struct Patience {
  int spins = 2000;  // some 20 to 90 microseconds, a step of a small model: waking takes as long
  int yields = 50;   // calls of the system, in which others may have the core
};
/// With more threads than cores the one that is waited for may need this one's core.
inline constexpr Patience kNoCoreToSpare{20, 5};

/// One wait of one thread.
class BackOff {
 public:
  explicit BackOff(Patience patience = {}) : left_(patience) {}
  /// Waits a little, without sleeping. \return false, at once, if it is time to sleep
  bool spin_or_yield() {
    if (left_.spins <= 0) return yield();
    --left_.spins;
    pause_briefly();
    return true;
  }
  /// Waits a little, however long it has been: for what nobody announces. Sleeps for a tenth of a millisecond at most.
  void wait();

 private:
  bool yield();
  Patience left_;
};

/// A counter that threads wait on. What a thread did before it raised a signal is seen by those that have seen the counter grow.
class Signal {
 public:
  /// Wakes who waits. It costs no call of the system where nobody sleeps.
  void raise();

  /// Returns once `done()` holds. Whoever makes it hold raises the signal afterwards.
  template <class Done>
  void wait_until(Done done, Patience patience) {
    for (BackOff back_off(patience); back_off.spin_or_yield();) {
      if (done()) return;  // without a look at the counter: whoever raises it has its line of memory to itself
    }
    for (;;) {
      const std::uint32_t before = value_.load(std::memory_order_seq_cst);
      if (done()) return;
      sleep_while(before);
    }
  }

 private:
  void sleep_while(std::uint32_t before);

  std::atomic<std::uint32_t> value_{0};
  std::atomic<std::uint32_t> asleep_{0};  // threads that sleep, or are about to
};

}  // namespace voussoir::solver
