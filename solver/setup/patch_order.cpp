// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/patch_order.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

constexpr std::ptrdiff_t kScattered = 128;  // patches out of order that cost more than sorting, which takes some ten steps' time

template <class Column>
void reorder(Column& column, const std::vector<std::size_t>& order, Team& team) {
  Column sorted;
  reserve_in_shares(sorted, column.size(), team);
  for (const std::size_t i : order) sorted.push_back(column[i]);
  column = std::move(sorted);
}

/// Where the points of each patch begin, and where the last end.
std::vector<std::int64_t> ends_of_points(const Patches& p) {
  std::vector<std::int64_t> ends;
  ends.reserve(p.patch.size() + 1);
  for (const FreePatch& patch : p.patch) ends.push_back(patch.first_point);
  ends.push_back(static_cast<std::int64_t>(p.partner.size()));
  return ends;
}

template <class Column>
void reorder_points(Column& column, const std::vector<std::int64_t>& ends, const std::vector<std::size_t>& order, Team& team) {
  Column sorted;
  reserve_in_shares(sorted, column.size(), team);
  for (const std::size_t i : order) sorted.insert(sorted.end(), column.begin() + ends[i], column.begin() + ends[i + 1]);
  column = std::move(sorted);
}

bool is_zero(const kernels::PointSprings& springs) {
  static constexpr kernels::PointSprings kZero{};
  return std::memcmp(&springs, &kZero, sizeof kZero) == 0;
}

/// Writes only what is not zero: see ZeroArray.
void reorder_springs(ZeroArray<kernels::PointSprings>& springs, const std::vector<std::int64_t>& ends,
                     const std::vector<std::size_t>& order) {
  ZeroArray<kernels::PointSprings> sorted;
  sorted.assign_zeros(springs.size());
  std::size_t to = 0;
  for (const std::size_t i : order) {
    for (auto from = static_cast<std::size_t>(ends[i] / kernels::kWidth); from < static_cast<std::size_t>(ends[i + 1] / kernels::kWidth);
         ++from, ++to) {
      if (!is_zero(springs[from])) sorted[to] = springs[from];
    }
  }
  springs = std::move(sorted);
}

void place_points(Patches& p, const std::vector<std::int64_t>& ends, const std::vector<std::size_t>& order) {
  std::int64_t at = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    p.patch[k].first_point = at;
    at += ends[order[k] + 1] - ends[order[k]];
  }
}

}  // namespace

void sort_patches(World& w) {
  Patches& p = w.patches;
  if (std::ranges::is_sorted(p.element)) return;
  std::vector<std::size_t> order(p.patch.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return p.element[a] < p.element[b]; });
  const std::vector<std::int64_t> ends = ends_of_points(p);
  for (auto* column : {&p.partner, &p.face}) reorder_points(*column, ends, order, w.team);
  for (auto* column : {&p.crushed, &p.pressed}) {
    if (!column->empty()) reorder_points(*column, ends, order, w.team);
  }
  reorder_springs(p.springs, ends, order);
  reorder(p.patch, order, w.team);
  reorder(p.element, order, w.team);
  reorder(p.from_side, order, w.team);
  reorder(p.mastered, order, w.team);
  place_points(p, ends, order);
  w.contacts.room.patches = {};
}

bool patches_lie_apart(const World& w) {
  const std::vector<std::int32_t>& all = w.patches.element;
  return all.end() - std::ranges::is_sorted_until(all) >= kScattered;
}

}  // namespace voussoir::solver
