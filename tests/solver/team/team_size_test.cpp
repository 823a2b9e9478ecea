// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/team/team_size.h"

#include <doctest/doctest.h>

#include <functional>

using voussoir::solver::TeamSize;

namespace {

/// What a machine makes of a step [s], by the number of threads, the step, and the time until then [s].
using Machine = std::function<double(int threads, int step, double time)>;

struct Run {
  double time = 0.0;  // s
  int steps = 0;
};

Run go_on(TeamSize& team, const Machine& machine, double seconds) {
  Run run;
  while (run.time < seconds) {
    const double step = machine(team.size(), run.steps++, run.time);
    team.note(step);
    run.time += step;
  }
  return run;
}

double shared_out(int threads, int /*step*/, double /*time*/) { return 2e-4 / threads + 2e-6 * threads; }

/// A search now and then takes as long as ten steps; other noise is a tenth.
double noisy(int threads, int step, double time) {
  return shared_out(threads, step, time) * (step % 13 == 0 ? 10.0 : 1.0 + 0.1 * ((step * 7919) % 11 - 5) / 5.0);
}

}  // namespace

TEST_CASE("a team whose threads all gain keeps them, and trials take less than a hundredth of the time") {
  for (const int most : {1, 2, 4, 7}) {
    for (const Machine& machine : {Machine(shared_out), Machine(noisy)}) {
      TeamSize team(most);
      go_on(team, machine, 2.0);
      const Run run = go_on(team, machine, 60.0);
      int steps = 0;
      double time = 0.0;
      for (; time < 60.0; ++steps) time += machine(most, steps, time);
      INFO(most << " threads");
      CHECK(run.steps > 0.99 * steps);
    }
  }
}

TEST_CASE("where a core is busy the team is smaller within a second, and as large as before when the core is free again") {
  TeamSize team(2);
  bool busy = true;
  // The second thread has half a core, some milliseconds at a time.
  const Machine machine = [&](int threads, int step, double time) {
    return noisy(threads, step, time) + (busy && threads == 2 && step % 20 == 0 ? 6e-3 : 0.0);
  };
  go_on(team, machine, 1.0);
  CHECK(team.size() == 1);
  const Run run = go_on(team, machine, 20.0);
  TeamSize alone(1);
  CHECK(run.steps > 0.97 * go_on(alone, machine, 20.0).steps);
  CHECK(team.time_of_all() == doctest::Approx(21.0).epsilon(0.01));
  CHECK(team.time_of_fewer() > 0.9 * team.time_of_all());
  CHECK(alone.time_of_all() == 0.0);
  busy = false;
  go_on(team, machine, 10.0);
  CHECK(team.size() == 2);
}

TEST_CASE("a model that is too small for its threads finds the number that suits it, from above and from below") {
  const auto best_of_three = [](int threads, int step, double time) {
    return noisy(1, step, time) * (threads <= 3 ? 1.0 / threads : 1.0 / 3.0 + 0.2 * (threads - 3));
  };
  TeamSize many(16);
  go_on(many, best_of_three, 20.0);
  CHECK(many.size() == 3);
  bool large = false;
  const Machine machine = [&](int threads, int step, double time) {
    return large ? noisy(threads, step, time) : best_of_three(threads, step, time);
  };
  TeamSize grows(8);
  go_on(grows, machine, 20.0);
  large = true;
  go_on(grows, machine, 60.0);
  CHECK(grows.size() == 8);
}

TEST_CASE("steps of a second are tried as well, and trials of them are rare") {
  TeamSize team(2);
  const Run run = go_on(
      team, [](int threads, int, double) { return 1.0 / threads; }, 40000.0);
  CHECK(run.steps > 0.99 * 80000.0);
}
