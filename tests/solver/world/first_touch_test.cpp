// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/first_touch.h"

#include <doctest/doctest.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "solver/world/array.h"

using namespace voussoir::solver;

namespace {

constexpr int kThreads = 3;
constexpr std::size_t kPages = 3000;
constexpr std::size_t kPage = 4096;

Team& team() {
  static Team one(kThreads);
  return one;
}

/// How many pages each thread of the team has been given by the system so far.
std::array<long, kThreads> pages_given() {
  std::array<long, kThreads> given{};
  team().run_on_all([&](int thread) {
    rusage use{};
    getrusage(RUSAGE_THREAD, &use);
    given[static_cast<std::size_t>(thread)] = use.ru_minflt;
  });
  return given;
}

/// Share of the pages that each thread of a team was the first to touch in `make`, and how many these were.
struct Shares {
  std::array<double, kThreads> of_thread{};
  double pages = 0.0;
};
template <class Make>
Shares shares_of(Make make) {
  pages_given();  // whatever a team needs itself
  const std::array<long, kThreads> before = pages_given();
  make();
  const std::array<long, kThreads> after = pages_given();
  Shares s;
  for (std::size_t t = 0; t < kThreads; ++t) s.pages += s.of_thread[t] = static_cast<double>(after[t] - before[t]);
  for (double& x : s.of_thread) x /= s.pages;
  return s;
}

/// \param fresh  pages from here on somebody else has written to before
Shares touched(std::span<const std::int64_t> borders, std::size_t fresh = kPages) {
  void* memory = mmap(nullptr, kPages * kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  REQUIRE(memory != MAP_FAILED);
  madvise(memory, kPages * kPage, MADV_NOHUGEPAGE);
  for (std::size_t page = fresh; page < kPages; ++page) static_cast<volatile char*>(memory)[page * kPage] = 0;
  const Shares s = shares_of([&] { touch_in_shares(memory, kPage, team(), borders); });
  munmap(memory, kPages * kPage);
  return s;
}

void check_thirds(const Shares& s, double pages) {
  CHECK(s.pages >= pages);
  for (const double share : s.of_thread) CHECK(share == doctest::Approx(1.0 / 3.0).epsilon(0.05));
}

}  // namespace

TEST_SUITE("first touch") {
  TEST_CASE("each thread is the first to touch its share") { check_thirds(touched(std::array<std::int64_t, 2>{0, 3000}), 3000); }

  TEST_CASE("and its share of every section") {
    const std::array<std::int64_t, 3> borders{0, 600, 2400};  // nobody works on the rest
    check_thirds(touched(borders), 2400);
    check_thirds(touched(borders, 600), 600);  // of the first section alone, all of which is in the first third of both
  }

  TEST_CASE("room for an array is touched in shares, and what is in it stays") {
    Array<std::int32_t> v(1000);
    std::iota(v.begin(), v.end(), 0);
    reserve_in_shares(v, 400'000, team());
    CHECK(v.size() == 1000);
    CHECK(v.capacity() == 600'000);
    bool kept = true;
    for (std::int32_t i = 0; i < 1000; ++i) kept = kept && v[static_cast<std::size_t>(i)] == i;
    CHECK(kept);
    const std::int32_t* before = v.data();
    reserve_in_shares(v, 600'000, team());
    CHECK(v.data() == before);
    std::vector<double> w(7, 2.0);
    assign_in_shares(w, 100'000, 1.5, team());
    CHECK(w.size() == 100'000);
    CHECK(std::accumulate(w.begin(), w.end(), 0.0) == 150'000.0);
  }
}
