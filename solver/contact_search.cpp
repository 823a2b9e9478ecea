// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "solver/contact_forces.h"
#include "solver/patch_order.h"

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

/// As it stood at the last search of all.
Body body_then(const World& w, std::int32_t e) {
  const auto i = static_cast<std::size_t>(e);
  const Contacts& c = w.contacts;
  return {w.elements.body[i].ref + Vec3{c.at_ux[i], c.at_uy[i], c.at_uz[i]}, rotation({c.at_qw[i], c.at_qx[i], c.at_qy[i], c.at_qz[i]})};
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

/// Candidates of patches, patch by patch.
struct Found {
  std::vector<std::int32_t> patch;
  std::vector<std::int32_t> element;
  std::vector<double> gap;  // m
};

/// How far a search looks [m]: pairs with a smaller gap are candidates; elements have moved by no more since the grid was made.
struct Reach {
  double gap = 0.0, moved = 0.0;
};

/// Elements near another one, as they stand.
struct Neighbours {
  std::vector<std::int32_t> element;
  std::vector<Body> body;
  std::vector<geometry::Box3> box;
};

void find_neighbours(const World& w, std::int32_t e, const geometry::Box3& box, const Reach& reach, Neighbours& near) {
  near.element.clear(), near.body.clear(), near.box.clear();
  const double d = reach.gap + reach.moved;
  const Vec3 wide{d, d, d};
  w.contacts.grid.query({box.low - wide, box.high + wide}, near.element);
  const auto is_fixed = [&](std::int32_t k) { return w.elements.fixed[static_cast<std::size_t>(k)] != 0; };
  std::erase_if(near.element, [&](std::int32_t other) { return other == e || (is_fixed(e) && is_fixed(other)); });
  for (const std::int32_t other : near.element) {
    near.body.push_back(body(w, other));
    near.box.push_back(element_box(w, other, near.body.back()));
  }
}

/// Candidates of some patches of one element.
void search_element(const World& w, std::int32_t e, std::span<const std::int32_t> patches, const Reach& reach, Neighbours& near,
                    Found& found) {
  const Elements& el = w.elements;
  const Body here = body(w, e), base = body(w, el.base);
  const geometry::Box3 box = element_box(w, e, here);
  find_neighbours(w, e, box, reach, near);
  const bool over_base =
      w.has_base && !el.fixed[static_cast<std::size_t>(e)] && box.low.z - reach.gap <= el.body[static_cast<std::size_t>(el.base)].ref.z;
  for (const std::int32_t p : patches) {
    const PlacedPatch patch = placed(w.patches.patch[static_cast<std::size_t>(p)], here);
    const auto consider = [&](std::int32_t other, const Body& b) {
      const double gap = gap_to(w, patch, other, b);
      if (gap >= reach.gap) return;
      found.patch.push_back(p);
      found.element.push_back(other);
      found.gap.push_back(gap);
    };
    for (std::size_t k = 0; k < near.element.size(); ++k) {
      if (overlap(patch.box, near.box[k], reach.gap)) consider(near.element[k], near.body[k]);
    }
    if (over_base) consider(el.base, base);
  }
}

void remember_poses(World& w) {
  Contacts& c = w.contacts;
  const Elements& e = w.elements;
  c.at_ux = e.ux, c.at_uy = e.uy, c.at_uz = e.uz;
  c.at_qw = e.qw, c.at_qx = e.qx, c.at_qy = e.qy, c.at_qz = e.qz;
  c.path.assign(e.ux.size(), 0.0);
}

/// Of an active patch.
std::span<const std::int32_t> candidates_of(const Contacts& c, std::size_t active) {
  const auto first = static_cast<std::size_t>(c.first_slot[active]), last = static_cast<std::size_t>(c.first_slot[active + 1]);
  return {c.element.data() + first, last - first};
}

/// Lets go of partners that are no candidates any more: they are farther away than the skin.
void release_lost(World& w, std::size_t p, std::span<const std::int32_t> candidates) {
  FreePatch& patch = w.patches.patch[p];
  if (patch.touching == 0) return;
  const kernels::ContactPoints q = w.patches.points(static_cast<std::int64_t>(p));
  const int n = w.points.count[static_cast<std::size_t>(patch.set)];
  for (int i = 0; i < n; ++i) {
    const std::int32_t partner = q.partner[i];
    if (partner == kernels::kNobody) continue;
    if (std::ranges::find(candidates, partner) != candidates.end()) continue;
    q.partner[i] = kernels::kNobody;
    q.face[i] = kernels::kNoFace;
    q.set_slip(i, {});
    q.closure(i) = 0.0;
    --patch.touching;
  }
  if (candidates.empty()) patch.stored = 0.0;
}

/// Appends candidates to the slots, each with the way that both bodies have to go before it can be touched.
void append_slots(World& w, const Found& found) {
  Contacts& c = w.contacts;
  for (std::size_t i = 0; i < found.patch.size(); ++i) {
    const auto p = static_cast<std::size_t>(found.patch[i]);
    if (i == 0 || found.patch[i] != found.patch[i - 1]) {
      c.active.push_back(found.patch[i]);
      c.first_slot.push_back(static_cast<std::int64_t>(c.element.size()));
    }
    kernels::Candidate k = candidate_of(w, found.element[i]);
    const auto master = static_cast<std::size_t>(w.patches.patch[p].element), slave = static_cast<std::size_t>(found.element[i]);
    k.until = c.path[master] + c.path[slave] + found.gap[i] - kernels::kRoundOff;
    if (w.patches.patch[p].touching == 0) k.face = kernels::kNoFace;
    c.element.push_back(found.element[i]);
    c.candidate.push_back(k);
  }
}

/// Leaves the first patches of the list with their slots, and opens it for more.
void cut_slots(Contacts& c, std::size_t patches) {
  const std::size_t slots = c.first_slot.empty() ? 0 : static_cast<std::size_t>(c.first_slot[patches]);
  c.active.resize(patches);
  c.first_slot.resize(patches);
  c.element.resize(slots);
  c.candidate.resize(slots);
  c.wrench.resize(slots);
  c.on.resize(slots);
}

void close_slots(Contacts& c) {
  c.first_slot.push_back(static_cast<std::int64_t>(c.element.size()));
  c.wrench.resize(c.element.size());
  c.on.resize(c.element.size(), 0);
  c.searched = static_cast<std::int64_t>(c.active.size());
  c.countdown = 0;
  c.gather_stale = true;
}

/// Patches by element: first entries (count + 1) and the list.
void patches_by_element(const World& w, std::vector<std::int64_t>& first, std::vector<std::int32_t>& list) {
  first.assign(static_cast<std::size_t>(w.elements.count) + 1, 0);
  for (const kernels::Patch& p : w.patches.patch) ++first[static_cast<std::size_t>(p.element) + 1];
  for (std::size_t e = 1; e < first.size(); ++e) first[e] += first[e - 1];
  list.resize(w.patches.patch.size());
  std::vector<std::int64_t> at(first.begin(), first.end() - 1);
  for (std::size_t p = 0; p < list.size(); ++p) {
    list[static_cast<std::size_t>(at[static_cast<std::size_t>(w.patches.patch[p].element)]++)] = static_cast<std::int32_t>(p);
  }
}

}  // namespace

kernels::Candidate candidate_of(const World& w, std::int32_t element) {
  const auto e = static_cast<std::size_t>(element);
  kernels::Candidate c;
  c.element = element, c.first_face = w.elements.first_face[e], c.face_count = w.elements.face_count[e];
  return c;
}

void list_candidates(World& w) {
  Contacts& c = w.contacts;
  c.candidate.clear();
  for (const std::int32_t e : c.element) c.candidate.push_back(candidate_of(w, e));
  c.wrench.assign(c.element.size(), {});
  c.on.assign(c.element.size(), 0);
}

void build_gather(World& w) {
  Contacts& c = w.contacts;
  const auto n = static_cast<std::size_t>(w.elements.count);
  const auto each = [&](auto&& use) {
    for (std::size_t a = 0; a < c.active.size(); ++a) {
      for (std::int64_t slot = c.first_slot[a]; slot < c.first_slot[a + 1]; ++slot) {
        use(static_cast<std::size_t>(c.master[a]), 2 * slot);
        const std::int32_t slave = c.element[static_cast<std::size_t>(slot)];
        if (slave != w.elements.base) use(static_cast<std::size_t>(slave), 2 * slot + 1);
      }
    }
  };
  c.master.resize(c.active.size());
  for (std::size_t a = 0; a < c.active.size(); ++a) c.master[a] = w.patches.patch[static_cast<std::size_t>(c.active[a])].element;
  c.first_gather.assign(n + 1, 0);
  each([&](std::size_t e, std::int64_t) { ++c.first_gather[e + 1]; });
  for (std::size_t e = 0; e < n; ++e) c.first_gather[e + 1] += c.first_gather[e];
  c.gather.resize(static_cast<std::size_t>(c.first_gather[n]));
  std::vector<std::int64_t> at = c.first_gather;
  each([&](std::size_t e, std::int64_t code) { c.gather[static_cast<std::size_t>(at[e]++)] = code; });
  c.gather_stale = false;
}

double measure_moves(World& w, std::int64_t first, std::int64_t last) {
  Contacts& c = w.contacts;
  const Elements& e = w.elements;
  double worst = 0.0;
  for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
    const double dx = e.ux[k] - c.at_ux[k], dy = e.uy[k] - c.at_uy[k], dz = e.uz[k] - c.at_uz[k];
    const double qw = e.qw[k] - c.at_qw[k], qx = e.qx[k] - c.at_qx[k], qy = e.qy[k] - c.at_qy[k], qz = e.qz[k] - c.at_qz[k];
    // A point turns by at most 2 |Δq| r to first order; the square of a sum is at most twice the sum of squares.
    const double turn2 = 4.0 * e.radius[k] * e.radius[k] * (qw * qw + qx * qx + qy * qy + qz * qz);
    const double moved = std::sqrt(2.0 * (dx * dx + dy * dy + dz * dz + 1.1 * turn2));
    worst = moved > worst ? moved : worst;
    const double speed = std::sqrt(e.vx[k] * e.vx[k] + e.vy[k] * e.vy[k] + e.vz[k] * e.vz[k]);
    const double spin = std::sqrt(e.wx[k] * e.wx[k] + e.wy[k] * e.wy[k] + e.wz[k] * e.wz[k]);
    c.path[k] += 1.001 * w.dt * (speed + spin * e.radius[k]);  // and a little for round-off and what `drift` cuts off
  }
  return worst;
}

Search search_due(World& w, double moved) {
  Contacts& c = w.contacts;
  const bool new_ones = c.countdown > 0 && --c.countdown == 0;
  if (c.stale || moved > 0.5 * c.skin) return Search::all;
  return new_ones ? Search::new_patches : Search::none;
}

void place_grid(World& w) {
  std::vector<geometry::Box3> boxes(static_cast<std::size_t>(w.contacts.at_ux.empty() ? 0 : w.elements.count));
  for (std::size_t e = 0; e < boxes.size(); ++e) {
    const auto id = static_cast<std::int32_t>(e);
    boxes[e] = element_box(w, id, body_then(w, id));
  }
  w.contacts.grid.build(boxes);
}

void search_contacts(World& w) {
  Contacts& c = w.contacts;
  sort_patches_if_scattered(w);
  remember_poses(w);
  place_grid(w);
  const std::int32_t n = w.elements.count;
  std::vector<std::int64_t> first;
  std::vector<std::int32_t> list;
  patches_by_element(w, first, list);
  std::vector<Found> found(static_cast<std::size_t>(n));
#pragma omp parallel
  {
    Neighbours near;
#pragma omp for schedule(dynamic, 64)
    for (std::int32_t e = 0; e < n; ++e) {
      const auto i = static_cast<std::size_t>(e);
      const std::span<const std::int32_t> mine(list.data() + first[i], static_cast<std::size_t>(first[i + 1] - first[i]));
      if (!mine.empty()) search_element(w, e, mine, {.gap = c.skin}, near, found[i]);
    }
  }
  cut_slots(c, 0);
  for (const Found& f : found) append_slots(w, f);
  close_slots(c);
  std::vector<std::uint8_t> seen(w.patches.patch.size(), 0);
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    seen[static_cast<std::size_t>(c.active[a])] = 1;
    release_lost(w, static_cast<std::size_t>(c.active[a]), candidates_of(c, a));
  }
  for (std::size_t p = 0; p < seen.size(); ++p) {
    if (!seen[p]) release_lost(w, p, {});
  }
  c.stale = false;
  ++c.searches;
}

void search_new_patches(World& w, double moved) {
  Contacts& c = w.contacts;
  const auto known = static_cast<std::size_t>(c.searched);
  const std::vector<std::int32_t> patches(c.active.begin() + c.searched, c.active.end());
  Neighbours near;
  Found found;
  // Bodies that have moved since the last search of all may go back and as far again before the next.
  const Reach reach{.gap = c.skin + 2.0 * moved, .moved = moved};
  for (const std::int32_t p : patches) {
    search_element(w, w.patches.patch[static_cast<std::size_t>(p)].element, {&p, 1}, reach, near, found);
  }
  cut_slots(c, known);
  append_slots(w, found);
  close_slots(c);
  std::size_t a = known;
  for (const std::int32_t p : patches) {
    const bool listed = a < c.active.size() && c.active[a] == p;
    release_lost(w, static_cast<std::size_t>(p), listed ? candidates_of(c, a++) : std::span<const std::int32_t>{});
  }
}

}  // namespace voussoir::solver
