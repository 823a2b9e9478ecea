// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_storeys.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "cases/walls/spans/wall_bays.h"
#include "geometry/polygon.h"

namespace voussoir::cases {
namespace {

bool overlap_in_plan(const Leg& a, const Leg& b) {
  constexpr double kLeastArea = 1e-8;  // m2, as of geometry's joints
  for (std::size_t f = 0; f < a.facets.size(); ++f) {
    for (std::size_t g = 0; g < b.facets.size(); ++g) {
      if (geometry::region(geometry::intersection(outline_of(a, f), outline_of(b, g))).area > kLeastArea) return true;
    }
  }
  return false;
}

/// Whether a point lies over a leg of these.
bool is_over(const std::vector<const Leg*>& legs, Vec3 p) {
  return std::ranges::any_of(legs, [&](const Leg* leg) { return lies_in(*leg, p); });
}

/// The levels, ascending, at which a leg is parted.
std::vector<Tick> parting(const Leg& leg, std::vector<Tick> levels) {
  std::erase_if(levels, [&](Tick at) { return at <= leg.height.low || at >= leg.eaves; });
  std::ranges::sort(levels);
  Tick most = 0, last = leg.height.low;
  for (const Tick at : levels) most = std::max(most, at - last), last = at;
  most = std::max(most, leg.eaves - last), last = leg.height.low;
  std::vector<Tick> kept;
  for (const Tick at : levels) {
    if (2 * (at - last) >= most && 2 * (leg.eaves - at) >= most) kept.push_back(last = at);
  }
  return kept;
}

/// Adds the levels of floors to the legs round their rooms.
void add_floor_levels(const WallsPlan& plan, std::vector<std::vector<Tick>>& levels) {
  for (const BayFloor& floor : plan.floors) {
    for (const WallFace& face : floor.bay.faces) levels[face.leg].push_back(floor.height.high);
    for (const std::size_t leg : floor.between) levels[leg].push_back(floor.height.high);
  }
}

/// Storeys of a leg that begin below a height.
int storeys_below(const Leg& leg, Tick height) {
  return 1 + static_cast<int>(std::ranges::count_if(leg.storeys, [&](Tick at) { return at < height; }));
}

}  // namespace

void find_wall_storeys(WallsPlan& plan) {
  std::vector<std::vector<Tick>> levels(plan.legs.size());
  add_floor_levels(plan, levels);
  std::vector<std::size_t> order(plan.legs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return plan.legs[i].height.low; });
  std::vector<std::vector<std::size_t>> under(plan.legs.size());
  for (const std::size_t i : order) {
    const Tick foot = plan.legs[i].height.low;
    for (const std::size_t k : order) {
      const Leg& other = plan.legs[k];
      if (other.height.low < foot && foot <= other.height.high && overlap_in_plan(plan.legs[i], other)) under[i].push_back(k);
    }
  }
  for (const Meeting& m : plan.meetings) {
    if (!under[m.host].empty()) levels[m.guest].push_back(plan.legs[m.host].height.low);
    if (!under[m.guest].empty()) levels[m.host].push_back(plan.legs[m.guest].height.low);
  }
  for (std::size_t i = 0; i < plan.legs.size(); ++i) plan.legs[i].storeys = parting(plan.legs[i], levels[i]);
  for (const std::size_t i : order) {
    Leg& leg = plan.legs[i];
    for (const std::size_t k : under[i])
      leg.storey = std::max(leg.storey, plan.legs[k].storey + storeys_below(plan.legs[k], leg.height.low));
    plan.storeys = plan.storeys || leg.storey > 1 || !leg.storeys.empty();
  }
}

double overhang(const WallsPlan& plan, const Leg& leg, bool left) {
  constexpr int kPlaces = 32;
  std::vector<const Leg*> under;
  for (const Leg& other : plan.legs) {
    if (other.eaves == leg.height.low) under.push_back(&other);
  }
  const double side = left ? 1.0 : -1.0;
  std::vector<double> beyond;
  for (int i = 0; i < kPlaces; ++i) {
    const double s = leg.length() * (i + 0.5) / kPlaces;
    if (under.empty() || !is_over(under, leg.at(s, 0.0))) continue;
    double on = 0.0, off = leg.half;
    if (is_over(under, leg.at(s, side * off))) continue;
    for (int k = 0; k < 30; ++k) {
      const double middle = 0.5 * (on + off);
      (is_over(under, leg.at(s, side * middle)) ? on : off) = middle;
    }
    beyond.push_back(leg.half - on);
  }
  if (2 * beyond.size() < kPlaces) return 0.0;
  std::ranges::sort(beyond);
  return beyond[beyond.size() / 2];
}

std::string part_tag(const WallsPlan& plan, const Leg& leg, Interval height) {
  const std::string tag = height.low >= leg.eaves ? side_name(leg) + " gable" : leg.tag;
  if (!plan.storeys) return tag;
  return tag + ", storey " + std::to_string(leg.storey - 1 + storeys_below(leg, (height.low + height.high) / 2));
}

}  // namespace voussoir::cases
