// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/damage.h"

#include "geometry/nth.h"
#include "solver/contact/contact_forces.h"

namespace voussoir::solver {

namespace {

std::int64_t& count_of(Damage& d, kernels::Mode m) {
  return m == kernels::Mode::tension ? d.tension : m == kernels::Mode::shear ? d.shear : d.compression;
}

/// While settling, at times below zero, what is loose keeps the damping that brings it to rest.
void lose_bond(World& w, std::int32_t element, double time) {
  const auto e = static_cast<std::size_t>(element);
  if (--w.elements.bonds[e] == 0 && w.drop_debris_damping && time >= 0.0) w.elements.alpha[e] = 0.0;
}

CrackRow crack_row(World& w, const kernels::SegmentEvent& event, const kernels::Side& s, double time) {
  const auto id = static_cast<std::size_t>(event.side);
  const auto a = static_cast<std::size_t>(s.master);
  const kernels::PointsView p = w.points.view(w.sides.set[id]);
  const kernels::SegmentsView q = w.sides.segments(event.side);
  const kernels::Pose pose = kernels::load_pose(w.elements.pose.data(), s.master);
  const Vec3 r = s.ca + p.s[event.point] * s.es + p.t[event.point] * s.et;
  const Vec3 n = cross(s.es, s.et);
  CrackRow row;
  row.time = time;
  row.joint = w.sides.joint[id];
  row.element_a = s.master;
  row.element_b = s.slave == w.elements.base ? -1 : s.slave;
  row.position = w.elements.body[a].ref + pose.u + r + pose.d * r;
  row.normal = n + pose.d * n;
  row.area = s.factor * p.area[event.point];
  row.mode = static_cast<FailureMode>(event.broke);
  row.first_mode = static_cast<FailureMode>(q.first_mode[event.point]);
  row.first_time = q.first_time[event.point];
  return row;
}

void record_event(World& w, const kernels::SegmentEvent& event, double time, Damage& d, std::vector<CrackRow>& cracks) {
  const kernels::Side s = w.sides.side(event.side);
  const std::int64_t n = nth(w.sides.faces, event.side);
  if (event.broke == kernels::Mode::none) {
    if (event.reached == kernels::Mode::shear) d.slipped += n;  // a bond that softens may have reached its limit in tension
    return;
  }
  // A segment that had slipped before it broke leaves that count.
  const bool slipped_before =
      w.sides.segments(event.side).first_mode[event.point] == kernels::Mode::shear && event.reached != kernels::Mode::shear;
  if (slipped_before) d.slipped -= n;
  d.bonded -= n;
  count_of(d, event.broke) += n;
  lose_bond(w, s.master, time);
  if (n == 2) lose_bond(w, s.slave, time);
  cracks.push_back(crack_row(w, event, s, time));
}

/// A side whose faces have slid past each other cannot be bonded any more: what still holds breaks in shear.
void break_what_holds(World& w, std::int32_t side, double time, Damage& d, std::vector<CrackRow>& cracks) {
  const kernels::SegmentsView q = w.sides.segments(side);
  const int n = nth(w.points.count, nth(w.sides.set, side));
  for (int i = 0; i < n; ++i) {
    if (!kernels::holds(q.bond[i])) continue;
    kernels::SegmentEvent event{side, i, kernels::Mode::none, kernels::Mode::shear};
    if (q.first_mode[i] == kernels::Mode::none) {
      event.reached = kernels::Mode::shear;
      q.first_mode[i] = kernels::Mode::shear;
      q.first_time[i] = time;
    }
    record_event(w, event, time, d, cracks);
  }
}

}  // namespace

Damage initial_damage(const World& w) {
  Damage d;
  for (std::int64_t id = 0; id < w.sides.count(); ++id) {
    const auto i = static_cast<std::size_t>(id);
    if (w.sides.joint[i] >= 0) d.bonded += std::int64_t{w.sides.held[i]} * w.sides.faces[i];
  }
  return d;
}

FirstLimits first_limits(const World& w) {
  FirstLimits found;
  const Sides& s = w.sides;
  for (std::int64_t id = 0; id < s.count(); ++id) {
    const auto i = static_cast<std::size_t>(id);
    if (s.joint[i] < 0 || s.side_state[i] == kernels::SideState::whole) continue;  // in whole ones nothing has happened
    const kernels::Mode* mode = s.parts[i].segments.first_mode;
    std::int64_t by_mode[4] = {};
    for (int k = 0; k < s.parts[i].points.n; ++k) ++nth(by_mode, mode[k]);
    const std::int64_t faces = s.faces[i];
    found.tension += faces * nth(by_mode, kernels::Mode::tension);
    found.shear += faces * nth(by_mode, kernels::Mode::shear);
    found.compression += faces * nth(by_mode, kernels::Mode::compression);
  }
  return found;
}

void record_damage(World& w, const JointEvents& events, double time, Damage& d, std::vector<CrackRow>& cracks) {
  for (const kernels::SegmentEvent& e : events.events) record_event(w, e, time, d, cracks);
  for (const std::int32_t side : events.coming_apart) {
    break_what_holds(w, side, time, d, cracks);
    retire_side(w, side);
  }
  if (!events.coming_apart.empty()) list_live_blocks(w);
}

}  // namespace voussoir::solver
