// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/machine.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <thread>

#include "geometry/nth.h"
#include "kernels/lanes.h"
#include "solver/world/array.h"

namespace voussoir::solver {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTries = 10;
constexpr int kPeakRounds = 1'000'000;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Best of a few, s.
template <class Work>
double fastest(Work work) {
  double best = 1e300;
  for (int i = 0; i < kTries; ++i) {
    const Clock::time_point start = Clock::now();
    work();
    best = std::min(best, seconds_since(start));
  }
  return best;
}

constexpr int kChains = 10;  // enough to hide the latency of a multiply-add

void multiply_and_add(int rounds) {
  kernels::Lanes x[kChains];
  for (int c = 0; c < kChains; ++c) x[c] = kernels::lanes(1.0 + 1e-3 * c);
  const kernels::Lanes a = kernels::lanes(0.999'999), b = kernels::lanes(1e-7);
  for (int i = 0; i < rounds; ++i) {
    for (int c = 0; c < kChains; ++c) x[c] = x[c] * a + b;
  }
  kernels::Lanes sum{};
  for (int c = 0; c < kChains; ++c) sum += x[c];
  [[maybe_unused]] volatile double sink = sum[0];
}

/// Multiply-adds and integers side by side fill a core's slots for instructions, which its two halves share. Multiply-adds alone leave
/// most of them to the other half, and would not notice it.
void mix() {
  constexpr int kRounds = 20'000;
  const kernels::Lanes a = kernels::lanes(0.999'999), b = kernels::lanes(1e-7);
  kernels::Lanes x0 = a, x1 = b, x2 = a + b, x3 = a - b;
  std::uint64_t n0 = 1, n1 = 2, n2 = 3, n3 = 4;
  const auto step = [](std::uint64_t& n) {
    n ^= n << 7;
    asm("" : "+r"(n));  // in a register of its own, not of vectors
    n += n >> 9;
    asm("" : "+r"(n));
  };
  for (int i = 0; i < kRounds; ++i) {
    x0 = x0 * a + b, x1 = x1 * a + b, x2 = x2 * a + b, x3 = x3 * a + b;
    step(n0), step(n1), step(n2), step(n3);
  }
  // Or the compiler would leave out what nobody asks for.
  [[maybe_unused]] volatile double sink = (x0 + x1 + x2 + x3)[0] + static_cast<double>(n0 + n1 + n2 + n3);
}

}  // namespace

int processors() { return omp_get_num_procs(); }

double peak_flops(int threads) {
  Team team(threads);
  std::vector<double> rates(static_cast<std::size_t>(threads), 0.0);
  // Each thread by its own best, or one that the system takes from its core would make all slow.
  team.run_on_all([&](int thread) {
    nth(rates, thread) =
        2.0 * kernels::kWidth * kChains * static_cast<double>(kPeakRounds) / fastest([] { multiply_and_add(kPeakRounds); });
  });
  return std::accumulate(rates.begin(), rates.end(), 0.0);
}

std::vector<double> core_times(Team& team) {
  std::vector<double> times(static_cast<std::size_t>(team.size()), 0.0);
  team.run_on_all([&](int thread) {
    const Clock::time_point start = Clock::now();
    mix();
    nth(times, thread) = seconds_since(start);
  });
  return times;
}

double handover_now(Team& team) {
  const int n = team.size();
  if (n < 2 || n > processors()) return 0.0;
  constexpr int kRounds = 400;
  constexpr int kTurns = 1000;  // on a busy machine the next one may have to get its turn first
  alignas(128) std::atomic<int> next{0}, here{0};
  double seconds = 0.0;
  const auto wait_for = [](const std::atomic<int>& counter, int value) {
    for (int turn = 0; counter.load(std::memory_order_acquire) != value; ++turn) {
      if (turn > kTurns) std::this_thread::yield();
    }
  };
  team.run_on_all([&](int me) {
    here.fetch_add(1, std::memory_order_acq_rel);
    wait_for(here, n);
    const Clock::time_point start = Clock::now();
    for (int i = me; i < kRounds * n; i += n) {
      wait_for(next, i);
      next.store(i + 1, std::memory_order_release);
    }
    if (me == n - 1) seconds = seconds_since(start) / (kRounds * n);
  });
  return seconds;
}

double peak_bandwidth(int threads) {
  constexpr std::int64_t n = 8'000'000;
  Team team(threads);
  Array<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  const double seconds = fastest([&] {
    team.share_out(n, n / threads, [&](std::int64_t first, std::int64_t last) {
      for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) a[k] = b[k] + 3.0 * c[k];
    });
  });
  return 3.0 * sizeof(double) * static_cast<double>(n) / seconds;
}

}  // namespace voussoir::solver
