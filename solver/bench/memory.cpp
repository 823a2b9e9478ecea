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

}  // namespace

MemoryUse memory_use(const World& w) {
  const Elements& e = w.elements;
  const Sides& s = w.sides;
  const Patches& p = w.patches;
  const Contacts& c = w.contacts;
  MemoryUse use;
  use.elements = bytes(e.ux, e.uy, e.uz, e.qw, e.qx, e.qy, e.qz, e.vx, e.vy, e.vz, e.lx, e.ly, e.lz, e.wx, e.wy, e.wz) +
                 bytes(e.tally, e.alpha, e.bonds, e.body) +
                 bytes(e.mass, e.inv_mass, e.ixx, e.iyy, e.izz, e.ixy, e.ixz, e.iyz, e.radius, e.half_x, e.half_y, e.half_z) +
                 bytes(e.first_face, e.face_count, e.bonds_at_start, e.fixed, e.pose, e.twist, e.wrench, e.dashpot) + bytes(w.faces);
  use.sides = bytes(s.constants, s.whole, s.blocks, s.task_first, s.live, s.live_first, s.live_lanes, s.joint, s.set, s.master_face,
                    s.slave_face, s.faces) +
              bytes(s.parts, s.size, s.pair_wrench, s.pair_dashpot, s.pair_on, s.first_gather, s.gather) +
              bytes(s.side_state, s.retired, s.held, s.friction, s.impact, s.fracture) +
              bytes(w.points.first, w.points.count, w.points.s, w.points.t, w.points.area);
  use.segments = bytes(s.bond) + in_use(s.steady, s.first_mode, s.first_time, s.springs);
  use.patches = bytes(p.patch, p.element, p.from_side, p.mastered, p.partner, p.face) + in_use(p.springs) + w.travel.bytes() +
                bytes(c.active, c.first_slot, c.element, c.candidate) +
                bytes(c.wrench, c.on, c.first_gather, c.last_gather, c.gather, c.place, c.gather_on) +
                bytes(w.overlaps.vertices, w.overlaps.edges, w.overlaps.shape, w.overlaps.shape_of, w.overlaps.stiffness_n,
                      w.overlaps.stiffness_s, w.overlaps.allowed, w.overlaps.pairs, w.overlaps.springs);
  return use;
}

}  // namespace voussoir::solver
