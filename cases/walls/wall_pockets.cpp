// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_pockets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace voussoir::cases {
namespace {

bool is_same(const LegCut& a, const LegCut& b) {
  return std::abs(a.at - b.at) < kPlanTolerance && std::abs(a.slope - b.slope) < kPlanTolerance;
}

/// Takes a range of d out of others.
void take_out(double from, double to, std::vector<std::array<double, 2>>& ranges) {
  std::vector<std::array<double, 2>> left;
  for (const auto& [low, high] : ranges) {
    if (std::min(high, from) > low + kPlanTolerance) left.push_back({low, std::min(high, from)});
    if (std::max(low, to) < high - kPlanTolerance) left.push_back({std::max(low, to), high});
  }
  ranges = std::move(left);
}

/// Pockets that overlap along the leg, in a layer.
using Cluster = std::vector<const Pocket*>;

double start_of(const Pocket& p) { return std::min(p.low(p.from), p.low(p.to)); }
double end_of(const Pocket& p) { return std::max(p.high(p.from), p.high(p.to)); }

std::vector<Cluster> clusters_of(std::vector<const Pocket*> pockets) {
  std::ranges::stable_sort(pockets, {}, [](const Pocket* p) { return start_of(*p); });
  std::vector<Cluster> all;
  double end = 0.0;
  for (const Pocket* p : pockets) {
    if (all.empty() || start_of(*p) > end - kPlanTolerance) all.emplace_back(), end = end_of(*p);
    all.back().push_back(p), end = std::max(end, end_of(*p));
  }
  return all;
}

/// A place between two cuts, with those of the pockets that reach across it.
FilledPlace place_of(const LegCut& low, const LegCut& high, const Cluster& pockets, std::array<double, 2> layer) {
  FilledPlace place{low, high, 0, 0, {layer}, false};
  const double middle = 0.5 * (low.at + high.at);
  Cluster here;
  std::ranges::copy_if(pockets, std::back_inserter(here), [&](const Pocket* p) { return p->low.at < middle && p->high.at > middle; });
  for (std::size_t i = 0; i < here.size(); ++i) {
    take_out(here[i]->from, here[i]->to, place.rest);
    place.floor = std::max(place.floor, here[i]->floor), place.other = i == 0 ? here[i]->floor : std::min(place.other, here[i]->floor);
    for (std::size_t k = 0; k < i; ++k)
      place.crossed = place.crossed || std::min(here[i]->to, here[k]->to) > std::max(here[i]->from, here[k]->from) + kPlanTolerance;
  }
  return place;
}

/// Beams of one direction divide the cluster into places; beams of several are taken to cross.
void add_places(const Cluster& pockets, std::array<double, 2> layer, std::vector<FilledPlace>& all) {
  std::vector<LegCut> cuts;
  for (const Pocket* p : pockets)
    for (const LegCut& cut : {p->low, p->high})
      if (std::ranges::none_of(cuts, [&](const LegCut& c) { return is_same(c, cut); })) cuts.push_back(cut);
  std::ranges::sort(cuts, {}, &LegCut::at);
  const auto is_askew = [&](const LegCut& c) { return std::abs(c.slope - cuts.front().slope) > kPlanTolerance; };
  if (std::ranges::any_of(cuts, is_askew)) {
    all.push_back(place_of(cuts.front(), cuts.back(), pockets, layer));
    all.back().crossed = all.back().crossed || pockets.size() > 1;
    return;
  }
  for (std::size_t i = 1; i < cuts.size(); ++i) all.push_back(place_of(cuts[i - 1], cuts[i], pockets, layer));
}

}  // namespace

std::vector<FilledPlace> beams_in_layer(const Leg& leg, Interval height, double from, double to) {
  std::vector<const Pocket*> pockets;
  for (const Pocket& p : leg.pockets) {
    if (p.height.overlaps(height) && p.from < to - kPlanTolerance && p.to > from + kPlanTolerance) pockets.push_back(&p);
  }
  std::vector<FilledPlace> all;
  for (const Cluster& cluster : clusters_of(std::move(pockets))) add_places(cluster, {from, to}, all);
  return all;
}

}  // namespace voussoir::cases
