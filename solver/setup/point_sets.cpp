// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/point_sets.h"

#include <algorithm>

namespace voussoir::solver {

std::int32_t PointSetBuilder::add(geometry::SegmentList points) {
  const std::string_view key(reinterpret_cast<const char*>(points.data()), points.size_bytes());
  const auto [found, is_new] = known_.emplace(key, static_cast<std::int32_t>(sets_.count.size()));
  if (!is_new) return found->second;
  sets_.first.push_back(static_cast<std::int32_t>(sets_.s.size()));
  sets_.count.push_back(static_cast<std::int32_t>(points.size()));
  sets_.largest = std::max(sets_.largest, static_cast<std::int32_t>(points.size()));
  for (const geometry::Segment& p : points) {
    sets_.s.push_back(p.s);
    sets_.t.push_back(p.t);
    sets_.area.push_back(p.area);
  }
  const auto padded = static_cast<std::size_t>(round_up(static_cast<std::int64_t>(sets_.s.size()), kernels::kLanes));
  sets_.s.resize(padded, points.empty() ? 0.0 : points.back().s);  // in place of a real point, so that padding is never far outside
  sets_.t.resize(padded, points.empty() ? 0.0 : points.back().t);
  sets_.area.resize(padded, 0.0);
  return found->second;
}

}  // namespace voussoir::solver
