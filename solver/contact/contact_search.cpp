// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "solver/contact/contact_forces.h"
#include "solver/contact/contact_lists.h"
#include "solver/contact/overlap_contact.h"
#include "solver/setup/patch_order.h"

namespace voussoir::solver {

namespace {

struct Body {
  Vec3 x;  // centroid
  Mat3 r;  // orientation
};

Body body(const World& w, std::int32_t e) {
  const auto i = static_cast<std::size_t>(e);
  const kernels::Pose p = kernels::load_pose(w.elements.pose.data(), e);
  return {w.elements.body[i].ref + p.u, Mat3{} + p.d};
}

/// As it stood when it was searched last.
Body body_then(const World& w, std::int32_t e) {
  const Travel::Pose p = w.travel.searched_pose(e);
  return {w.elements.body[static_cast<std::size_t>(e)].ref + p.u, p.r};
}

Vec3 absolute(Vec3 v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// Box round an element in that pose.
geometry::Box3 element_box(const World& w, std::int32_t e, const Body& b) {
  const auto i = static_cast<std::size_t>(e);
  const Vec3 h{w.elements.half_x[i], w.elements.half_y[i], w.elements.half_z[i]};
  const Vec3 half{dot(absolute(b.r.r0), h), dot(absolute(b.r.r1), h), dot(absolute(b.r.r2), h)};
  return {b.x - half, b.x + half};
}

bool overlap(const geometry::Box3& a, const geometry::Box3& b, double margin) {
  return a.low.x <= b.high.x + margin && b.low.x <= a.high.x + margin && a.low.y <= b.high.y + margin && b.low.y <= a.high.y + margin &&
         a.low.z <= b.high.z + margin && b.low.z <= a.high.z + margin;
}

/// A patch in its current pose.
struct PlacedPatch {
  Vec3 centre, es, et;  // of its rectangle; half edges
  geometry::Box3 box;
};
PlacedPatch placed(const kernels::Patch& k, const Body& b) {
  const Vec3 middle = k.centre + 0.5 * (k.s_low + k.s_high) * k.es + 0.5 * (k.t_low + k.t_high) * k.et;
  PlacedPatch r;
  r.centre = b.x + b.r * middle;
  r.es = 0.5 * (k.s_high - k.s_low) * (b.r * k.es);
  r.et = 0.5 * (k.t_high - k.t_low) * (b.r * k.et);
  const Vec3 half = absolute(r.es) + absolute(r.et);
  r.box = {r.centre - half, r.centre + half};
  return r;
}

/// Distance [m] that one face of the element, the best, keeps between it and the whole patch.
double gap_to(const World& w, const PlacedPatch& p, std::int32_t element, const Body& b) {
  const auto i = static_cast<std::size_t>(element);
  const Mat3 back = transposed(b.r);
  const Vec3 centre = back * (p.centre - b.x), es = back * p.es, et = back * p.et;
  double farthest = -1e300;
  for (std::int32_t f = w.elements.first_face[i]; f < w.elements.first_face[i] + w.elements.face_count[i]; ++f) {
    const kernels::Face& face = w.faces[static_cast<std::size_t>(f)];
    const double reach = std::abs(dot(face.normal, es)) + std::abs(dot(face.normal, et));
    farthest = std::max(farthest, dot(face.normal, centre) - face.distance - reach);
  }
  return farthest;
}

/// Elements near another one, as they stand.
struct Neighbours {
  std::vector<std::int32_t> element;
  std::vector<Body> body;
  std::vector<geometry::Box3> box;
};

/// \param reach  m, from its box to where the grid has another one
void find_neighbours(const World& w, std::int32_t e, const geometry::Box3& box, double reach, Neighbours& near) {
  near.element.clear(), near.body.clear(), near.box.clear();
  const Vec3 wide{reach, reach, reach};
  w.contacts.grid.query({box.low - wide, box.high + wide}, near.element);
  const auto is_fixed = [&](std::int32_t k) { return w.elements.fixed[static_cast<std::size_t>(k)] != 0; };
  std::erase_if(near.element, [&](std::int32_t other) { return other == e || (is_fixed(e) && is_fixed(other)); });
  for (const std::int32_t other : near.element) {
    near.body.push_back(body(w, other));
    near.box.push_back(element_box(w, other, near.body.back()));
  }
}

/// Patches of every element.
struct PatchesOfElements {
  std::vector<std::int64_t> first;
  std::vector<std::int32_t> list;
  [[nodiscard]] std::span<const std::int32_t> of(std::int32_t e) const {
    const auto i = static_cast<std::size_t>(e);
    return {list.data() + first[i], static_cast<std::size_t>(first[i + 1] - first[i])};
  }
};

PatchesOfElements patches_of_elements(const World& w) {
  PatchesOfElements r;
  r.first.assign(static_cast<std::size_t>(w.elements.count) + 1, 0);
  for (const FreePatch& p : w.patches.patch) ++r.first[static_cast<std::size_t>(p.element) + 1];
  for (std::size_t e = 1; e < r.first.size(); ++e) r.first[e] += r.first[e - 1];
  r.list.resize(w.patches.patch.size());
  std::vector<std::int64_t> at(r.first.begin(), r.first.end() - 1);
  for (std::size_t p = 0; p < r.list.size(); ++p) {
    r.list[static_cast<std::size_t>(at[static_cast<std::size_t>(w.patches.patch[p].element)]++)] = static_cast<std::int32_t>(p);
  }
  return r;
}

/// One search: what it looks for, and how far.
struct SearchPass {
  const World& w;
  const ReSearch& re_search;
  const PatchesOfElements& patches;
  double skin = 0.0, moved = 0.0;  // m; that elements which are not searched again have moved at most since they were searched
  [[nodiscard]] bool is_re_searched(std::int32_t e) const { return re_search.element[static_cast<std::size_t>(e)] != 0; }
};

void consider(const World& w, std::int32_t p, const PlacedPatch& patch, std::int32_t element, const Body& b, double gap_at_most,
              Found& found) {
  const double gap = gap_to(w, patch, element, b);
  if (gap >= gap_at_most) return;
  found.patch.push_back(p);
  found.element.push_back(element);
  found.gap.push_back(gap);
}

/// An element in its pose.
struct Here {
  std::int32_t element = 0;
  Body body;
  geometry::Box3 box;
};

/// Candidates of the patches of an element that is searched again.
void search_own_patches(const SearchPass& t, const Here& here, const Neighbours& near, double gap, Found& found) {
  const World& w = t.w;
  const Elements& el = w.elements;
  const bool over_base = w.has_base && !el.fixed[static_cast<std::size_t>(here.element)] &&
                         here.box.low.z - gap <= el.body[static_cast<std::size_t>(el.base)].ref.z;
  for (const std::int32_t p : t.patches.of(here.element)) {
    if (t.re_search.patch[static_cast<std::size_t>(p)] == 0) continue;
    const PlacedPatch patch = placed(w.patches.patch[static_cast<std::size_t>(p)], here.body);
    for (std::size_t k = 0; k < near.element.size(); ++k) {
      if (overlap(patch.box, near.box[k], gap)) consider(w, p, patch, near.element[k], near.body[k], gap, found);
    }
    if (over_base) consider(w, p, patch, el.base, body(w, el.base), gap, found);
  }
}

/// Patches of its neighbours that are not searched again themselves, against the element.
void search_patches_around(const SearchPass& t, const Here& here, const Neighbours& near, double gap, Found& found) {
  const World& w = t.w;
  for (std::size_t k = 0; k < near.element.size(); ++k) {
    if (t.is_re_searched(near.element[k])) continue;
    for (const std::int32_t p : t.patches.of(near.element[k])) {
      if (t.re_search.patch[static_cast<std::size_t>(p)] != 0) continue;
      const PlacedPatch patch = placed(w.patches.patch[static_cast<std::size_t>(p)], near.body[k]);
      if (overlap(patch.box, here.box, gap)) consider(w, p, patch, here.element, here.body, gap, found);
    }
  }
}

/// A pair stays listed until one of its two is searched again, when it has moved by half the skin at most from where it was searched last.
/// One that is searched now goes by half the skin from here; one that was searched before may come back from where it has moved, and go by
/// half the skin from there.
void search_element(const SearchPass& t, std::int32_t e, Neighbours& near, Found& found) {
  const bool again = t.is_re_searched(e);
  const Body b = body(t.w, e);
  const Here here{e, b, element_box(t.w, e, b)};
  const double gap = t.skin + (again ? 1.0 : 2.0) * t.moved;
  find_neighbours(t.w, e, here.box, gap + t.moved, near);
  search_own_patches(t, here, near, gap, found);
  if (again) search_patches_around(t, here, near, gap, found);
}

/// Elements that are searched again, or whose patches are.
std::vector<std::int32_t> elements_of(const World& w, const ReSearch& re_search) {
  std::vector<std::uint8_t> wanted = re_search.element;
  for (std::size_t p = 0; p < re_search.patch.size(); ++p) {
    if (re_search.patch[p] != 0) wanted[static_cast<std::size_t>(w.patches.patch[p].element)] = 1;
  }
  std::vector<std::int32_t> list;
  for (std::int32_t e = 0; e < w.elements.count; ++e) {
    if (wanted[static_cast<std::size_t>(e)] != 0) list.push_back(e);
  }
  return list;
}

/// Fills the grid with the elements as they stood when they were searched last.
void place_grid(World& w) {
  std::vector<geometry::Box3> boxes(static_cast<std::size_t>(w.elements.count));
  for (std::size_t e = 0; e < boxes.size(); ++e) {
    const auto id = static_cast<std::int32_t>(e);
    boxes[e] = element_box(w, id, body_then(w, id));
  }
  w.contacts.grid.build(boxes);
}

/// \param moved  m, that elements which are not searched again have moved at most since they were searched
void search(World& w, const ReSearch& re_search, double moved) {
  place_grid(w);
  const PatchesOfElements patches = patches_of_elements(w);
  const SearchPass pass{w, re_search, patches, w.travel.skin(), moved};
  const std::vector<std::int32_t> elements = elements_of(w, re_search);
  std::vector<Found> found(elements.size());
#pragma omp parallel num_threads(w.threads)
  {
    Neighbours near;
#pragma omp for schedule(dynamic, 64)
    for (std::size_t k = 0; k < elements.size(); ++k) search_element(pass, elements[k], near, found[k]);
  }
  replace_candidates(w, re_search, found);
  list_overlap_pairs(w, re_search.element, moved);
  ++w.contacts.searches;
}

/// Patches that came after the last search.
void mark_new_patches(const Contacts& c, ReSearch& re_search) {
  for (auto a = static_cast<std::size_t>(c.searched); a < c.active.size(); ++a) re_search.patch[static_cast<std::size_t>(c.active[a])] = 1;
}

/// Elements that have moved farther than that, and their patches. Returns how far the others have moved at most [m].
double mark_moved(World& w, double farther_than, ReSearch& re_search) {
  double moved = 0.0;
  for (std::size_t e = 0; e < static_cast<std::size_t>(w.elements.count); ++e) {
    const double m = w.travel.displacement(w.elements, static_cast<std::int32_t>(e));
    re_search.element[e] = m > farther_than ? 1 : 0;
    if (re_search.element[e] == 0) moved = std::max(moved, m);
  }
  for (std::size_t p = 0; p < re_search.patch.size(); ++p)
    re_search.patch[p] |= re_search.element[static_cast<std::size_t>(w.patches.patch[p].element)];
  return moved;
}

}  // namespace

void search_all(World& w) {
  Contacts& c = w.contacts;
  c.active.clear(), c.first_slot.clear();  // nothing of them stays, and sorting gives the patches other numbers
  if (patches_lie_apart(w)) sort_patches(w);
  w.travel.remember_all(w.elements);
  ReSearch re_search{std::vector<std::uint8_t>(static_cast<std::size_t>(w.elements.base) + 1, 1),
                     std::vector<std::uint8_t>(w.patches.patch.size(), 1)};
  search(w, re_search, 0.0);
  w.travel.set_searched();
}

void search_contacts(World& w) {
  Contacts& c = w.contacts;
  if (!w.travel.is_searched() || patches_lie_apart(w)) return search_all(w);
  ReSearch re_search{std::vector<std::uint8_t>(static_cast<std::size_t>(w.elements.base) + 1, 0),
                     std::vector<std::uint8_t>(w.patches.patch.size(), 0)};
  mark_new_patches(c, re_search);
  // Not only those for which it is time: others would be due a few steps later.
  const double moved = mark_moved(w, 0.25 * w.travel.skin(), re_search);
  for (std::int32_t e = 0; e < w.elements.count; ++e) {
    if (re_search.element[static_cast<std::size_t>(e)] != 0) w.travel.remember(w.elements, e);
  }
  search(w, re_search, moved);
}

}  // namespace voussoir::solver
