// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/prefetch.h"
#include "kernels/rows.h"
#include "kernels/side.h"

/// Scheduling of joints in out-of-cache models (World::out_of_cache), where a thread's rows do not stay in its caches: tasks follow each
/// other along the plan instead of colour by colour, and each prefetches the rows of the next one.
namespace voussoir::solver {

/// Tasks that each task waits for: before[k] for k in [first[t], first[t + 1]); all of lower colours.
struct TaskOrder {
  std::span<const std::int32_t> first, before;
};

/// Ranks of tasks along the plan, each after all that it waits for. The latter are neighbours, so few tasks leave the order of the plan.
/// \param place  by task, position of its elements among all
std::vector<std::int32_t> ranks_along_plan(TaskOrder order, std::span<const double> place);

/// Marks the tasks that are not inside a share, all tasks that these wait for, and so on: these are done first, colour by colour.
/// \param inside  by task, 1: it neither waits for a task of another thread's share nor is waited for by one
std::vector<std::uint8_t> tasks_before_borders(TaskOrder order, std::span<const std::uint8_t> inside);

/// Prefetches the rows of the elements that the next task writes to, a few with each block of the current task.
class RowPrefetch {
 public:
  /// \param blocks  of the current task, at least 1
  RowPrefetch(const kernels::Rows& rows, std::span<const std::int32_t> elements, std::size_t blocks)
      : rows_(rows), left_(elements), each_((elements.size() + blocks - 1) / blocks) {}
  [[nodiscard]] bool any() const { return each_ > 0; }
  /// Prefetches with the next `blocks` blocks of the current task.
  void fetch(std::size_t blocks) {
    const std::span<const std::int32_t> now = left_.first(std::min(each_ * blocks, left_.size()));
    for (const std::int32_t element : now) {
      const auto e = static_cast<std::int64_t>(element);
      kernels::prefetch_to_second_cache(rows_.pose + e * kernels::kPoseStride, kernels::kPoseStride * sizeof(double));
      kernels::prefetch_to_second_cache(rows_.wrench + e * kernels::kWrenchStride, kernels::kWrenchStride * sizeof(double));
    }
    left_ = left_.subspan(now.size());
  }

 private:
  const kernels::Rows& rows_;
  std::span<const std::int32_t> left_;
  std::size_t each_;
};

}  // namespace voussoir::solver
