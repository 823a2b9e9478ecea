// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_levels.h"

#include <algorithm>

#include "cases/house/house_parts.h"

namespace voussoir::cases {
namespace {

/// What two ascending lists of ranges have in common.
std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> all;
  for (const Interval i : a) {
    for (const Interval k : b) {
      const Interval both{std::max(i.low, k.low), std::min(i.high, k.high)};
      if (both.low <= both.high) all.push_back(both);
    }
  }
  return all;
}

std::vector<Interval> levels_in(Interval wall, Tick height, Tick lowest) {
  std::vector<Interval> all;
  const Tick last = wall.high - height;  // flush with the top
  for (const Interval under : {Interval{wall.low, wall.low}, {wall.low + lowest, last - lowest}, {last, last}}) {
    const bool is_new = all.empty() || under.low + height > all.back().high;
    if (under.low >= wall.low && under.low <= under.high && under.high <= last && is_new)
      all.push_back({under.low + height, under.high + height});
  }
  all.push_back({wall.high + height, wall.high + height});
  return all;
}

std::vector<Interval> undersides_in(Interval wall, Tick level, Tick lowest) {
  if (level > wall.high) return {{wall.high, wall.high}};
  std::vector<Interval> all{{wall.low, wall.low}};
  if (wall.low + lowest < level) all.push_back({wall.low + lowest, level - 1});
  return all;
}

}  // namespace

std::vector<Interval> beam_levels(const std::array<Interval, 2>& stands, Tick height, Tick lowest) {
  return common(levels_in(stands[0], height, lowest), levels_in(stands[1], height, lowest));
}

std::vector<Interval> beam_undersides(const std::array<Interval, 2>& stands, Tick level, Tick lowest) {
  return common(undersides_in(stands[0], level, lowest), undersides_in(stands[1], level, lowest));
}

std::string ranges_text(const std::vector<Interval>& ranges) {
  std::string all;
  for (const Interval r : ranges)
    all += (all.empty() ? "" : "; ") + (r.low == r.high ? metres_text(r.low) : metres_text(r.low) + " to " + metres_text(r.high)) + " m";
  return all;
}

}  // namespace voussoir::cases
