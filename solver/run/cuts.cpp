// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/cuts.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"
#include "solver/ties/tie_forces.h"

namespace voussoir::solver {
namespace {

/// Force on an element, and torque about its centroid.
struct OnElement {
  Vec3 force, torque;
};

/// Adds to a cut what `behind` gets from `before`, from whichever of the two is no base.
void add(const World& w, Vec3 about, std::int32_t behind, const OnElement& on_behind, std::int32_t before, const OnElement& on_before,
         CutSample& to) {
  const bool by_other = behind == w.elements.base;
  const auto i = static_cast<std::size_t>(by_other ? before : behind);
  const OnElement& on = by_other ? on_before : on_behind;
  const Vec3 x = w.elements.body[i].ref + Vec3{w.elements.ux[i], w.elements.uy[i], w.elements.uz[i]};
  const Vec3 moment = cross(x - about, on.force) + on.torque;
  to.force += by_other ? -on.force : on.force;
  to.moment += by_other ? -moment : moment;
}

bool inside(const std::array<Vec3, 2>& box, Vec3 p) {
  return p.x >= box[0].x && p.x <= box[1].x && p.y >= box[0].y && p.y <= box[1].y && p.z >= box[0].z && p.z <= box[1].z;
}

}  // namespace

/// 1: a lies behind and b before; −1: the other way round; 0: the cut does not part them.
int Cuts::crosses(const World& w, const cases::Cut& cut, std::int32_t a, std::int32_t b) {
  const auto at = [&](std::int32_t e, std::int32_t other) {
    Vec3 p = nth(w.elements.body, e == w.elements.base ? other : e).ref;
    if (e == w.elements.base) p.z = nth(w.elements.body, e).ref.z;
    return p;
  };
  const Vec3 at_a = at(a, b), at_b = at(b, a);
  const bool a_before = dot(cut.normal, at_a - cut.point) > 0.0, b_before = dot(cut.normal, at_b - cut.point) > 0.0;
  if (a_before == b_before) return 0;
  if (cut.box && !inside(*cut.box, 0.5 * (at_a + at_b))) return 0;
  return b_before ? 1 : -1;
}

void Cuts::find_ties(const World& w, Plane& plane) {
  const cases::Cut& cut = plane.cut;
  for (const Ties::Tie& t : w.ties.tie) {
    std::vector<std::int32_t> behind;
    Vec3 middle;
    for (std::int32_t k = t.first_hold; k < t.last_hold; ++k) {
      const Ties::Hold& h = nth(w.ties.hold, k);
      const Vec3 centroid = nth(w.elements.body, h.element).ref, point = centroid + h.arm;
      middle += 0.5 * std::abs(h.share) * point;
      if (dot(cut.normal, (h.element == w.elements.base ? point : centroid) - cut.point) <= 0.0) behind.push_back(k);
    }
    if (std::ssize(behind) == t.last_hold - t.first_hold || (cut.box && !inside(*cut.box, middle))) continue;
    plane.tie_holds.insert(plane.tie_holds.end(), behind.begin(), behind.end());
  }
}

Cuts::Cuts(const World& w, std::span<const cases::Cut> cuts) {
  const Sides& s = w.sides;
  for (const cases::Cut& cut : cuts) {
    Plane& plane = cuts_.emplace_back();
    plane.cut = cut;
    find_ties(w, plane);
    for (std::int64_t id = 0; id < s.count(); ++id) {
      if (nth(s.joint, id) < 0) continue;
      const kernels::SideBlock& block = nth(s.blocks, id / kernels::kLanes);
      const std::int32_t master = block.master[id % kernels::kLanes], slave = block.slave[id % kernels::kLanes];
      const int way = crosses(w, cut, master, slave);
      if (way != 0) plane.crossings.push_back({id, way > 0 ? master : slave, way > 0 ? slave : master});
    }
    if (plane.crossings.empty()) {
      throw cases::InputError(cases::indexed_key("output.cut", cuts_.size() - 1, ""),
                              cases::quoted(cut.name) + " cuts no joint: no two elements that touch have it between their centroids" +
                                  (cut.box ? ", with the middle in its box" : ""));
    }
  }
}

void Cuts::measure(const World& w, std::vector<CutSample>& out) const {
  out.assign(cuts_.size(), {});
  const Sides& s = w.sides;
  const auto vec = [](const double* v) { return Vec3{v[0], v[1], v[2]}; };
  for (std::size_t k = 0; k < cuts_.size(); ++k) {
    const cases::Cut& cut = cuts_[k].cut;
    for (const Crossing& c : cuts_[k].crossings) {
      if (nth(s.pair_on, c.side) == 0) continue;
      const double* pair = s.pair_wrench.data() + c.side * kernels::kPairStride;
      const std::int32_t master = nth(s.blocks, c.side / kernels::kLanes).master[c.side % kernels::kLanes];
      OnElement behind{vec(pair), vec(pair + 3)}, before{vec(pair + 6), vec(pair + 9)};
      if (c.behind != master) std::swap(behind, before);
      add(w, cut.point, c.behind, behind, c.before, before, out[k]);
    }
    const auto pair = [&](std::int32_t a, std::int32_t b, const kernels::PairWrench& p) {
      const int way = crosses(w, cut, a, b);
      if (way == 0) return;
      OnElement behind{p.force, p.torque_a}, before{-p.force, p.torque_b};
      if (way < 0) std::swap(behind, before);
      add(w, cut.point, way > 0 ? a : b, behind, way > 0 ? b : a, before, out[k]);
    };
    const Contacts& c = w.contacts;
    for (std::size_t a = 0; a < c.active.size(); ++a) {
      for (std::int64_t slot = c.first_slot[a]; slot < c.first_slot[a + 1]; ++slot) {
        const auto i = static_cast<std::size_t>(slot);
        if (c.on[i] != 0) pair(c.master[a], c.element[i], c.wrench[i]);
      }
    }
    for (std::size_t i = 0; i < w.overlaps.wrench.size(); ++i) pair(w.overlaps.springs[i].a, w.overlaps.springs[i].b, w.overlaps.wrench[i]);
    for (const std::int32_t h : cuts_[k].tie_holds) {
      const HeldForce held = force_of_hold(w, nth(w.ties.hold, h));
      out[k].force += held.force;
      out[k].moment += cross(held.point - cut.point, held.force);
    }
  }
}

}  // namespace voussoir::solver
