// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/side.h"

namespace voussoir::kernels {

namespace {

void add(SideSums& sums, Local f, double s, double t) noexcept {
  sums.f = sums.f + f;
  sums.sf = sums.sf + s * f;
  sums.tf = sums.tf + t * f;
}

void record(const SegmentStep& step, SegmentsView q, int i, std::int32_t id, double time, EventSink& sink) noexcept {
  if (step.reached == Mode::none && step.broke == Mode::none) return;
  if (q.first_mode[i] == Mode::none && step.reached != Mode::none) {
    q.first_mode[i] = step.reached;
    q.first_time[i] = time;
  }
  sink.data[sink.count++] = {id, i, step.reached, step.broke};
}

}  // namespace

SideResult advance_side_reference(const Side& side, std::int32_t id, const SideFrame& f, PointsView p, SegmentsView q, double step,
                                  double time, FailureOptions o, EventSink& sink) noexcept {
  SideResult r;
  SideSums total, dash;
  r.gap = 1e300;
  for (int i = 0; i < p.n; ++i) {
    const double s = p.s[i], t = p.t[i], da = side.factor * p.area[i];
    const Local u = f.d + s * f.ds + t * f.dt;
    const Local rate = f.v + s * f.vs + t * f.vt;
    SegmentState state{q.bond[i], q.slip1[i], q.slip2[i], q.closure[i]};
    const SegmentStep out = advance_segment(state, u, rate, step, side.k, side.strength, o);
    q.bond[i] = state.bond;
    q.slip1[i] = state.slip1, q.slip2[i] = state.slip2, q.closure[i] = state.closure;
    record(out, q, i, id, time, sink);
    add(total, da * out.traction, s, t);
    add(dash, da * out.dashpot, s, t);
    const bool held = holds(state.bond);
    r.held += held;
    (held ? r.stored_bonds : r.stored_contact) += da * out.stored;
    r.friction += da * out.friction;
    r.impact += da * out.impact;
    r.fracture += da * out.fracture;
    if (!held) {
      const double opening = u.n - state.closure;
      if (opening < r.gap) r.gap = opening;
      r.touching = r.touching || opening < 0.0;
    }
  }
  to_wrench(f, total, r.wrench.force, r.wrench.torque_a, r.wrench.torque_b);
  to_wrench(f, dash, r.wrench.dash_force, r.wrench.dash_torque_a, r.wrench.dash_torque_b);
  return r;
}

}  // namespace voussoir::kernels
