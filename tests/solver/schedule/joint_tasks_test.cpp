// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/schedule/joint_tasks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <set>
#include <utility>
#include <vector>

#include "solver/setup/setup.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// When a task began and ended, by a clock that ticks at each.
struct Span {
  int begin = 0, end = 0;
};

std::vector<std::set<std::int32_t>> elements_by_task(const solver::World& w) {
  const solver::Sides& s = w.sides;
  std::vector<std::set<std::int32_t>> elements(s.task_first.size() - 1);
  for (std::size_t t = 0; t < elements.size(); ++t) {
    for (std::int32_t b = s.task_first[t]; b < s.task_first[t + 1]; ++b) {
      const kernels::SideBlock& block = s.blocks[static_cast<std::size_t>(b)];
      for (int l = 0; l < kernels::kLanes; ++l) elements[t].insert(block.master[l]), elements[t].insert(block.slave[l]);
    }
    elements[t].erase(w.elements.base);
  }
  return elements;
}

bool share_any(const std::set<std::int32_t>& a, const std::set<std::int32_t>& b) {
  return std::ranges::any_of(a, [&](std::int32_t e) { return b.contains(e); });
}

/// A while that no thread knows beforehand: most tasks are short, some are long.
void work_for(std::size_t task, int round) {
  volatile double sink = 0.0;
  const std::size_t turns = (task * 2654435761U + static_cast<std::size_t>(round) * 40503U) % 97 < 9 ? 20000 : 100;
  for (std::size_t i = 0; i < turns; ++i) sink = sink + 1.0;
}

/// One round by the first `come` threads of a team.
std::vector<Span> one_round(solver::JointTasks& tasks, solver::Team& team, std::size_t count, int come, int round) {
  std::vector<Span> spans(count);
  std::atomic<int> clock{0}, done{0};
  tasks.begin(team);
  team.run_on_all([&](int thread) {
    if (thread >= come) return;
    const auto work = [&](std::size_t t, std::span<const std::int32_t>) {
      spans[t].begin = ++clock;
      work_for(t, round);
      spans[t].end = ++clock;
      ++done;
    };
    tasks.run_own(thread, work);
    tasks.help(thread, work);
  });
  REQUIRE(done == static_cast<int>(count));
  return spans;
}

/// Pairs of tasks that share an element, the lower number first.
std::vector<std::pair<std::size_t, std::size_t>> neighbours(const solver::World& w) {
  const auto elements = elements_by_task(w);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < elements.size(); ++a) {
    for (std::size_t b = a + 1; b < elements.size(); ++b) {
      if (share_any(elements[a], elements[b])) pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("joint tasks that share an element follow each other in one order, with any number of threads") {
  const cases::Case c = small_wall(12, 12);
  const cases::Model m = cases::build_model(c);
  struct Form {
    double cell;
    std::size_t out_of_cache_from;
  };
  for (const Form form :
       {Form{0.21, 1000}, Form{0.06, 1000}, Form{0.21, 1}, Form{0.06, 1}}) {  // sides span more than two of the small cells
    solver::Options o;
    o.cell = form.cell, o.out_of_cache_from = form.out_of_cache_from;
    const auto w = solver::build_world(c, m, o);
    const auto pairs = neighbours(*w);
    const std::size_t count = w->sides.task_first.size() - 1;
    CHECK(count > 20);
    CHECK(pairs.size() > count);
    solver::JointTasks tasks(*w);
    solver::Team team;
    for (int round = 0; round < 600; ++round) {
      team.set_size(std::array{1, 2, 3, 8}[static_cast<std::size_t>(round / 150)]);  // borders move, twice
      const int come = round % 150 >= 140 ? (1 + team.size()) / 2 : team.size();
      const std::vector<Span> spans = one_round(tasks, team, count, come, round);
      for (const Span& s : spans) REQUIRE(s.end > 0);
      for (const auto& [a, b] : pairs) REQUIRE(spans[a].end < spans[b].begin);
    }
  }
}

TEST_CASE("tasks of an out-of-cache model run along the plan, those at borders of shares and all that they wait for first") {
  cases::Case c = small_wall(40, 6);
  std::ranges::stable_sort(c.blocks, {},
                           [](const cases::BlockSpec& b) { return (*b.box)[0].x; });  // elements that lie together, as in a house
  const cases::Model m = cases::build_model(c);
  struct Order {
    std::vector<std::size_t> tasks;
    std::vector<std::vector<std::int32_t>> ahead;
  };
  const auto order_of = [&](solver::JointTasks& tasks, int threads) {
    std::vector<Order> orders(static_cast<std::size_t>(threads));
    solver::Team team(threads);
    tasks.begin(team);
    team.run_on_all([&](int thread) {
      Order& mine = orders[static_cast<std::size_t>(thread)];
      tasks.run_own(thread, [&](std::size_t t, std::span<const std::int32_t> ahead) {
        mine.tasks.push_back(t);
        mine.ahead.emplace_back(ahead.begin(), ahead.end());
      });
    });
    return orders;
  };
  const auto colour_changes = [](const solver::World& w, const std::vector<std::size_t>& tasks) {
    const auto colour = [&](std::size_t t) { return std::ranges::upper_bound(w.sides.colour_first, static_cast<std::int32_t>(t)); };
    int changes = 0;
    for (std::size_t k = 1; k < tasks.size(); ++k) changes += colour(tasks[k]) != colour(tasks[k - 1]);
    return changes;
  };
  solver::Options o;
  o.cell = 0.21;
  const auto near = solver::build_world(c, m, o);
  o.out_of_cache_from = 1;
  const auto far = solver::build_world(c, m, o);
  solver::JointTasks near_tasks(*near), far_tasks(*far);
  const auto in_near = order_of(near_tasks, 1), in_far = order_of(far_tasks, 1);
  const int colours = static_cast<int>(near->sides.colour_first.size()) - 1;
  CHECK(colour_changes(*near, in_near[0].tasks) == colours - 1);
  CHECK(colour_changes(*far, in_far[0].tasks) > 20);
  CHECK(std::ranges::all_of(in_near[0].ahead, [](const auto& ahead) { return ahead.empty(); }));
  // What is asked for ahead are the elements of the task that follows.
  const auto elements = elements_by_task(*far);
  for (std::size_t k = 0; k + 1 < in_far[0].tasks.size(); ++k) {
    const auto& next = elements[in_far[0].tasks[k + 1]];
    CHECK(std::ranges::equal(in_far[0].ahead[k], next));
  }
  CHECK(in_far[0].ahead.back().empty());
  // Two threads: each begins at the border, and goes along the plan then.
  const auto of_two = order_of(far_tasks, 2);
  for (const Order& order : of_two) CHECK(colour_changes(*far, order.tasks) > 5);
}
