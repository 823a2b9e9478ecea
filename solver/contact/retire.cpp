// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "geometry/nth.h"
#include "kernels/laws/restitution.h"
#include "kernels/side_laws.h"
#include "solver/contact/contact_forces.h"
#include "solver/contact/contact_lists.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

namespace {

/// The free patch that one element keeps of a retired side. `mirrored`: the slave's, whose face sees the side from behind.
kernels::Patch patch_of(const World& w, std::int64_t id, const kernels::Side& s, bool mirrored) {
  const auto i = static_cast<std::size_t>(id);
  const kernels::SideConstants& b = *w.sides.blocks[i / kernels::kLanes].constants;
  const int l = static_cast<int>(id % kernels::kLanes);
  kernels::Patch p;
  p.element = mirrored ? s.slave : s.master;
  p.origin = mirrored ? s.master : s.slave;
  p.face = mirrored ? w.sides.slave_face[i] : w.sides.master_face[i];
  p.centre = mirrored ? s.cb : s.ca;
  p.es = s.es;
  // Points keep their (s, t); behind, one axis is not turned but the normal is: see kernels::Patch::normal_sign.
  p.et = s.et;
  p.normal_sign = mirrored ? -1.0F : 1.0F;
  p.origin_face = mirrored ? w.sides.master_face[i] : w.sides.slave_face[i];
  p.s_low = b.s_low[l], p.s_high = b.s_high[l], p.t_low = b.t_low[l], p.t_high = b.t_high[l];
  p.origin_kn = kernels::patch_stiffness(*s.laws, s.k.kn), p.origin_ks = s.k.ks;
  return p;
}

/// u of a segment, as its spring has it, or its rate. \param d,ds,dt  u, or its rate, of the faces
kernels::Local of_spring(const kernels::Side& side, kernels::Local d, kernels::Local ds, kernels::Local dt, double s, double t, bool held) {
  const kernels::Local u = d + s * ds + t * dt;
  return held && side.twist != 0.0 ? u + kernels::added_by_twist(side.twist, ds, dt, s, t) : u;
}

/// Bonds that still pull when their faces have slid past each other end with the side. Counts as fracture what their springs held, and by
/// the trapezoid rule the work of their last force in the coming step, as advance_segment does for one that breaks (a row of the ledger in
/// this very step has that work early).
void record_torn_bonds(World& w, std::int64_t id, const kernels::Side& s, const kernels::SideFrame& f) {
  const double step = w.step_of(w.multirate.joint_level(s.master, s.slave));
  const auto i = static_cast<std::size_t>(id);
  const kernels::PointsView points = w.points.view(w.sides.set[i]);
  const kernels::SegmentsView q = w.sides.segments(id);
  for (int k = 0; k < points.n; ++k) {
    if (!kernels::holds(q.bond[k])) continue;
    const kernels::Local u = of_spring(s, f.d, f.ds, f.dt, points.s[k], points.t[k], true);
    const kernels::Local x{u.n - q.closure(k), u.s1 - q.slip1(k), u.s2 - q.slip2(k)};
    if (x.n < 0.0) continue;
    const double kn = kernels::bond_stiffness(*s.laws, k, x.n, s.k.kn);
    const kernels::Local traction{kn * x.n, s.k.ks * x.s1, s.k.ks * x.s2};
    const kernels::Local rate = of_spring(s, f.v, f.vs, f.vt, points.s[k], points.t[k], true);
    w.sides.fracture[i] += 0.5 * s.factor * points.area[k] * (dot(traction, x) + step * dot(traction, rate));
  }
}

/// Hands the closed segments over: partner, face, elastic slip (into the body frame of the patch's element).
///
/// A joint measures its closing along the mean normal at the midpoint of its two points, a free patch from its own point to the other face.
/// After a slide of half a segment the two differ by up to slide × tilt, a hundred times the elastic closing; taken as it is, the change
/// would shoot the pair apart. So the point keeps the difference as an offset until it lets go: force and energy are continuous, and the
/// patch holds from this step on what the side held.
void hand_over(World& w, std::int64_t id, const kernels::Side& s, const kernels::SideFrame& f, bool mirrored) {
  const auto i = static_cast<std::size_t>(id);
  const std::size_t p = w.patches.patch.size() - 1;
  FreePatch& patch = w.patches.patch[p];
  const kernels::PointsView points = w.points.view(w.sides.set[i]);
  const kernels::SegmentsView q = w.sides.segments(id);
  const kernels::ContactPoints to = w.patches.points(static_cast<std::int64_t>(p));
  const kernels::Pose pose = kernels::load_pose(w.elements.pose.data(), patch.element);
  for (int k = 0; k < points.n; ++k) {
    const bool held = kernels::holds(q.bond[k]);
    const kernels::Local u = of_spring(s, f.d, f.ds, f.dt, points.s[k], points.t[k], held);
    if (to.crushed != nullptr) to.crushed[k] = kernels::crushed_by(*s.laws, k), to.closure(k) = to.recess(k);
    if (u.n - q.closure(k) >= 0.0) continue;
    // Still bonded while it slid half a segment: only the elastic part of its shear lives on.
    const double x1 = held ? u.s1 - q.slip1(k) : q.slip1(k), x2 = held ? u.s2 - q.slip2(k) : q.slip2(k);
    const Vec3 x = (mirrored ? -1.0 : 1.0) * (x1 * f.t1 + x2 * f.t2);
    const Vec3 body = x + transposed(pose.d) * x;
    to.partner[k] = mirrored ? s.master : s.slave;
    to.face[k] = mirrored ? w.sides.master_face[i] : w.sides.slave_face[i];
    to.set_slip(k, body);
    const double depth =
        kernels::depth_under_face(patch, points.s[k], points.t[k], to.partner[k], to.face[k], w.bodies(), w.faces.data(), w.contact);
    const double da = (nth(w.faces, to.face[k]).is_ground() ? 1.0 : 0.5) * points.area[k];
    const auto [n, lost] = kernels::left_to_patch(*s.laws, u.n - q.closure(k), s.k.kn);
    w.sides.impact[i] += da * lost;
    to.closure(k) = depth - n;
    if (to.pressed != nullptr) to.pressed[k] = kernels::pressed_at_closure(-n, w.contact.restitution);
    patch.stored += 0.5 * da * (kernels::patch_stiffness(*s.laws, s.k.kn) * n * n + s.k.ks * (x1 * x1 + x2 * x2));
    ++patch.touching;
  }
}

/// A retired side's patches go on against the element they were joined to at once; a search for other neighbours follows soon. (A search at
/// every retirement would be one at every step of a collapse.)
constexpr std::int32_t kStepsToSearch = 10;

void activate_last_patch(World& w) {
  Contacts& c = w.contacts;
  const kernels::Patch& p = w.patches.patch.back();
  if (c.first_slot.empty()) c.first_slot.push_back(0);
  c.active.push_back(static_cast<std::int32_t>(w.patches.patch.size()) - 1);
  c.element.push_back(p.origin);
  c.candidate.push_back(candidate_of(w, p.origin));
  c.first_slot.push_back(static_cast<std::int64_t>(c.element.size()));
  c.wrench.emplace_back();
  c.on.push_back(0);
  add_to_gather(w);
}

}  // namespace

void append_retired_patch(World& w, std::int32_t side, bool mirrored) {
  append_patch(w, patch_of(w, side, w.sides.side(side), mirrored), nth(w.sides.set, side), side, !mirrored);
}

void retire_side(World& w, std::int32_t side) {
  const std::int64_t id = side;
  const auto i = static_cast<std::size_t>(id);
  Sides& sides = w.sides;
  const kernels::Side s = sides.side(id);
  const double *pose = w.elements.pose.data(), *twist = w.twist_rows(w.multirate.joint_level(s.master, s.slave));
  const kernels::SideFrame f = kernels::side_frame(s, kernels::load_pose(pose, s.master), kernels::load_pose(pose, s.slave),
                                                   kernels::load_twist(twist, s.master), kernels::load_twist(twist, s.slave));
  record_torn_bonds(w, id, s, f);
  const int patches = sides.faces[i];  // 2: the side stood for both faces
  for (int k = 0; k < patches; ++k) {
    append_retired_patch(w, side, k == 1);
    hand_over(w, id, s, f, k == 1);
    activate_last_patch(w);
  }
  sides.retired[i] = 1;
  sides.side_state[i] = kernels::SideState::segments;
  const std::int32_t cycle = w.multirate.cycle;
  w.travel.ask_for_search((kStepsToSearch + cycle - 1) / cycle);
}

void list_live_blocks(World& w) {
  Sides& s = w.sides;
  s.live_lanes.assign(s.blocks.size(), 0);
  for (std::size_t id = 0; id < s.retired.size(); ++id) {
    if (!s.retired[id]) s.live_lanes[id / kernels::kLanes] |= static_cast<std::uint8_t>(1U << id % kernels::kLanes);
  }
  s.live.clear();
  s.live_first.clear();
  s.live_level.clear();
  const std::size_t levels = w.multirate.every.size();
  for (std::size_t i = 0; i + 1 < s.task_level.size(); ++i) {
    if (i % levels == 0) s.live_first.push_back(static_cast<std::int32_t>(s.live.size()));
    s.live_level.push_back(static_cast<std::int32_t>(s.live.size()));
    for (std::int32_t b = s.task_level[i]; b < s.task_level[i + 1]; ++b) {
      if (nth(s.live_lanes, b) != 0) s.live.push_back(b);
    }
  }
  s.live_first.push_back(static_cast<std::int32_t>(s.live.size()));
  s.live_level.push_back(static_cast<std::int32_t>(s.live.size()));
}

}  // namespace voussoir::solver
