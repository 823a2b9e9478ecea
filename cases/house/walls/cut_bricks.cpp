// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/walls/cut_bricks.h"

#include <algorithm>
#include <cmath>

namespace voussoir::cases {
namespace {

using geometry::Polygon;

constexpr double kRoundOff = 1e-9;  // m
constexpr double kFar = 1e5;        // m, beyond any wall

/// Removes corners that the cut made twice.
void drop_doubled(Polygon& section) {
  const auto same = [&](geometry::Point2 a, geometry::Point2 b) { return std::hypot(a.s - b.s, a.t - b.t) < kRoundOff; };
  section.erase(std::unique(section.begin(), section.end(), same), section.end());
  while (section.size() > 1 && same(section.front(), section.back())) section.pop_back();
}

/// Joins bricks i and i + 1.
void join(const Polygon& section, std::vector<CutBrick>& all, std::size_t i) {
  all[i].high = all[i + 1].high;
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  cut_brick(section, all[i]);
}

}  // namespace

Polygon part_between(const Polygon& under, double low, double high, double from, double to) {
  Polygon section = under, scratch;
  geometry::clip(section, {0.0, -1.0}, -low, scratch);
  geometry::clip(section, {0.0, 1.0}, high, scratch);
  geometry::clip(section, {-1.0, 0.0}, -from, scratch);
  geometry::clip(section, {1.0, 0.0}, to, scratch);
  const auto put_on = [](double& value, double line) {
    if (std::abs(value - line) < kRoundOff) value = line;
  };
  for (geometry::Point2& p : section) {
    for (const double line : {low, high}) put_on(p.t, line);
    for (const double line : {from, to}) put_on(p.s, line);
  }
  return section;
}

void cut_brick(const Polygon& section, CutBrick& brick) {
  brick.section = part_between(section, -kFar, kFar, brick.low, brick.high);
  drop_doubled(brick.section);
  brick.area = geometry::region(brick.section).area;
}

void join_small(const Polygon& section, double least, std::vector<CutBrick>& all) {
  while (all.size() > 1) {
    const auto small = std::find_if(all.begin(), all.end(), [&](const CutBrick& p) { return p.area < least; });
    if (small == all.end()) return;
    const auto i = static_cast<std::size_t>(small - all.begin());
    const bool with_next = i == 0 || (i + 1 < all.size() && all[i + 1].area < all[i - 1].area);
    join(section, all, with_next ? i : i - 1);
  }
}

}  // namespace voussoir::cases
