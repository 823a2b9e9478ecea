// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>

#include "io/output/measures/capacity/capacity.h"

namespace voussoir::io {
namespace {

/// Rows at which cycles begin and end: the first, and upward zero crossings of the displacement after it was below zero.
std::vector<std::size_t> ends_of(const std::vector<double>& moved) {
  const double least = moved.empty() ? 0.0 : *std::ranges::min_element(moved);
  constexpr double kBack = 0.01;  // of the largest negative displacement: smaller values are oscillations about zero
  std::vector<std::size_t> ends{0};
  bool back = false;
  for (std::size_t i = 1; i < moved.size(); ++i) {
    back = back || moved[i] < kBack * least;
    if (back && moved[i] >= 0.0) ends.push_back(i), back = false;
  }
  return ends;
}

Loop loop_of(const CapacityCurve& c, double weight, std::size_t from, std::size_t to) {
  Loop l;
  l.begin = c.time[from], l.end = c.time[to];
  l.first_factor = c.factor[from], l.last_factor = c.factor[to];
  for (std::size_t i = from; i <= to; ++i) {
    l.most = std::max(l.most, c.moved[i]), l.least = std::min(l.least, c.moved[i]);
    l.most_factor = std::max(l.most_factor, c.factor[i]), l.least_factor = std::min(l.least_factor, c.factor[i]);
    if (i > from) l.area += 0.5 * weight * (c.factor[i] + c.factor[i - 1]) * (c.moved[i] - c.moved[i - 1]);
  }
  l.dissipated = c.losses[to] - c.losses[from];
  l.stored = c.stored[to] - c.stored[from];
  l.other_work = c.input[to] - c.input[from] - l.area;
  const double elastic = 0.5 * (0.5 * weight * (l.most_factor - l.least_factor)) * (0.5 * (l.most - l.least));
  l.viscous_damping = l.area / (4.0 * std::numbers::pi * elastic);
  return l;
}

}  // namespace

std::vector<Loop> loops_of(const CapacityCurve& curve, double weight) {
  std::vector<Loop> loops;
  const std::vector<std::size_t> ends = ends_of(curve.moved);
  for (std::size_t k = 1; k < ends.size(); ++k) loops.push_back(loop_of(curve, weight, ends[k - 1], ends[k]));
  return loops;
}

}  // namespace voussoir::io
