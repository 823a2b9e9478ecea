// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/patch_order.h"

#include <algorithm>
#include <numeric>

namespace voussoir::solver {

namespace {

constexpr std::ptrdiff_t kScattered = 128;  // patches out of order that cost more than sorting, which takes some ten steps' time

bool by_element(const kernels::Patch& a, const kernels::Patch& b) { return a.element < b.element; }

template <class Column>
void reorder(Column& column, const std::vector<std::size_t>& order) {
  Column sorted;
  sorted.reserve(column.size());
  for (const std::size_t i : order) sorted.push_back(column[i]);
  column = std::move(sorted);
}

/// Where the points of each patch begin, and where the last end.
std::vector<std::int64_t> ends_of_points(const Patches& p) {
  std::vector<std::int64_t> ends = p.first_point;
  ends.push_back(static_cast<std::int64_t>(p.partner.size()));
  return ends;
}

template <class Column>
void reorder_points(Column& column, const std::vector<std::int64_t>& ends, const std::vector<std::size_t>& order) {
  Column sorted;
  sorted.reserve(column.size());
  for (const std::size_t i : order) sorted.insert(sorted.end(), column.begin() + ends[i], column.begin() + ends[i + 1]);
  column = std::move(sorted);
}

std::vector<std::int64_t> first_points(const std::vector<std::int64_t>& ends, const std::vector<std::size_t>& order) {
  std::vector<std::int64_t> first;
  first.reserve(order.size());
  std::int64_t at = 0;
  for (const std::size_t i : order) {
    first.push_back(at);
    at += ends[i + 1] - ends[i];
  }
  return first;
}

}  // namespace

void sort_patches(World& w) {
  Patches& p = w.patches;
  std::vector<std::size_t> order(p.patch.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return by_element(p.patch[a], p.patch[b]); });
  const std::vector<std::int64_t> ends = ends_of_points(p);
  for (auto* column : {&p.partner, &p.face}) reorder_points(*column, ends, order);
  for (auto* column : {&p.slip_x, &p.slip_y, &p.slip_z, &p.closure}) reorder_points(*column, ends, order);
  p.first_point = first_points(ends, order);
  reorder(p.patch, order);
  reorder(p.set, order);
  reorder(p.from_side, order);
  reorder(p.mastered, order);
  reorder(p.touching, order);
  for (auto* column : {&p.stored, &p.friction, &p.impact}) reorder(*column, order);
}

void sort_patches_if_scattered(World& w) {
  const std::vector<kernels::Patch>& all = w.patches.patch;
  if (all.end() - std::is_sorted_until(all.begin(), all.end(), by_element) >= kScattered) sort_patches(w);
}

}  // namespace voussoir::solver
