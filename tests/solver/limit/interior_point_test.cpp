// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/programme/interior_point.h"

#include <doctest/doctest.h>
#include <omp.h>

#include <cmath>
#include <cstdint>
#include <ctime>
#include <optional>
#include <vector>

#include "cases/random.h"

// The interior-point method on programmes whose solution is known: unknowns and prices that prove each other optimal are chosen first.
namespace voussoir::testing {
namespace {

using cases::mixed;

double number(std::size_t i, std::uint64_t seed) { return static_cast<double>(mixed(i + (seed << 40U)) >> 11U) * 0x1p-53; }  // 0 to 1

struct Known {
  solver::InteriorProgramme programme;
  double cost = 0.0;
};

/// Columns of eight entries in neighbouring rows; the first has entries in all. One in ten unknowns is not zero.
Known known(std::size_t rows, std::size_t columns) {
  constexpr std::size_t kEntries = 8;
  Known k;
  solver::InteriorProgramme& p = k.programme;
  p.right.assign(rows, 0.0);
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t entries = c == 0 ? rows : kEntries, first = c == 0 ? 0 : c % (rows - kEntries + 1);
    const bool taken = c == 0 || c % 10 == 3;
    const double unknown = taken ? 0.1 + number(c, 1) : 0.0;
    double cost = taken ? 0.0 : 0.1 + number(c, 2);
    for (std::size_t i = 0; i < entries; ++i) {
      const double entry = number(8 * c + i, 3) - 0.4;
      p.add(first + i, entry);
      p.right[first + i] += entry * unknown;
      cost += entry * (number(first + i, 4) - 0.5);
    }
    p.end_column(cost);
    k.cost += cost * unknown;
  }
  return k;
}

double seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

TEST_CASE("interior point: unknowns meet the equations at the least cost, and prices prove it") {
  for (const std::size_t rows : {20, 300}) {
    const Known k = known(rows, 15 * rows);
    const solver::InteriorProgramme& p = k.programme;
    const std::optional<solver::InteriorPoint> found = solver::interior_point(p);
    REQUIRE(found);
    double cost = 0.0, bound = 0.0;
    std::vector<double> left = p.right;
    for (std::size_t c = 0; c < p.costs.size(); ++c) {
      cost += p.costs[c] * found->unknowns[c];
      double price = 0.0;
      for (std::size_t j = p.starts[c]; j < p.starts[c + 1]; ++j) {
        left[p.rows[j]] -= p.entries[j] * found->unknowns[c];
        price += p.entries[j] * found->prices[p.rows[j]];
      }
      CHECK(found->unknowns[c] > 0.0);
      CHECK(price < p.costs[c] + 1e-7);
    }
    for (std::size_t r = 0; r < rows; ++r) {
      CHECK(std::abs(left[r]) < 1e-6);
      bound += p.right[r] * found->prices[r];
    }
    CHECK(cost == doctest::Approx(k.cost).epsilon(1e-7));
    CHECK(bound == doctest::Approx(k.cost).epsilon(1e-7));
  }
}

TEST_CASE("interior point: where rounding allows no such gap, it gives the best point that it met") {
  const Known k = known(300, 4500);
  int last = 0;
  const solver::LpWatch watch = [&](int iteration, double) { last = iteration; };
  const std::optional<solver::InteriorPoint> found = solver::interior_point(k.programme, watch, 1e-30);
  REQUIRE(found);
  CHECK(found->iterations < last);
  CHECK(last < 60);  // it does not go on for all of its 150 iterations
  double cost = 0.0, bound = 0.0;
  for (std::size_t c = 0; c < k.programme.costs.size(); ++c) cost += k.programme.costs[c] * found->unknowns[c];
  for (std::size_t r = 0; r < k.programme.right.size(); ++r) bound += k.programme.right[r] * found->prices[r];
  CHECK(std::abs(cost - bound) < 1e-10);
  CHECK(cost == doctest::Approx(k.cost).epsilon(1e-10));
}

TEST_CASE("interior point: it asks for one core, since threads that wait for each other would take the others for nothing") {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(2);
  const Known k = known(600, 9000);  // so large that Eigen would share its products
  const double all = seconds(CLOCK_PROCESS_CPUTIME_ID), own = seconds(CLOCK_THREAD_CPUTIME_ID);
  CHECK(solver::interior_point(k.programme));
  CHECK(seconds(CLOCK_PROCESS_CPUTIME_ID) - all < 1.2 * (seconds(CLOCK_THREAD_CPUTIME_ID) - own) + 0.01);
  omp_set_num_threads(threads);
}

}  // namespace voussoir::testing
