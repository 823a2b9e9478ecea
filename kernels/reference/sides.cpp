// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "kernels/side.h"
#include "kernels/side_laws.h"

namespace voussoir::kernels {

namespace {

void add(SideSums& sums, Local f, double s, double t) noexcept {
  sums.f = sums.f + f;
  sums.sf = sums.sf + s * f;
  sums.tf = sums.tf + t * f;
}

/// What `twist` adds to the moments of a bonded segment, so that force and slip do the same work.
void add_twist(SideSums& sums, double twist, Local f, double s, double t) noexcept {
  sums.sf.s2 += twist * s * f.s2;
  sums.tf.s1 += twist * t * f.s1;
}

void record(const SegmentStep& step, SegmentsView q, int i, std::int32_t id, double time, EventSink& sink) noexcept {
  if (step.reached == Mode::none && step.broke == Mode::none) return;
  if (q.first_mode[i] == Mode::none && step.reached != Mode::none) {
    q.first_mode[i] = step.reached;
    q.first_time[i] = time;
  }
  sink.data[sink.count++] = {id, i, step.reached, step.broke};
}

/// Least u_n over the rectangle of the points [m].
double least_opening(const SideConstants& b, int l, const SideFrame& f) noexcept {
  return f.d.n + std::min(b.s_low[l] * f.ds.n, b.s_high[l] * f.ds.n) + std::min(b.t_low[l] * f.dt.n, b.t_high[l] * f.dt.n);
}

/// Largest |u_s|² at the corners of the rectangle of the points [m2].
double largest_slide2(const SideConstants& b, int l, const SideFrame& f) noexcept {
  double most = 0.0;
  for (const double s : {b.s_low[l], b.s_high[l]}) {
    for (const double t : {b.t_low[l], b.t_high[l]}) {
      const Local u = f.d + (s * f.ds + t * f.dt);
      most = std::max(most, u.s1 * u.s1 + u.s2 * u.s2);
    }
  }
  return most;
}

/// Stores force and torque on the master, then on the slave.
void put_pair(double* to, Vec3 f, Vec3 ta, Vec3 tb) noexcept {
  const double both[kPairStride] = {f.x, f.y, f.z, ta.x, ta.y, ta.z, -f.x, -f.y, -f.z, tb.x, tb.y, tb.z};
  std::copy_n(both, kPairStride, to);
}

void hand_out(const Side& side, std::int64_t id, const SideFrame& f, const SegmentTotals& r, const Rows& rows) noexcept {
  PairWrench w;
  to_wrench(f, r.total, w.force, w.torque_a, w.torque_b);
  to_wrench(f, r.dash, w.dash_force, w.dash_torque_a, w.dash_torque_b);
  if (rows.pairs.on != nullptr) {
    put_pair(rows.pairs.wrench + id * kPairStride, w.force, w.torque_a, w.torque_b);
    rows.pairs.on[id] = 1;
  }
  add_wrench(rows.wrench, side.master, w.force, w.torque_a);
  add_dashpot(rows.wrench, rows.dashpot, side.master, w.dash_force, w.dash_torque_a);
  if (r.touching) note_push(rows.wrench, side.master, w.force);
  if (side.on_base) return;
  add_wrench(rows.wrench, side.slave, -w.force, w.torque_b);
  add_dashpot(rows.wrench, rows.dashpot, side.slave, -w.dash_force, w.dash_torque_b);
  if (r.touching) note_push(rows.wrench, side.slave, w.force);
}

/// \param law  advances segment i: (state, i, u, rate) -> SegmentStep
/// \tparam kTwists  whether the side's `twist` counts; compiled apart, so that sides without one keep their last digits
template <bool kTwists, typename Law>
[[gnu::noinline]] SegmentTotals advance_by(const Law& law, const Side& side, std::int32_t id, const SideFrame& f, PointsView p,
                                           SegmentsView q, double time, EventSink& sink) noexcept {
  SegmentTotals r;
  for (int i = 0; i < p.n; ++i) {
    const double s = p.s[i], t = p.t[i], da = side.factor * p.area[i];
    Local u = f.d + s * f.ds + t * f.dt;
    Local rate = f.v + s * f.vs + t * f.vt;
    const bool twists = kTwists && holds(q.bond[i]);
    if (twists) {
      u = u + added_by_twist(side.twist, f.ds, f.dt, s, t);
      rate = rate + added_by_twist(side.twist, f.vs, f.vt, s, t);
    }
    SegmentState state{q.bond[i], q.slip1(i), q.slip2(i), q.closure(i)};
    const SegmentStep out = law(state, i, u, rate);
    q.bond[i] = state.bond;
    q.slip1(i) = state.slip1, q.slip2(i) = state.slip2, q.closure(i) = state.closure;
    record(out, q, i, id, time, sink);
    add(r.total, da * out.traction, s, t);
    add(r.dash, da * out.dashpot, s, t);
    if (twists) add_twist(r.total, side.twist, da * out.traction, s, t);
    if (twists) add_twist(r.dash, side.twist, da * out.dashpot, s, t);
    r.friction += da * out.friction;
    r.impact += da * out.impact;
    r.fracture += da * out.fracture;
    const bool held = holds(state.bond);
    r.held += held;
    r.touching = r.touching || (!held && u.n < state.closure);
  }
  return r;
}

}  // namespace

SegmentTotals advance_segments(const Side& side, std::int32_t id, const SideFrame& f, PointsView p, SegmentsView q, double step,
                               double time, FailureOptions o, EventSink& sink) noexcept {
  return with_segment_law(*side.laws, side.k, side.strength, step, o, [&](const auto& law) {
    return side.twist == 0.0 ? advance_by<false>(law, side, id, f, p, q, time, sink) : advance_by<true>(law, side, id, f, p, q, time, sink);
  });
}

SideEnergy segment_energy(const Side& side, const SideFrame& f, PointsView p, SegmentsView q) noexcept {
  SideEnergy e;
  for (int i = 0; i < p.n; ++i) {
    Local u = f.d + p.s[i] * f.ds + p.t[i] * f.dt;
    const bool held = holds(q.bond[i]);
    if (side.twist != 0.0 && held) u = u + added_by_twist(side.twist, f.ds, f.dt, p.s[i], p.t[i]);
    const double n = u.n - q.closure(i);
    if (!held && n >= 0.0) continue;
    const Local x = held ? Local{n, u.s1 - q.slip1(i), u.s2 - q.slip2(i)} : Local{n, q.slip1(i), q.slip2(i)};
    const double stored = held ? stored_by_bond(*side.laws, i, x, side.k) : stored_by_contact(*side.laws, x, side.k);
    (held ? e.bonds : e.contact) += side.factor * p.area[i] * stored;
  }
  return e;
}

unsigned advance_sides_reference(const SideBlock& block, const BlockState& state, const Rows& rows, StepClock clock, FailureOptions o,
                                 DamagedSide* result, EventSink& sink) noexcept {
  for (int l = 0; l < kLanes; ++l) {
    if (!(state.live >> l & 1U)) continue;
    const SideParts& parts = state.parts[l];
    Side side = side_of(block, l, parts);
    if (state.laws != nullptr) side.laws = state.laws + l;
    const SideFrame f = side_frame(side, load_pose(rows.pose, side.master), load_pose(rows.pose, side.slave),
                                   load_twist(rows.twist, side.master), load_twist(rows.twist, side.slave));
    const int before = sink.count;
    const NormalFields normal{f.d.n, f.ds.n, f.dt.n, f.v.n, f.vs.n, f.vt.n};
    const GaveWay gave = give_way(*side.laws, normal, side.k.kn, side.factor, parts.points, parts.segments, clock.dt);
    const SegmentTotals r = advance_segments(side, parts.id, f, parts.points, parts.segments, clock.dt, clock.time, o, sink);
    hand_out(side, state.first + l, f, r, rows);
    result[l] = {.friction = r.friction,
                 .impact = r.impact + gave.impact,
                 .fracture = r.fracture + gave.fracture,
                 .held = r.held,
                 .events = sink.count - before,
                 .touching = r.touching,
                 .slide2 = largest_slide2(*block.constants, l, f),
                 .tilt2 = dot(f.ds, f.ds) + dot(f.dt, f.dt),
                 .gap = least_opening(*block.constants, l, f),
                 .u = {f.d, f.ds, f.dt}};
  }
  return state.live;
}

}  // namespace voussoir::kernels
