// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/schedule.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "solver/setup/setup.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// The tasks of a wall, in small cells so that there are many.
struct Tasks {
  cases::Case c = small_wall(8, 12);
  cases::Model m = cases::build_model(c);
  solver::Options o = [] {
    solver::Options some;
    some.cell = 0.3;
    return some;
  }();
  std::unique_ptr<solver::World> w = solver::build_world(c, m, o);
  solver::JointTasks tasks{*w};
  std::size_t count = w->sides.task_first.size() - 1;
};

std::vector<double> even(int threads) {
  std::vector<double> ends;
  for (int k = 1; k <= threads; ++k) ends.push_back(static_cast<double>(k) / threads);
  return ends;
}

/// The longest chain of tasks that wait for one another.
double longest_chain(const solver::JointTasks& tasks, const std::vector<double>& times) {
  std::vector<double> end(times.size());
  for (std::size_t t = 0; t < times.size(); ++t) {  // those that a task waits for have lower numbers
    for (const std::int32_t b : tasks.before(t)) end[t] = std::max(end[t], end[static_cast<std::size_t>(b)]);
    end[t] += times[t];
  }
  return std::ranges::max(end);
}

}  // namespace

TEST_CASE("the model of the schedule: one thread waits for nobody, more of them for the longest chain at least") {
  const Tasks t;
  REQUIRE(t.count >= 20);
  std::vector<double> times;
  for (std::size_t k = 0; k < t.count; ++k) times.push_back(1e-6 * static_cast<double>(1 + k % 7));
  const double sum = std::accumulate(times.begin(), times.end(), 0.0), chain = longest_chain(t.tasks, times);
  const solver::QueueTimes one = solver::go_through(t.tasks, t.tasks.plan(even(1)), times, 1.0);
  CHECK(one.end[0] == doctest::Approx(sum));
  CHECK(one.waited[0] == 0.0);
  for (const int threads : {2, 3, 5}) {
    const auto plan = t.tasks.plan(even(threads));
    const solver::QueueTimes q = solver::go_through(t.tasks, plan, times, 0.0);
    CHECK(std::ranges::max(q.end) >= std::max(chain, sum / threads) * (1.0 - 1e-12));
    for (std::size_t k = 0; k < q.end.size(); ++k) {
      double own = 0.0;
      for (std::size_t task = 0; task < t.count; ++task) own += plan.owner[task] == k ? times[task] : 0.0;
      CHECK(q.end[k] == doctest::Approx(own + q.waited[k]));
    }
    const double late = std::ranges::max(solver::go_through(t.tasks, plan, times, 1e-3).end);
    CHECK(late >= 1e-3);  // a task at a border waits for a hand-over
    CHECK(late <= std::ranges::max(q.end) + 1e-3 * static_cast<double>(t.count));
  }
}

TEST_CASE("the model of a step: its parts sum, what one thread does alone stays, and barriers grow with the team") {
  const Tasks t;
  solver::MeasuredStep m;
  m.tasks.assign(t.count, 1e-5);
  m.handover = 1e-7;
  m.parts[static_cast<std::size_t>(solver::ForcePart::contacts)] = 2e-4;
  const auto set = [&](solver::Stage s, double one, double two) {
    m.one[static_cast<std::size_t>(s)] = one, m.two[static_cast<std::size_t>(s)] = two;
  };
  set(solver::Stage::forces, 1.0, 1.0);    // not used: its parts are
  set(solver::Stage::update, 1e-4, 9e-5);  // shared, whatever it took on two
  set(solver::Stage::search, 4e-5, 3e-5);  // half of it alone
  set(solver::Stage::damage, 3e-6, 3e-6);  // alone
  m.alone = 1e-6;
  const double joints = 1e-5 * static_cast<double>(t.count);
  const solver::PredictedStep one = solver::predict(t.tasks, m, 1);
  CHECK(one.step == doctest::Approx(joints + 2e-4 + 1e-4 + 4e-5 + 3e-6 + 1e-6));
  CHECK(one.waiting == 0.0);
  for (const int cores : {2, 4}) {
    const solver::PredictedStep p = solver::predict(t.tasks, m, cores);
    CHECK(p.alone == doctest::Approx(2e-5 + 3e-6 + 1e-6));
    CHECK(p.contacts == doctest::Approx(2e-4 / cores));
    CHECK(p.others == doctest::Approx((1e-4 + 2e-5) / cores));
    CHECK(p.joints == doctest::Approx(joints / cores));
    CHECK(p.waiting >= 4.0 * cores * m.handover);
    CHECK(p.step == doctest::Approx(p.joints + p.contacts + p.others + p.waiting + p.alone));
    CHECK(p.step < one.step);
  }
}
