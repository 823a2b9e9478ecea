// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/schedule/joint_tasks.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/nth.h"
#include "solver/schedule/out_of_cache.h"

namespace voussoir::solver {

namespace {

/// Elements that the sides of a task write to, ascending.
std::vector<std::int32_t> elements_of(const World& w, std::size_t task) {
  std::vector<std::int32_t> elements;
  for (std::int32_t b = w.sides.task_first[task]; b < w.sides.task_first[task + 1]; ++b) {
    const kernels::SideBlock& block = nth(w.sides.blocks, b);
    for (const auto& ends : {block.master, block.slave}) elements.insert(elements.end(), ends, ends + kernels::kLanes);
  }
  std::ranges::sort(elements);
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  std::erase(elements, w.elements.base);
  return elements;
}

}  // namespace

JointTasks::JointTasks(const World& w) : flag_(w.sides.task_first.size() - 1), first_before_(1, 0) {
  const Sides& s = w.sides;
  std::vector<std::int32_t> last(static_cast<std::size_t>(w.elements.rows), -1);  // by element: the task that wrote to it last
  for (std::size_t task = 0; task < flag_.size(); ++task) {
    std::vector<std::int32_t> elements = elements_of(w, task);
    std::vector<std::int32_t> waits;
    for (const std::int32_t e : elements) waits.push_back(std::exchange(nth(last, e), static_cast<std::int32_t>(task)));
    std::ranges::sort(waits);
    const auto end = std::unique(waits.begin(), waits.end());
    std::copy_if(waits.begin(), end, std::back_inserter(before_), [](std::int32_t t) { return t >= 0; });
    first_before_.push_back(static_cast<std::int32_t>(before_.size()));
    const auto colour = std::ranges::upper_bound(s.colour_first, static_cast<std::int32_t>(task)) - s.colour_first.begin() - 1;
    colour_.push_back(static_cast<std::int32_t>(colour));
    const double sum = std::accumulate(elements.begin(), elements.end(), 0.0);
    place_.push_back(sum / static_cast<double>(elements.size()) / static_cast<double>(w.elements.rows));
    if (w.out_of_cache) elements_.push_back(std::move(elements));
  }
  if (w.out_of_cache) rank_ = ranks_along_plan({first_before_, before_}, place_);
}

void JointTasks::begin(Team& team) {
  ++step_;
  team_ = &team;
  if (shares_.begin(team.size())) queue_up();
  shares_.deal(ends_);
}

/// In each colour those come first that wait for another thread's, or that another thread's wait for: so both are done long before.
JointTasks::Plan JointTasks::plan(std::span<const double> borders) const {
  const std::size_t tasks = place_.size();
  Plan p;
  for (const double place : place_) {
    p.owner.push_back(static_cast<std::size_t>(std::upper_bound(borders.begin(), borders.end() - 1, place) - borders.begin()));
  }
  p.inside.assign(tasks, 1);
  for (std::size_t task = 0; task < tasks; ++task) {
    for (const std::int32_t k : before(task)) {
      const auto other = static_cast<std::size_t>(k);
      if (p.owner[task] != p.owner[other]) p.inside[task] = p.inside[other] = 0;
    }
  }
  const std::vector<std::uint8_t> by_colour =
      rank_.empty() ? std::vector<std::uint8_t>(tasks, 1) : tasks_before_borders({first_before_, before_}, p.inside);
  p.queues.resize(tasks);
  std::iota(p.queues.begin(), p.queues.end(), 0);
  std::ranges::sort(p.queues, {}, [&](std::int32_t t) {
    const auto task = static_cast<std::size_t>(t);
    const bool first = by_colour[task] != 0;
    return std::tuple(p.owner[task], !first, first ? colour_[task] : rank_[task], p.inside[task], place_[task], t);
  });
  p.ends.assign(borders.size(), 0);
  for (std::size_t task = 0; task < tasks; ++task) ++p.ends[p.owner[task]];
  std::partial_sum(p.ends.begin(), p.ends.end(), p.ends.begin());
  return p;
}

void JointTasks::queue_up() {
  Plan p = plan(shares_.borders());
  place_flags(p);
  queues_ = std::move(p.queues), ends_ = std::move(p.ends), owner_ = std::move(p.owner);
  queue_place_.resize(queues_.size());
  for (std::size_t i = 0; i < queues_.size(); ++i) nth(queue_place_, queues_[i]) = static_cast<std::int32_t>(i);
}

/// Flags of a thread lie together, far from those of others. One that another thread looks at has a pair of lines of its own: or it would
/// take those beside it from the thread that is about to write them.
void JointTasks::place_flags(const Plan& plan) {
  const std::vector<std::size_t>& owner = plan.owner;
  const std::vector<std::uint8_t>& inside = plan.inside;
  constexpr std::size_t kLines = 128 / sizeof(Flag);
  std::vector<std::size_t> by_thread(owner.size());
  std::iota(by_thread.begin(), by_thread.end(), std::size_t{0});
  std::ranges::sort(by_thread, {}, [&](std::size_t task) { return std::tuple(owner[task], inside[task], task); });
  std::size_t next = 0;
  for (std::size_t k = 0; k < by_thread.size(); ++k) {
    const std::size_t task = by_thread[k];
    if (k > 0 && owner[task] != owner[by_thread[k - 1]]) next += kApart / sizeof(Flag);
    flag_[task] = next;
    next += inside[task] != 0 ? 1 : kLines;
  }
  done_ = decltype(done_)(next);
  for (Flag& f : done_) f.store(step_ - 1, std::memory_order_relaxed);
}

}  // namespace voussoir::solver
