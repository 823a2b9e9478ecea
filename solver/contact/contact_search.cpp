// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "geometry/nth.h"
#include "solver/contact/contact_forces.h"
#include "solver/contact/contact_lists.h"
#include "solver/contact/near_faces.h"
#include "solver/contact/overlap_contact.h"
#include "solver/contact/placed_element.h"
#include "solver/setup/patch_order.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kElementsAtATime = 64, kPatchesAtATime = 4096, kSearchedAtATime = 16;  // that a thread takes

bool overlap(const geometry::Box3& a, const geometry::Box3& b, double margin) {
  return a.low.x <= b.high.x + margin && b.low.x <= a.high.x + margin && a.low.y <= b.high.y + margin && b.low.y <= a.high.y + margin &&
         a.low.z <= b.high.z + margin && b.low.z <= a.high.z + margin;
}

/// Distance [m] that one face of the element, the best, keeps between it and the whole patch.
double gap_to(const World& w, const PlacedPatch& p, std::int32_t element, const PlacedElement& b) {
  const auto i = static_cast<std::size_t>(element);
  const SeenPatch seen = seen_from(b, p);
  double farthest = -1e300;
  for (std::int32_t f = w.elements.first_face[i]; f < w.elements.first_face[i] + w.elements.face_count[i]; ++f)
    farthest = std::max(farthest, least_distance(nth(w.faces, f), seen));
  return farthest;
}

/// An element in its pose.
struct Here {
  std::int32_t element = 0;
  PlacedElement body;
  geometry::Box3 box;
};

/// One search: what it looks for, and how far.
struct SearchPass {
  const World& w;
  [[nodiscard]] const SearchRoom& room() const { return w.contacts.room; }
  [[nodiscard]] bool is_re_searched(std::int32_t e) const { return nth(room().re_search.element, e) != 0; }
  [[nodiscard]] bool is_re_searched_patch(std::int32_t p) const { return nth(room().re_search.patch, p) != 0; }

  /// How far an element can go from here [m] before it is searched again: one that is searched now by its reach; one that was searched
  /// before may come back from where it has moved, and go by its reach from there.
  [[nodiscard]] double way_of(std::int32_t e) const { return is_re_searched(e) ? 0.0 : nth(room().moved, e); }
  /// Gap [m] within which patches of `e`, or patches that touch it, are listed with another element: they may meet before one of the two is
  /// searched again.
  [[nodiscard]] double gap_of(std::int32_t e, std::int32_t other) const {
    return (w.travel.reach(e) + w.travel.reach(other)) + (way_of(e) + nth(room().moved, other));
  }
};

Vec3 alike(double v) { return {v, v, v}; }

/// The box in the grid of an element that had this box when it was searched: it reaches as far as the element goes, and as far again as it
/// has moved meanwhile; one that has moved by more than half its reach is searched again.
geometry::Box3 grid_box(const World& w, std::int32_t e, const geometry::Box3& box) {
  const Vec3 wide = alike(2.0 * w.travel.reach(e));
  return {box.low - wide, box.high + wide};
}

/// Elements whose boxes are as near as a patch of one and the other have to be.
/// \param near  room for them
void find_neighbours(const SearchPass& t, const Here& here, std::vector<std::int32_t>& near) {
  const World& w = t.w;
  near.clear();
  const double beyond = w.patches.beyond + kernels::kRoundOff;
  const Vec3 wide = alike(w.travel.reach(here.element) + t.way_of(here.element) + beyond);
  w.contacts.grid.query({here.box.low - wide, here.box.high + wide}, near);
  const auto is_fixed = [&](std::int32_t k) { return nth(w.elements.fixed, k) != 0; };
  std::erase_if(near, [&](std::int32_t other) {
    return other == here.element || (is_fixed(here.element) && is_fixed(other)) ||
           !overlap(here.box, nth(t.room().box, other), t.gap_of(here.element, other) + beyond);
  });
}

/// Gap [m] between the patch and the element if it is less than that, else nothing.
std::optional<double> gap_within(const SearchPass& t, const PlacedPatch& patch, const Here& other, double gap_at_most) {
  if (other.element != t.w.elements.base && !overlap(patch.box, other.box, gap_at_most)) return std::nullopt;
  const double gap = gap_to(t.w, patch, other.element, other.body);
  return gap < gap_at_most ? std::optional(gap) : std::nullopt;
}

/// As new, with the travel of both bodies before they can touch.
kernels::Candidate candidate_at(const World& w, std::int32_t patch, std::int32_t element, double gap) {
  kernels::Candidate k = candidate_of(w, element);
  const std::int32_t master = nth(w.patches.element, patch);
  k.safe = w.travel.bound(master) + w.travel.bound(element) + gap - kernels::kRoundOff;
  return k;
}

/// Candidates of the patches of an element that is searched again.
void search_own_patches(const SearchPass& t, const Here& here, std::span<const Here> near, SearchRoom& room, FoundPairs& found) {
  const World& w = t.w;
  const Elements& el = w.elements;
  const bool over_base =
      w.has_base && !nth(el.fixed, here.element) && here.box.low.z - t.gap_of(here.element, el.base) <= nth(el.body, el.base).ref.z;
  for (auto p = room.patches.begin_of(here.element); p != room.patches.end_of(here.element); ++p) {
    if (!t.is_re_searched_patch(*p)) continue;
    std::int32_t count = 0;
    const PlacedPatch patch = placed(nth(w.patches.patch, *p), here.body);
    const auto consider = [&](const Here& other) {
      const std::optional<double> apart = gap_within(t, patch, other, t.gap_of(here.element, other.element));
      if (apart) found.add(*p, count++, candidate_at(w, *p, other.element, *apart));
    };
    for (const Here& other : near) consider(other);
    if (over_base) consider({el.base, placed_element(w, el.base), {}});
    nth(room.candidates, *p) = count;
  }
}

/// Patches of its neighbours that are not searched again themselves, against the element.
void search_patches_around(const SearchPass& t, const Here& here, std::span<const Here> near, FoundPairs& found) {
  const World& w = t.w;
  for (const Here& other : near) {
    if (t.is_re_searched(other.element)) continue;
    const PatchesOfElements& patches = t.room().patches;
    const double gap = t.gap_of(here.element, other.element);
    for (auto p = patches.begin_of(other.element); p != patches.end_of(other.element); ++p) {
      if (t.is_re_searched_patch(*p)) continue;
      const std::optional<double> apart = gap_within(t, placed(nth(w.patches.patch, *p), other.body), here, gap);
      if (apart) found.add(*p, 0, candidate_at(w, *p, here.element, *apart));
    }
  }
}

Here here(const World& w, std::int32_t e) { return {e, placed_element(w, e), nth(w.contacts.room.box, e)}; }

/// Room of a thread for the neighbours of one element.
struct Neighbours {
  std::vector<std::int32_t> element;
  std::vector<Here> body;
};

void search_element(const SearchPass& t, std::int32_t e, SearchRoom& room, Neighbours& near, SearchOfThread& mine) {
  const Here at = here(t.w, e);
  find_neighbours(t, at, near.element);
  near.body.clear();
  for (const std::int32_t other : near.element) near.body.push_back(here(t.w, other));
  search_own_patches(t, at, near.body, room, mine.own);
  if (!t.is_re_searched(e)) return;
  search_patches_around(t, at, near.body, mine.around);
  list_overlaps_of(
      t.w, e, near.element, [&](std::int32_t other) { return t.gap_of(e, other); }, mine.overlaps);
}

/// Patches of every element, where there are others than at the last search.
void list_patches(const World& w, PatchesOfElements& r) {
  const std::vector<std::int32_t>& element = w.patches.element;
  if (r.list.size() == element.size() && !r.first.empty()) return;
  r.first.assign(static_cast<std::size_t>(w.elements.count) + 1, 0);
  for (const std::int32_t e : element) ++r.first[static_cast<std::size_t>(e) + 1];
  for (std::size_t e = 1; e < r.first.size(); ++e) r.first[e] += r.first[e - 1];
  r.list.resize(element.size());
  std::vector<std::int32_t> at(r.first.begin(), r.first.end() - 1);
  for (std::size_t p = 0; p < element.size(); ++p) {
    nth(r.list, nth(at, element[p])++) = static_cast<std::int32_t>(p);
  }
}

/// Marks elements that have moved by more than a share of their reach: they count as searched from here on.
void mark_moved(World& w, double share) {
  SearchRoom& room = w.contacts.room;
  const auto mark = [&](std::int32_t e, double& most) {
    const auto i = static_cast<std::size_t>(e);
    const double m = w.travel.displacement(w.elements, e);
    const bool again = m > share * w.travel.reach(e);
    room.re_search.element[i] = room.looked_at[i] = again ? 1 : 0;
    room.box[i] = box_of(w, e, placed_element(w, e));
    room.moved[i] = again ? 0.0 : m;
    if (again) w.travel.remember(w.elements, e);
    most = std::max(most, room.moved[i]);
  };
  w.team.share_out(w.elements.count, kElementsAtATime, [&](std::int64_t first, std::int64_t last, int thread) {
    double& moved = nth(room.by_thread, thread).moved;
    for (std::int64_t e = first; e < last; ++e) mark(static_cast<std::int32_t>(e), moved);
  });
  if (w.travel.looks_ahead()) return;
  // Where reaches are alike, the most that any has moved serves for all: results of one rate depend on the pairs listed so.
  double most = 0.0;
  for (const SearchOfThread& t : room.by_thread) most = std::max(most, t.moved);
  std::ranges::fill(room.moved, most);
}

/// Patches that came after the last search.
void mark_new_patches(World& w) {
  const Contacts& c = w.contacts;
  SearchRoom& room = w.contacts.room;
  for (auto a = static_cast<std::size_t>(c.searched); a < c.active.size(); ++a) {
    const auto p = static_cast<std::size_t>(c.active[a]);
    room.re_search.patch[p] = 1;
    nth(room.looked_at, w.patches.element[p]) = 1;
  }
}

/// Has the grid hold the elements as they stood when they were searched last, the marked ones as they stand.
void place_in_grid(World& w) {
  Contacts& c = w.contacts;
  SearchRoom& room = c.room;
  if (!room.stale) {
    for (std::int32_t e = 0; e < w.elements.count; ++e) {
      if (nth(room.re_search.element, e) != 0) c.grid.move(e, grid_box(w, e, nth(room.box, e)));
    }
    return;
  }
  std::vector<geometry::Box3> box = room.box;
  for (std::int32_t e = 0; e < w.elements.count; ++e) {
    const auto i = static_cast<std::size_t>(e);
    if (room.re_search.element[i] == 0) box[i] = box_of(w, e, placed_then(w, e));
    box[i] = grid_box(w, e, box[i]);
  }
  c.grid.build(box);
  room.stale = false;
}

void begin_search(World& w) {
  SearchRoom& room = w.contacts.room;
  const auto elements = static_cast<std::size_t>(w.elements.base) + 1;
  room.re_search.element.resize(elements), room.looked_at.resize(elements), room.box.resize(static_cast<std::size_t>(w.elements.count));
  room.moved.resize(elements);
  room.re_search.patch.assign(w.patches.patch.size(), 0);
  room.candidates.assign(w.patches.patch.size(), 0);
  if (const auto threads = static_cast<std::size_t>(w.team.size()); room.by_thread.size() < threads) room.by_thread.resize(threads);
  for (SearchOfThread& t : room.by_thread) t.own.clear(), t.around.clear(), t.overlaps.clear(), t.moved = 0.0;
  list_patches(w, room.patches);
}

/// Elements that are searched again, or whose patches are.
void list_elements(SearchRoom& room, std::int32_t count) {
  room.elements.clear();
  for (std::int32_t e = 0; e < count; ++e) {
    if (nth(room.looked_at, e) != 0) room.elements.push_back(e);
  }
  room.found.resize(room.elements.size());
}

/// \param share  of its reach by which an element has moved since its last search if it is to be searched again; below 0: all are
void search(World& w, double share) {
  Contacts& c = w.contacts;
  SearchRoom& room = c.room;
  begin_search(w);
  mark_moved(w, share);
  mark_new_patches(w);
  place_in_grid(w);
  list_elements(room, w.elements.count);
  const SearchPass pass{w};
  w.team.share_out(static_cast<std::int64_t>(room.re_search.patch.size()), kPatchesAtATime, [&](std::int64_t first, std::int64_t last) {
    for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p)
      room.re_search.patch[p] |= nth(room.re_search.element, w.patches.element[p]);
  });
  w.team.share_out(static_cast<std::int64_t>(room.elements.size()), kSearchedAtATime,
                   [&](std::int64_t first, std::int64_t last, int thread) {
                     SearchOfThread& mine = nth(room.by_thread, thread);
                     Neighbours near;
                     for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
                       const std::size_t before = mine.around.size();
                       search_element(pass, room.elements[k], room, near, mine);
                       room.found[k] = {thread, before, mine.around.size()};
                     }
                   });
  replace_candidates(w);
  replace_overlap_pairs(w);
  bound_dashpots_by_near_faces(w, &room.changed);
  ++c.searches;
}

}  // namespace

void search_all(World& w) {
  Contacts& c = w.contacts;
  c.active.clear(), c.first_slot.clear();  // nothing of them stays, and sorting gives the patches other numbers
  c.searched = 0;
  c.room.stale = true;
  if (patches_lie_apart(w)) sort_patches(w);
  w.travel.remember_all(w.elements);
  search(w, -1.0);
  w.travel.set_searched();
}

void search_contacts(World& w) {
  if (!w.travel.is_searched() || patches_lie_apart(w)) return search_all(w);
  // Not only those for which it is time: others would be due a few steps later.
  search(w, 0.5);
}

}  // namespace voussoir::solver
