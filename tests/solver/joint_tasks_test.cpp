// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/joint_tasks.h"

#include <doctest/doctest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <set>
#include <utility>
#include <vector>

#include "solver/setup.h"
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

/// One round with a team that has `given` of the threads that it was asked for.
std::vector<Span> one_round(solver::JointTasks& tasks, std::size_t count, int asked, int given, int round) {
  std::vector<Span> spans(count);
  std::atomic<int> clock{0}, done{0};
  tasks.begin(asked);
#pragma omp parallel num_threads(given)
  {
    const auto work = [&](std::size_t t) {
      spans[t].begin = ++clock;
      work_for(t, round);
      spans[t].end = ++clock;
      ++done;
    };
    tasks.run_own(work);
    tasks.help(work);
  }
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
  for (const double cell : {0.21, 0.06}) {  // with the smaller one sides span more than two cells
    solver::Options o;
    o.cell = cell;
    const auto w = solver::build_world(c, m, o);
    const auto pairs = neighbours(*w);
    const std::size_t count = w->sides.task_first.size() - 1;
    CHECK(count > 20);
    CHECK(pairs.size() > count);
    solver::JointTasks tasks(*w);
    for (int round = 0; round < 600; ++round) {
      const int asked = std::array{1, 2, 3, 8}[static_cast<std::size_t>(round / 150)];  // borders move, twice
      const std::vector<Span> spans = one_round(tasks, count, asked, round % 150 >= 140 ? (1 + asked) / 2 : asked, round);
      for (const Span& s : spans) REQUIRE(s.end > 0);
      for (const auto& [a, b] : pairs) REQUIRE(spans[a].end < spans[b].begin);
    }
  }
}
