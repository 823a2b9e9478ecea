// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/bench/bench_timing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/run/simulation.h"
#include "solver/bench/machine.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;

namespace {

io::Sample sample(std::vector<double> cores) { return {.steps = 1, .time = 1.0, .cores = std::move(cores)}; }

}  // namespace

TEST_CASE("a sample is quiet where each core is as fast as it has been, whatever the others are") {
  CHECK(io::quiet({}).empty());
  // The second core is slower by nature, like one that saves energy.
  const std::vector<io::Sample> samples{sample({1.00, 2.00}), sample({1.04, 2.08}), sample({1.06, 2.00}), sample({1.00, 2.12}),
                                        sample({2.00, 4.00})};
  CHECK(io::quiet(samples) == std::vector<bool>{true, true, false, false, false});
}

TEST_CASE("a sample with fewer threads than asked for is not quiet, and says nothing of the others") {
  const std::vector<io::Sample> samples{sample({1.0, 0.0}), sample({1.0, 2.0})};
  CHECK(io::quiet(samples) == std::vector<bool>{false, true});
}

TEST_CASE("every team is timed as often, and more threads than cores are never quiet") {
  const cases::Case c = testing::small_wall(4, 4);
  const cases::Model model = cases::build_model(c);
  solver::Simulation sim(c, model, {}, {});
  const std::array counts{1, 2, 2 * solver::processors()};
  const int threads_before = sim.threads();
  for (const int steps : {3, 27}) {
    const std::int64_t steps_before = sim.steps();
    const std::vector<io::Timing> timings = io::time_steps(sim, counts, {.least = 2, .most = 3, .steps = steps});
    const auto batches = static_cast<int>(sim.steps() - steps_before) / (2 * 3 * steps);  // as many steps before each as in it
    CHECK(sim.steps() - steps_before == batches * 2 * 3 * steps);
    CHECK(batches >= 2);
    CHECK(batches <= 3);
    REQUIRE(timings.size() == counts.size());
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const io::Timing& t = timings[k];
      CHECK(t.threads == counts[k]);
      CHECK(t.step > 0.0);
      CHECK(t.samples == batches * std::min(steps, 10));
      CHECK(t.quiet <= t.samples);
      CHECK((t.quiet_step > 0.0) == (t.quiet > 0));
    }
    CHECK(timings[0].speedup == 1.0);
    CHECK(timings[0].quiet >= 1);
    CHECK(timings[0].quiet_speedup == 1.0);
    CHECK(timings[2].quiet == 0);
    CHECK(timings[2].quiet_speedup == 0.0);
  }
  CHECK(sim.threads() == threads_before);
}
