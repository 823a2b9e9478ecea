// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/bench_timing.h"

#include <doctest/doctest.h>
#include <omp.h>

#include <array>

#include "solver/simulation.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;

namespace {

io::Sample sample(std::vector<double> cores) { return {.step = 1.0, .stages = {}, .cores = std::move(cores)}; }

}  // namespace

TEST_CASE("a sample is quiet where each core is as fast as it has been, whatever the others are") {
  CHECK(io::quiet({}).empty());
  // The second core is slower by nature, like one that saves energy.
  const std::vector<io::Sample> samples{sample({1.00, 2.00}), sample({1.04, 2.08}), sample({1.06, 2.00}), sample({1.00, 2.12}),
                                        sample({2.00, 4.00})};
  CHECK(io::quiet(samples) == std::vector<bool>{true, true, false, false, false});
}

TEST_CASE("every team is timed as often, and more threads than cores are never quiet") {
  const cases::Case c = testing::small_wall(4, 4);
  const cases::Model model = cases::build_model(c);
  solver::Simulation sim(c, model, {}, {});
  const std::array counts{1, 2, 2 * omp_get_num_procs()};
  const std::vector<io::Timing> timings = io::time_steps(sim, counts, {.batches = 2, .steps = 20});
  REQUIRE(timings.size() == counts.size());
  CHECK(timings[0].speedup == 1.0);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const io::Timing& t = timings[k];
    CHECK(t.threads == counts[k]);
    CHECK(t.step > 0.0);
    CHECK(t.samples >= 20);
    CHECK(t.samples <= 80);
    CHECK(t.samples == timings[0].samples);
    CHECK(t.quiet <= t.samples);
    CHECK((t.quiet_step > 0.0) == (t.quiet > 0));
  }
  CHECK(timings[2].quiet == 0);
  CHECK(timings[2].quiet_speedup == 0.0);
}
