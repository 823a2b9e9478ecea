// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/first_touch.h"

#include <doctest/doctest.h>
#include <omp.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "solver/world/array.h"

using namespace voussoir::solver;

namespace {

constexpr int kThreads = 3;
constexpr std::size_t kPages = 3000;
constexpr std::size_t kPage = 4096;

/// How many pages each thread of the team has been given by the system so far.
std::array<long, kThreads> pages_given() {
  std::array<long, kThreads> given{};
#pragma omp parallel num_threads(kThreads)
  {
    rusage use{};
    getrusage(RUSAGE_THREAD, &use);
    given[static_cast<std::size_t>(omp_get_thread_num())] = use.ru_minflt;
  }
  return given;
}

/// Pages of fresh memory that each thread of a team was the first to touch.
std::array<long, kThreads> touched(std::span<const std::int64_t> borders) {
  void* memory = mmap(nullptr, kPages * kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  REQUIRE(memory != MAP_FAILED);
  madvise(memory, kPages * kPage, MADV_NOHUGEPAGE);
  pages_given();  // whatever a team needs itself
  const std::array<long, kThreads> before = pages_given();
  touch_in_shares(memory, kPages, kPage, kThreads, borders);
  std::array<long, kThreads> after = pages_given();
  for (std::size_t t = 0; t < kThreads; ++t) after[t] -= before[t];
  munmap(memory, kPages * kPage);
  return after;
}

}  // namespace

TEST_SUITE("first touch") {
  TEST_CASE("each thread is the first to touch its share") {
    for (const long pages : touched({})) CHECK(pages == doctest::Approx(1000).epsilon(0.02));
  }

  TEST_CASE("and its share of every section") {
    const std::array<std::int64_t, 3> borders{0, 600, 2400};  // nobody works on the rest
    for (const long pages : touched(borders)) CHECK(pages == doctest::Approx(800).epsilon(0.02));
  }

  TEST_CASE("an array that gets room keeps what is in it") {
    Array<std::int32_t> v(1000);
    std::iota(v.begin(), v.end(), 0);
    reserve_in_shares(v, 200'000, kThreads);
    CHECK(v.size() == 1000);
    CHECK(v.capacity() >= 200'000);
    resize_in_shares(v, 150'000, kThreads);
    CHECK(v.capacity() < 300'000);
    resize_in_shares(v, 210'000, kThreads);
    CHECK(v.capacity() >= 400'000);
    bool kept = v.size() == 210'000;
    for (std::int32_t i = 0; i < 210'000; ++i) kept = kept && v[static_cast<std::size_t>(i)] == (i < 1000 ? i : 0);
    CHECK(kept);
    std::vector<double> w(7, 2.0);
    assign_in_shares(w, 100'000, 1.5, kThreads);
    CHECK(std::accumulate(w.begin(), w.end(), 0.0) == 150'000.0);
  }
}
