// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/numbering.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>

namespace voussoir::cases {

namespace {

Vec3 middle(const Block& b) {
  const auto& all = b.shape.vertices;
  return (1.0 / static_cast<double>(all.size())) * std::accumulate(all.begin(), all.end(), Vec3{});
}

/// Interleaves the bits of x and y.
std::uint64_t morton(std::uint32_t x, std::uint32_t y) {
  std::uint64_t code = 0;
  for (unsigned i = 0; i < 32; ++i) code |= (std::uint64_t{x >> i & 1U} << (2 * i)) | (std::uint64_t{y >> i & 1U} << (2 * i + 1));
  return code;
}

}  // namespace

void number_along_plan(std::vector<Block>& blocks, double cell) {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0;
  for (const Block& b : blocks) x0 = std::min(x0, middle(b).x), y0 = std::min(y0, middle(b).y);
  // Coordinates equal up to round-off fall in the same cell, and at the same height.
  const auto steps = [](double x, double size) { return static_cast<std::int64_t>(std::floor(x / size + 1e-6)); };
  using Place = std::tuple<std::int32_t, std::uint64_t, std::int64_t, std::size_t>;
  std::vector<Place> order;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Vec3 m = middle(blocks[i]);
    const auto x = static_cast<std::uint32_t>(steps(m.x - x0, cell)), y = static_cast<std::uint32_t>(steps(m.y - y0, cell));
    order.emplace_back(blocks[i].house, morton(x, y), steps(m.z, 1e-3), i);
  }
  std::ranges::sort(order);
  std::vector<Block> sorted;
  sorted.reserve(blocks.size());
  for (const Place& p : order) {
    const std::size_t built = std::get<3>(p);
    sorted.push_back(std::move(blocks[built]));
    sorted.back().built = static_cast<std::int32_t>(built);
  }
  blocks = std::move(sorted);
}

}  // namespace voussoir::cases
