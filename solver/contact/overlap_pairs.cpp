// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/nth.h"
#include "solver/contact/overlap_contact.h"
#include "solver/contact/placed_element.h"

namespace voussoir::solver {

namespace {

double largest(Vec3 v) { return std::max({v.x, v.y, v.z}); }

/// m; the two overlap by no more than this: along the axes of the boxes round them that turn with them. For two bricks it is the least
/// overlap along the normals of their faces, so only pairs that need crossed edges to be told apart are looked at by more than this.
double overlap_at_most(const World& w, std::int32_t a, std::int32_t b) {
  const PlacedElement at_a = placed_element(w, a), at_b = placed_element(w, b);
  if (b == w.elements.base) return at_b.x.z - box_of(w, a, at_a).low.z;
  const Mat3 ra = transposed(at_a.r), rb = transposed(at_b.r);  // rows: the axes of the boxes
  const Vec3 ha = half_extents(w, a), hb = half_extents(w, b), apart = at_b.x - at_a.x;
  const Mat3 cosines{absolute(rb * ra.r0), absolute(rb * ra.r1), absolute(rb * ra.r2)};  // of axes of a, by row, with those of b
  const Vec3 along_a = absolute(ra * apart), along_b = absolute(rb * apart);
  const double gap_a = largest(along_a - ha - cosines * hb), gap_b = largest(along_b - hb - transposed(cosines) * ha);
  return -std::max(gap_a, gap_b);
}

/// Adds the pair unless its bodies cannot come to overlap by more than is allowed before one of them is listed again.
void consider(const World& w, std::int32_t a, std::int32_t b, double travel, std::vector<OverlapPair>& pairs) {
  const double spare = allowed_overlap(w, a, b) - overlap_at_most(w, a, b);
  if (spare < travel) pairs.push_back({a, b, w.travel.bound(a) + w.travel.bound(b) + spare - kernels::kRoundOff});
}

bool is_fixed(const World& w, std::int32_t e) { return nth(w.elements.fixed, e) != 0; }

/// A pair needs the travel bounds and the velocity rows of both elements.
void activate(World& w, std::span<const OverlapPair> pairs) {
  for (const OverlapPair& p : pairs) {
    w.travel.activate(w.elements, p.a);
    if (p.b != w.elements.base) w.travel.activate(w.elements, p.b);
  }
}

}  // namespace

void list_overlaps_of(const World& w, std::int32_t element, std::span<const std::int32_t> near, const GapOf& gap_of,
                      std::vector<OverlapPair>& pairs) {
  const std::vector<std::uint8_t>& again = w.contacts.room.re_search.element;
  for (const std::int32_t other : near) {
    if (nth(again, other) != 0 && other < element) continue;
    consider(w, std::min(element, other), std::max(element, other), gap_of(other), pairs);
  }
  if (w.has_base && !is_fixed(w, element)) consider(w, element, w.elements.base, gap_of(w.elements.base), pairs);
}

// Found ones by their first elements, by counting, then those that stay between them.
void replace_overlap_pairs(World& w) {
  SearchRoom& room = w.contacts.room;
  std::vector<OverlapPair>&found = room.overlaps_found, &before = room.overlaps_before;
  room.first_overlap.assign(static_cast<std::size_t>(w.elements.count) + 1, 0);
  std::size_t count = 0;
  for (const SearchOfThread& t : room.by_thread) {
    for (const OverlapPair& p : t.overlaps) ++room.first_overlap[static_cast<std::size_t>(p.a) + 1];
    count += t.overlaps.size();
    activate(w, t.overlaps);
  }
  std::partial_sum(room.first_overlap.begin(), room.first_overlap.end(), room.first_overlap.begin());
  found.resize(count);
  std::vector<std::int32_t> at(room.first_overlap.begin(), room.first_overlap.end() - 1);
  for (const SearchOfThread& t : room.by_thread) {
    for (const OverlapPair& p : t.overlaps) nth(found, nth(at, p.a)++) = p;
  }
  std::swap(w.overlaps.pairs, before);
  std::vector<OverlapPair>& pairs = w.overlaps.pairs;
  pairs.clear();
  const auto is_kept = [&](const OverlapPair& p) { return nth(room.re_search.element, p.a) == 0 && nth(room.re_search.element, p.b) == 0; };
  auto old = before.begin();
  for (std::int32_t a = 0; a < w.elements.count; ++a) {
    const auto first = pairs.size();
    for (; old != before.end() && old->a == a; ++old) {
      if (is_kept(*old)) pairs.push_back(*old);
    }
    const auto i = static_cast<std::size_t>(a);
    if (room.first_overlap[i] == room.first_overlap[i + 1]) continue;
    pairs.insert(pairs.end(), found.begin() + room.first_overlap[i], found.begin() + room.first_overlap[i + 1]);
    std::ranges::sort(pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end(), {}, &OverlapPair::b);
  }
  list_overlap_levels(w);
}

void use_restored_overlap_pairs(World& w) {
  activate(w, w.overlaps.pairs);
  list_overlap_levels(w);
}

}  // namespace voussoir::solver
