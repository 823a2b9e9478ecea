// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/machine.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>

#include "kernels/lanes.h"
#include "solver/world/array.h"

namespace voussoir::solver {

namespace {

constexpr int kTries = 10;

/// Best of a few, s.
template <class Work>
double fastest(Work work) {
  double best = 1e300;
  for (int i = 0; i < kTries; ++i) {
    const double start = omp_get_wtime();
    work();
    best = std::min(best, omp_get_wtime() - start);
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

double peak_flops(int threads) {
  constexpr int kRounds = 1'000'000;
  double sum = 0.0;
  // Each thread by its own best, or one that the system takes from its core would make all slow.
#pragma omp parallel num_threads(threads) reduction(+ : sum)
  sum = 2.0 * kernels::kWidth * kChains * static_cast<double>(kRounds) / fastest([] { multiply_and_add(kRounds); });
  return sum;
}

std::vector<double> core_times(int threads) {
  std::vector<double> times(static_cast<std::size_t>(threads), 0.0);
#pragma omp parallel num_threads(threads)
  {
    const double start = omp_get_wtime();
    mix();
    times[static_cast<std::size_t>(omp_get_thread_num())] = omp_get_wtime() - start;
  }
  return times;
}

double handover_now(int threads) {
  if (threads < 2 || threads > omp_get_num_procs()) return 0.0;
  constexpr int kRounds = 400;
  constexpr int kTurns = 1000;  // on a busy machine the next one may have to get its turn first
  alignas(64) std::atomic<int> next{0};
  double seconds = 0.0;
#pragma omp parallel num_threads(threads)
  {
    const int me = omp_get_thread_num(), n = omp_get_num_threads();
#pragma omp barrier
    const double start = omp_get_wtime();
    for (int i = me; n > 1 && i < kRounds * n; i += n) {
      for (int turn = 0; next.load(std::memory_order_acquire) != i; ++turn) {
        if (turn > kTurns) std::this_thread::yield();
      }
      next.store(i + 1, std::memory_order_release);
    }
    if (n > 1 && me == n - 1) seconds = (omp_get_wtime() - start) / (kRounds * n);
  }
  return seconds;
}

double peak_bandwidth(int threads) {
  constexpr std::int64_t n = 8'000'000;
  Array<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  const double seconds = fastest([&] {
#pragma omp parallel for simd schedule(static) num_threads(threads)
    for (std::int64_t i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      a[k] = b[k] + 3.0 * c[k];
    }
  });
  return 3.0 * sizeof(double) * static_cast<double>(n) / seconds;
}

}  // namespace voussoir::solver
