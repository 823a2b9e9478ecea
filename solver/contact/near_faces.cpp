// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact/near_faces.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/nth.h"
#include "solver/contact/placed_element.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kTakenAtOnce = 512;  // patches, elements or sides that a thread takes

/// Whether a face of the element to which the patch is not turned keeps it outside, but for a rim narrower than the skin: no point of the
/// patch, or one row of them, can touch. Both as they stood when they were searched last.
bool only_rim_is_near(const World& w, const kernels::Patch& p, std::int32_t other) {
  const PlacedElement own = placed_then(w, p.element), body = placed_then(w, other);
  const SeenPatch seen = seen_from(body, placed(p, own));
  const Vec3 normal = transposed(body.r) * (own.r * nth(w.faces, p.face).normal);
  const std::int32_t first = nth(w.elements.first_face, other), last = first + nth(w.elements.face_count, other);
  for (std::int32_t f = first; f < last; ++f) {
    const kernels::Face& face = nth(w.faces, f);
    const bool opposes = dot(face.normal, normal) < kernels::kOpposing;  // its own points see that face
    if (!opposes && least_distance(face, seen) > -w.travel.skin()) return true;
  }
  return false;
}

/// Whether an active patch can push something with more than its rim. \param a  index into Contacts::active
bool pushes(const World& w, std::size_t a) {
  const Contacts& c = w.contacts;
  if (static_cast<std::int64_t>(a) >= c.searched) return true;  // of a side that was there at the last search
  const kernels::Patch& p = nth(w.patches.patch, c.active[a]);
  for (std::int64_t slot = c.first_slot[a]; slot < c.first_slot[a + 1]; ++slot) {
    if (!only_rim_is_near(w, p, nth(c.element, slot))) return true;
  }
  return false;
}

/// Brings Contacts::pushes up to date for the patches whose candidates have changed, or whose poses at the last search.
void renew_pushes(World& w, const std::vector<std::uint8_t>* changed) {
  Contacts& c = w.contacts;
  c.pushes.resize(w.patches.patch.size());
  w.team.share_out(static_cast<std::int64_t>(c.active.size()), kTakenAtOnce, [&](std::int64_t first, std::int64_t last) {
    for (auto a = static_cast<std::size_t>(first); a < static_cast<std::size_t>(last); ++a) {
      const std::int32_t p = c.active[a];
      if (changed == nullptr || nth(*changed, p) != 0) nth(c.pushes, p) = pushes(w, a) ? 1 : 0;
    }
  });
}

/// By index into World::faces, 1: the face has something near.
std::vector<std::uint8_t> near_faces(const World& w) {
  const Sides& s = w.sides;
  std::vector<std::uint8_t> near(w.faces.size());
  for (const std::int32_t p : w.contacts.active) {
    if (nth(w.contacts.pushes, p) != 0) nth(near, nth(w.patches.patch, p).face) = 1;
  }
  for (std::size_t id = 0; id < s.joint.size(); ++id) {
    if (s.joint[id] >= 0 && s.retired[id] == 0) nth(near, s.master_face[id]) = nth(near, s.slave_face[id]) = 1;
  }
  return near;
}

/// \post at most DashpotBounds::all, and no less where most faces have something near
double bound_of(const World& w, std::size_t e, const std::vector<std::uint8_t>& near) {
  double sum = 0.0;
  for (std::int32_t f = w.elements.first_face[e]; f < w.elements.first_face[e] + w.elements.face_count[e]; ++f) {
    if (nth(near, f) != 0) sum += nth(w.dashpot_bounds.face, f);
  }
  return std::min(sum, w.dashpot_bounds.all[e]);
}

/// Dashpots of a side over those for all faces in contact.
double excess(const World& w, std::size_t id, std::int32_t a, std::int32_t b) {
  const std::int32_t other = nth(w.faces, w.sides.slave_face[id]).is_ground() ? a : b;
  const double step = w.step_of(w.multirate.joint_level_in_cycles(a, b));
  const double now = nth(w.elements.body, a).beta + nth(w.elements.body, other).beta;
  return (1.0 + step * (nth(w.dashpot_bounds.all, a) + nth(w.dashpot_bounds.all, other))) / (1.0 + step * now);
}

/// \param renewed  by element, 1: its bound is another than before
void renew_sides(World& w, const std::vector<std::uint8_t>& renewed) {
  Sides& s = w.sides;
  w.team.share_out(s.count(), kTakenAtOnce, [&](std::int64_t first, std::int64_t last) {
    for (auto id = static_cast<std::size_t>(first); id < static_cast<std::size_t>(last); ++id) {
      const std::int32_t a = s.blocks[id / kernels::kLanes].master[id % kernels::kLanes];
      const std::int32_t b = s.blocks[id / kernels::kLanes].slave[id % kernels::kLanes];
      if (s.joint[id] < 0 || s.retired[id] != 0 || (nth(renewed, a) == 0 && nth(renewed, b) == 0)) continue;
      s.parts[id].dashpot_factor = excess(w, id, a, b);
    }
  });
}

}  // namespace

void bound_dashpots_by_near_faces(World& w, const std::vector<std::uint8_t>* changed) {
  renew_pushes(w, changed);
  const std::vector<std::uint8_t> near = near_faces(w);
  std::vector<std::uint8_t> renewed(w.elements.body.size());
  w.team.share_out(w.elements.count, kTakenAtOnce, [&](std::int64_t first, std::int64_t last) {
    for (auto e = static_cast<std::size_t>(first); e < static_cast<std::size_t>(last); ++e) {
      const double bound = bound_of(w, e, near);
      renewed[e] = bound != w.elements.body[e].beta ? 1 : 0;
      w.elements.body[e].beta = bound;
    }
  });
  renew_sides(w, renewed);
}

}  // namespace voussoir::solver
