// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/contact/overlap_contact.h"

namespace voussoir::solver {

namespace {

Vec3 absolute(Vec3 v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

Vec3 centroid(const World& w, std::int32_t e) {
  return w.elements.body[static_cast<std::size_t>(e)].ref + kernels::load_pose(w.elements.pose.data(), e).u;
}

/// Box round an element as it stands.
geometry::Box3 box_of(const World& w, std::int32_t e) {
  const auto i = static_cast<std::size_t>(e);
  const Mat3 r = Mat3{} + kernels::load_pose(w.elements.pose.data(), e).d;
  const Vec3 h{w.elements.half_x[i], w.elements.half_y[i], w.elements.half_z[i]}, x = centroid(w, e);
  const Vec3 half{dot(absolute(r.r0), h), dot(absolute(r.r1), h), dot(absolute(r.r2), h)};
  return {x - half, x + half};
}

/// One listing: which elements, where the others are, and how far bodies may still go before they are listed again.
struct Listing {
  const World& w;
  const std::vector<std::uint8_t>& re_search;
  const geometry::UniformGrid& grid;
  double travel = 0.0;  // m, of both together before one of them is listed again
  double reach = 0.0;   // m, from where a body stands to where the grid has another one
  [[nodiscard]] bool is_re_searched(std::int32_t e) const { return re_search[static_cast<std::size_t>(e)] != 0; }
  [[nodiscard]] bool is_fixed(std::int32_t e) const { return w.elements.fixed[static_cast<std::size_t>(e)] != 0; }
};

double sum_of_travel(const World& w, std::int32_t a, std::int32_t b) { return w.travel.bound(a) + w.travel.bound(b); }

/// Adds the pair unless its bodies cannot come to overlap by more than is allowed before one of them is listed again.
void consider(const Listing& l, std::int32_t a, std::int32_t b, std::vector<OverlapPair>& pairs) {
  const double allowed = allowed_overlap(l.w, a, b), spare = allowed - l.travel;
  const double depth = overlap_of(l.w, a, b, spare).depth;
  if (depth <= spare) return;
  pairs.push_back({a, b, sum_of_travel(l.w, a, b) + (allowed - depth) - kernels::kRoundOff});
}

void list_pairs_of(const Listing& l, std::int32_t e, std::vector<std::int32_t>& near, std::vector<OverlapPair>& pairs) {
  const geometry::Box3 box = box_of(l.w, e);
  near.clear();
  const Vec3 wide{l.reach, l.reach, l.reach};
  l.grid.query({box.low - wide, box.high + wide}, near);
  for (const std::int32_t other : near) {
    if (other == e || (l.is_re_searched(other) && other < e) || (l.is_fixed(e) && l.is_fixed(other))) continue;
    consider(l, std::min(e, other), std::max(e, other), pairs);
  }
  if (l.w.has_base && !l.is_fixed(e)) consider(l, e, l.w.elements.base, pairs);
}

std::vector<OverlapPair> list_pairs(const Listing& l) {
  std::vector<OverlapPair> pairs;
#pragma omp parallel num_threads(l.w.threads)
  {
    std::vector<OverlapPair> mine;
    std::vector<std::int32_t> near;
#pragma omp for schedule(dynamic, 64) nowait
    for (std::int32_t e = 0; e < l.w.elements.count; ++e) {
      if (l.is_re_searched(e)) list_pairs_of(l, e, near, mine);
    }
#pragma omp critical
    pairs.insert(pairs.end(), mine.begin(), mine.end());
  }
  return pairs;
}

/// A pair needs the travel bounds and the velocity rows of both elements.
void take_pairs(World& w, std::vector<OverlapPair> pairs) {
  std::ranges::sort(pairs, {}, [](const OverlapPair& p) { return std::pair(p.a, p.b); });
  for (const OverlapPair& p : pairs) {
    w.travel.activate(w.elements, p.a);
    if (p.b != w.elements.base) w.travel.activate(w.elements, p.b);
  }
  w.overlaps.pairs = std::move(pairs);
  w.overlaps.stale = false;
  if (w.multirate.on()) list_overlap_levels(w);
}

}  // namespace

void list_overlap_pairs(World& w, const std::vector<std::uint8_t>& re_search, double moved) {
  const double travel = w.travel.skin() + moved;
  std::vector<OverlapPair> pairs = list_pairs({w, re_search, w.contacts.grid, travel, travel + moved});
  for (const OverlapPair& p : w.overlaps.pairs) {
    if (re_search[static_cast<std::size_t>(p.a)] == 0 && re_search[static_cast<std::size_t>(p.b)] == 0) pairs.push_back(p);
  }
  take_pairs(w, std::move(pairs));
}

// From where it stands an element goes by the skin at most until it is searched again: back to where that was last, and on by half the
// skin.
void list_all_overlap_pairs(World& w) {
  const std::vector<std::uint8_t> all(static_cast<std::size_t>(w.elements.base) + 1, 1);
  std::vector<geometry::Box3> box(static_cast<std::size_t>(w.elements.count));
  for (std::int32_t e = 0; e < w.elements.count; ++e) box[static_cast<std::size_t>(e)] = box_of(w, e);
  geometry::UniformGrid grid;
  grid.build(box);
  const double travel = 2.0 * w.travel.skin();
  take_pairs(w, list_pairs({w, all, grid, travel, travel}));
}

}  // namespace voussoir::solver
