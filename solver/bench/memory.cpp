// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/memory.h"

namespace voussoir::solver {

namespace {

template <class... Columns>
std::size_t bytes(const Columns&... columns) {
  return (... + (columns.capacity() * sizeof(typename Columns::value_type)));
}
template <class... Columns>
std::size_t in_use(const Columns&... columns) {
  return (... + columns.in_use());
}

std::size_t bytes_of(const ByLevel& l) { return bytes(l.list, l.end); }

std::size_t bytes_of(const Elements& e) {
  return bytes(e.ux, e.uy, e.uz, e.qw, e.qx, e.qy, e.qz, e.vx, e.vy, e.vz, e.lx, e.ly, e.lz, e.wx, e.wy, e.wz) +
         bytes(e.tally, e.alpha, e.bonds, e.body, e.principal) +
         bytes(e.mass, e.inv_mass, e.ixx, e.iyy, e.izz, e.ixy, e.ixz, e.iyz, e.radius, e.half_x, e.half_y, e.half_z) +
         bytes(e.first_face, e.face_count, e.bonds_at_start, e.fixed, e.pose, e.twist, e.wrench, e.dashpot);
}

std::size_t bytes_of(const Multirate& m) {
  std::size_t sum = bytes(m.every, m.own, m.of_joints, m.of_contacts);
  for (const Multirate::Rows& r : m.rows) sum += bytes(r.twist, r.wrench, r.dashpot);
  return sum;
}

std::size_t bytes_of(const Sides& s) {
  return bytes(s.constants, s.whole, s.blocks, s.task_first, s.task_level, s.colour_first, s.live, s.live_first, s.live_level, s.live_lanes,
               s.joint, s.set, s.master_face, s.slave_face, s.faces) +
         bytes(s.parts, s.size, s.pair_wrench, s.pair_on) + bytes(s.side_state, s.retired, s.held) +
         in_use(s.friction, s.impact, s.fracture) + bytes(s.laws, s.law_state);
}

std::size_t bytes_of(const Patches& p) {
  return bytes(p.patch, p.element, p.from_side, p.mastered, p.partner, p.face, p.crushed, p.pressed) + in_use(p.springs);
}

std::size_t bytes_of(const Contacts& c) {
  return bytes(c.active, c.first_slot, c.master, c.element, c.candidate) +
         bytes(c.wrench, c.on, c.first_gather, c.last_gather, c.gather, c.place, c.gather_on) + bytes(c.level, c.gather_level) +
         bytes_of(c.patches) + bytes_of(c.gatherers);
}

std::size_t bytes_of(const Overlaps& o) {
  return bytes(o.vertices, o.edges, o.creases, o.shape, o.shape_of, o.stiffness_n, o.stiffness_s, o.allowed, o.pairs, o.springs, o.wrench) +
         bytes_of(o.by_level);
}

std::size_t bytes_of(const Ties& t) {
  return bytes(t.tie, t.hold, t.element, t.first_of_element, t.hold_of_element, t.state, t.jack, t.jack_work, t.pull);
}

}  // namespace

MemoryUse memory_use(const World& w) {
  const Sides& s = w.sides;
  const PointSets& points = w.points;
  MemoryUse use;
  use.elements = bytes_of(w.elements) + bytes(w.faces, w.moved_at) + bytes_of(w.multirate) + bytes_of(w.ties);
  use.sides = bytes_of(s) + bytes(points.first, points.count, points.s, points.t, points.area);
  use.segments = in_use(s.bond, s.steady, s.first_mode, s.first_time, s.springs);
  for (const LawState& kept : s.law_state) use.segments += in_use(kept.values);
  use.patches = bytes_of(w.patches) + w.travel.bytes() + bytes_of(w.contacts) + bytes_of(w.overlaps);
  return use;
}

}  // namespace voussoir::solver
