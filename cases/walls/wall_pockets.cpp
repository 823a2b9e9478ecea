// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_pockets.h"

#include <algorithm>
#include <cmath>

namespace voussoir::cases {
namespace {

bool is_same(const LegCut& a, const LegCut& b) { return std::abs(a.at - b.at) < kPlanTolerance && std::abs(a.slope - b.slope) < kPlanTolerance; }

/// Takes a range of d out of others.
void take_out(double from, double to, std::vector<std::array<double, 2>>& ranges) {
  std::vector<std::array<double, 2>> left;
  for (const auto& [low, high] : ranges) {
    if (std::min(high, from) > low + kPlanTolerance) left.push_back({low, std::min(high, from)});
    if (std::max(low, to) < high - kPlanTolerance) left.push_back({std::max(low, to), high});
  }
  ranges = std::move(left);
}

}  // namespace

std::vector<FilledPlace> beams_in_layer(const Leg& leg, Interval height, double from, double to) {
  std::vector<FilledPlace> all;
  for (const Pocket& p : leg.pockets) {
    if (!p.height.overlaps(height) || p.from > to - kPlanTolerance || p.to < from + kPlanTolerance) continue;
    auto place = std::ranges::find_if(all, [&](const FilledPlace& f) { return is_same(f.low, p.low) && is_same(f.high, p.high); });
    if (place == all.end()) place = all.insert(all.end(), {p.low, p.high, p.floor, {{from, to}}});
    take_out(p.from, p.to, place->rest);
  }
  std::ranges::stable_sort(all, {}, [](const FilledPlace& f) { return f.low.at; });
  return all;
}

}  // namespace voussoir::cases
