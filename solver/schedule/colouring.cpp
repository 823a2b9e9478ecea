// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/schedule/colouring.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <map>
#include <unordered_map>

#include "geometry/nth.h"
#include "kernels/rows.h"

namespace voussoir::solver {

namespace {

constexpr double kFits = 0.995;  // share of the sides that must fit between two neighbouring cells
// Elements in a cell, if the model filled its plan evenly; walls are denser. Elements on the borders of cells are fetched once for each
// colour, so a model of which little stays near the core has larger cells. In a smaller one these would only keep less of a task near.
constexpr std::size_t kManyElements = 5000;
constexpr double kElementsInACell = 32.0, kElementsInALargeCell = 64.0, kElementsOutOfCache = 512.0;

double along(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// The plane of the two longest extents.
struct Plan {
  int first = 0, second = 1;  // axes
  Vec3 low, high;
};
Plan plan_of(std::span<const Vec3> points) {
  Plan p;
  p.low = {1e300, 1e300, 1e300}, p.high = {-1e300, -1e300, -1e300};
  for (const Vec3& x : points) {
    p.low = {std::min(p.low.x, x.x), std::min(p.low.y, x.y), std::min(p.low.z, x.z)};
    p.high = {std::max(p.high.x, x.x), std::max(p.high.y, x.y), std::max(p.high.z, x.z)};
  }
  std::array<int, 3> axes{0, 1, 2};
  const Vec3 size = p.high - p.low;
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return along(size, a) > along(size, b); });
  p.first = std::min(axes[0], axes[1]), p.second = std::max(axes[0], axes[1]);
  return p;
}

/// Sides in rounds of sides that share no element: neighbours in a vector then do not wait for each other's sums.
std::vector<std::int32_t> in_rounds(std::span<const Writes> sides, const std::vector<std::int32_t>& items) {
  std::unordered_map<std::int32_t, std::uint64_t> used;
  std::vector<std::pair<int, std::int32_t>> order;
  for (const std::int32_t i : items) {
    const Writes& w = nth(sides, i);
    std::uint64_t taken = 0;
    for (const std::int32_t e : w) taken |= e >= 0 ? used[e] : 0;
    const int round = std::min(std::countr_one(taken), 63);
    for (const std::int32_t e : w) {
      if (e >= 0) used[e] |= std::uint64_t{1} << round;
    }
    order.emplace_back(round, i);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::int32_t> result;
  for (const auto& [round, i] : order) result.push_back(i);
  return result;
}

/// Kind by kind, each in rounds. \param together  what comes in such numbers of one kind goes first, the rest of all kinds after it
std::vector<std::int32_t> kind_by_kind(std::span<const Writes> sides, std::span<const std::int32_t> kinds,
                                       const std::vector<std::int32_t>& items, std::size_t together) {
  std::map<std::int32_t, std::vector<std::int32_t>> of_kind;
  for (const std::int32_t i : items) of_kind[nth(kinds, i)].push_back(i);
  std::vector<std::int32_t> result, rest;
  for (const auto& [kind, of_this] : of_kind) {
    const std::vector<std::int32_t> ordered = in_rounds(sides, of_this);
    const auto end = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / together * together);
    result.insert(result.end(), ordered.begin(), end);
    rest.insert(rest.end(), end, ordered.end());
  }
  result.insert(result.end(), rest.begin(), rest.end());
  return result;
}

}  // namespace

double choose_cell(std::span<const Writes> sides, std::span<const Vec3> centroids, bool out_of_cache) {
  const Plan plan = plan_of(centroids);
  std::vector<double> reach;
  for (const Writes& w : sides) {
    if (w[0] < 0 || w[1] < 0) continue;
    const Vec3 d = nth(centroids, w[0]) - nth(centroids, w[1]);
    reach.push_back(std::max(std::abs(along(d, plan.first)), std::abs(along(d, plan.second))));
  }
  std::sort(reach.begin(), reach.end());
  const double needed = reach.empty() ? 0.0 : reach[static_cast<std::size_t>(kFits * static_cast<double>(reach.size() - 1))];
  const Vec3 size = plan.high - plan.low;
  const double area = along(size, plan.first) * along(size, plan.second);
  const double elements = out_of_cache ? kElementsOutOfCache : centroids.size() < kManyElements ? kElementsInACell : kElementsInALargeCell;
  const double useful = std::sqrt(area * elements / static_cast<double>(std::max<std::size_t>(1, centroids.size())));
  const double cell = std::max(1.001 * needed, useful);  // a hair more than needed: centroids lie on a grid
  return cell > 0.0 ? cell : 1.0;
}

Decomposition decompose(std::span<const Writes> sides, std::span<const std::int32_t> kinds, std::span<const Vec3> centroids, double cell,
                        bool out_of_cache) {
  const Plan plan = plan_of(centroids);
  using Cell = std::array<std::int64_t, 2>;
  const auto cell_of = [&](std::int32_t e) {
    const Vec3 x = nth(centroids, e) - plan.low;
    return Cell{static_cast<std::int64_t>(along(x, plan.first) / cell), static_cast<std::int64_t>(along(x, plan.second) / cell)};
  };
  Decomposition d;
  std::array<std::map<Cell, std::vector<std::int32_t>>, 4> tasks;  // by colour; a map: in one fixed order
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Writes& w = sides[i];
    const Cell a = cell_of(w[0] >= 0 ? w[0] : w[1]), b = cell_of(w[1] >= 0 ? w[1] : w[0]);
    if (std::abs(a[0] - b[0]) > 1 || std::abs(a[1] - b[1]) > 1) {
      d.overflow.push_back(static_cast<std::int32_t>(i));
      continue;
    }
    const Cell home{std::min(a[0], b[0]), std::min(a[1], b[1])};
    nth(tasks, home[0] % 2 + 2 * (home[1] % 2))[home].push_back(static_cast<std::int32_t>(i));
  }
  for (const auto& of_colour : tasks) {
    if (of_colour.empty()) continue;
    d.colours.emplace_back();
    for (const auto& [home, items] : of_colour)
      d.colours.back().push_back(kind_by_kind(sides, kinds, items, out_of_cache ? kernels::kLanes : 1));
  }
  return d;
}

}  // namespace voussoir::solver
