// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/damaged_sides.h"

#include <algorithm>

#include "kernels/chunk_law.h"
#include "kernels/side_laws.h"

// Frames and wrenches are computed for kWidth sides at a time, segments for one side, kWidth points at a time.
namespace voussoir::kernels {

namespace {

// ---- kWidth sides at a time: their frames, and the affine fields in these

/// u(s,t) and its rate in the frame of each lane's side, as in SideFrame: d, ds, dt, v, vs, vt.
constexpr int kFields = 6;
struct alignas(64) LaneFields {
  double value[kFields][3][kWidth];
};

VOUSSOIR_INLINE void put(LaneFields& f, int field, LocalLanes v) noexcept {
  store_lanes(f.value[field][0], v.n);
  store_lanes(f.value[field][1], v.s1);
  store_lanes(f.value[field][2], v.s2);
}

struct TwistLanes {
  VecLanes v, w;
};
VOUSSOIR_INLINE TwistLanes gather_twists(const double* rows, const std::int32_t* elements) noexcept {
  const auto row = [=](int l) { return rows + static_cast<std::int64_t>(elements[l]) * kTwistStride; };
  TwistLanes t;
  Lanes unused;
  load_columns(row, 0, t.v.x, t.v.y, t.v.z, t.w.x);
  load_columns(row, 4, t.w.y, t.w.z, unused, unused);
  return t;
}

VOUSSOIR_INLINE void put_fields(const SideBlock& block, int at, const Kinematics& k, const FrameLanes& frame, const Rows& rows,
                                LaneFields& fields) noexcept {
  put(fields, 0, frame.local(k.d));
  put(fields, 1, frame.local(k.a));
  put(fields, 2, frame.local(k.b));
  // Rates at the point of action, work-conjugate to the force applied there.
  const TwistLanes a = gather_twists(rows.twist, block.master + at), b = gather_twists(rows.twist, block.slave + at);
  const VecLanes w = b.w - a.w;
  put(fields, 3, frame.local((b.v + cross(b.w, k.arm_b)) - (a.v + cross(a.w, k.arm_a))));
  put(fields, 4, frame.local(cross(w, k.es)));
  put(fields, 5, frame.local(cross(w, k.et)));
}

// ---- a single side

VOUSSOIR_INLINE LocalLanes spread_field(const LaneFields& f, int field, int lane) noexcept {
  return {lanes(f.value[field][0][lane]), lanes(f.value[field][1][lane]), lanes(f.value[field][2][lane])};
}

VOUSSOIR_INLINE Law law_of(const SideConstants& b, int l, const LaneFields& f, int lane, const SideParts& p, double step,
                           FailureOptions o) noexcept {
  return {spread_field(f, 0, lane),
          spread_field(f, 1, lane),
          spread_field(f, 2, lane),
          spread_field(f, 3, lane),
          spread_field(f, 4, lane),
          spread_field(f, 5, lane),
          {b.kn[l], b.ks[l], p.dashpot_factor * p.cn, p.dashpot_factor * p.cs},
          {b.tension[l], b.cohesion[l], b.tan_phi[l], b.compression[l], b.cap[l], b.friction[l]},
          p.factor,
          step,
          o};
}

VOUSSOIR_INLINE void write_row(const Sums& s, Lanes extra1, Lanes extra2, double* row) noexcept {
  store_quad(row, sums_of(s.f.n, s.f.s1, s.f.s2, s.sf.n));
  store_quad(row + 4, sums_of(s.sf.s1, s.sf.s2, s.tf.n, s.tf.s1));
  store_quad(row + 8, sums_of(s.tf.s2, extra1, extra2, Lanes{}));
}

Local field(const LaneFields& f, int k, int lane) noexcept { return {f.value[k][0][lane], f.value[k][1][lane], f.value[k][2][lane]}; }

/// Results of the literal law in the rare chunks of a side; empty between two sides.
struct Literal {
  SegmentTotals sum;
  bool any = false;
};

void add(SideSums& a, const SideSums& b) noexcept { a = {a.f + b.f, a.sf + b.sf, a.tf + b.tf}; }

/// Applies the literal law to the points from `i` on, at most kWidth.
[[gnu::noinline]] void advance_literally(Side side, const LaneFields& f, int lane, const SideParts& parts, int i, StepClock clock,
                                         FailureOptions o, Literal& found, EventSink& sink) noexcept {
  SideFrame frame{};
  frame.d = field(f, 0, lane), frame.ds = field(f, 1, lane), frame.dt = field(f, 2, lane);
  frame.v = field(f, 3, lane), frame.vs = field(f, 4, lane), frame.vt = field(f, 5, lane);
  const PointsView& p = parts.points;
  const SegmentsView& q = parts.segments;
  const int live = p.n - i < kWidth ? p.n - i : kWidth, first = sink.count;
  const SideLaws laws = side.laws->from(i);
  side.laws = &laws;
  const SegmentTotals r =
      advance_segments(side, parts.id, frame, {p.s + i, p.t + i, p.area + i, live}, q.from(i), clock.dt, clock.time, o, sink);
  for (int e = first; e < sink.count; ++e) sink.data[e].point += i;
  add(found.sum.total, r.total);
  add(found.sum.dash, r.dash);
  found.sum.friction += r.friction, found.sum.impact += r.impact, found.sum.fracture += r.fracture;
  found.sum.held += r.held;
  found.sum.touching |= r.touching;
  found.any = true;
}

void add(double* row, const SideSums& s) noexcept {
  const Local part[3] = {s.f, s.sf, s.tf};
  for (int k = 0; k < 3; ++k) row[3 * k] += part[k].n, row[3 * k + 1] += part[k].s1, row[3 * k + 2] += part[k].s2;
}

/// Sums of one side, one row each: f, sf, tf in (n, 1, 2), then friction and impact.
struct SumRows {
  double total[12], dash[12];
};

/// Lets contacts of one side give way, where a law of it says so.
GaveWay give_way(const SideLaws& laws, const LaneFields& f, int lane, double kn, const SideParts& parts, double step) noexcept {
  const auto normal = [&](int k) { return f.value[k][0][lane]; };
  const NormalFields fields{normal(0), normal(1), normal(2), normal(3), normal(4), normal(5)};
  return give_way(laws, fields, kn, parts.factor, parts.points, parts.segments, step);
}

bool any_held(const SegmentsView& q, int first, int last) noexcept {
  return std::any_of(q.bond + first, q.bond + last, [](Bond b) { return holds(b); });
}

/// Advances all segments of one side.
VOUSSOIR_INLINE void advance_side(const SideBlock& block, int l, const LaneFields& f, int lane, const SideParts& parts,
                                  const SideLaws& laws, StepClock clock, FailureOptions o, Literal& found, SumRows& rows,
                                  DamagedSide& result, EventSink& sink) noexcept {
  Law law = law_of(*block.constants, l, f, lane, parts, clock.dt, o);
  const bool own = laws.has_bonds_of_its_own();
  const bool twists = block.constants->twist[l] != 0.0;  // then the literal law has all bonded segments
  if (own) law.o.brittle = true;                         // what reaches a limit is for the literal law, and so is what the law has changed
  Totals sum;
  const int before = sink.count;
  for (int i = 0; i < parts.points.n; i += kWidth) {
    const int end = std::min(i + kWidth, parts.points.n);
    const bool changed = own && has_changed_bonds(laws, i, end);
    if (!(twists && any_held(parts.segments, i, end)) && !changed && advance_chunk(law, parts.points, parts.segments, i, sum)) continue;
    Side side = side_of(block, l, parts);
    side.laws = &laws;
    advance_literally(side, f, lane, parts, i, clock, o, found, sink);
  }
  write_row(sum.total, sum.friction, sum.impact, rows.total);
  if (sum.touching) {
    write_row(sum.dash, Lanes{}, Lanes{}, rows.dash);
  } else {
    std::fill_n(rows.dash, 12, 0.0);
  }
  result.friction = rows.total[9], result.impact = rows.total[10], result.fracture = 0.0;
  result.held = sum.held, result.events = sink.count - before, result.touching = sum.touching;
  if (!found.any) return;
  add(rows.total, found.sum.total);
  add(rows.dash, found.sum.dash);
  result.friction += found.sum.friction, result.impact += found.sum.impact, result.fracture += found.sum.fracture;
  result.held += found.sum.held;
  result.touching |= found.sum.touching;
  found = {};
}

// ---- kWidth sides: from sums to forces on the elements

VOUSSOIR_INLINE SumLanes global_sums(const FrameLanes& f, const SumRows* rows, double (SumRows::*part)[12]) noexcept {
  const auto row = [=](int l) { return rows[l].*part; };
  LocalLanes x[3];
  Lanes unused;
  load_columns(row, 0, x[0].n, x[0].s1, x[0].s2, x[1].n);
  load_columns(row, 4, x[1].s1, x[1].s2, x[2].n, x[2].s1);
  load_columns(row, 8, x[2].s2, unused, unused, unused);
  return {f.global(x[0]), f.global(x[1]), f.global(x[2])};
}

/// Adds the sizes of the forces of those sides on which points touch to their elements' sums (22a).
VOUSSOIR_INLINE void note_pushes(const SideBlock& s, int at, VecLanes force, unsigned touching, const Rows& rows) noexcept {
  for (int l = 0; l < kWidth; ++l) {
    if (!(touching >> l & 1U)) continue;
    const Vec3 f{force.x[l], force.y[l], force.z[l]};
    note_push(rows.wrench, s.master[at + l], f);
    if (!(s.on_base >> (at + l) & 1U)) note_push(rows.wrench, s.slave[at + l], f);
  }
}

/// Largest |u_s|² over the rectangles of the points [m2]. It is convex, so the maximum is at a corner.
Lanes largest_slide2(const SideConstants& c, int at, const LaneFields& f) noexcept {
  Lanes most{};
  for (const double* s : {c.s_low + at, c.s_high + at}) {
    for (const double* t : {c.t_low + at, c.t_high + at}) {
      const auto u = [&](int k) {
        return load_lanes(f.value[0][k]) + (load_lanes(s) * load_lanes(f.value[1][k]) + load_lanes(t) * load_lanes(f.value[2][k]));
      };
      most = max(most, square(u(1), u(2)));
    }
  }
  return most;
}

/// Reports slide, tilt and gap of the faces of each lane's side.
void report_facing(const SideBlock& block, int at, const LaneFields& f, unsigned chosen, DamagedSide* result) noexcept {
  const Lanes gap = least_opening(*block.constants, at, load_lanes(f.value[0][0]), load_lanes(f.value[1][0]), load_lanes(f.value[2][0]));
  const auto norm2 = [&](int k) {
    const Lanes n = load_lanes(f.value[k][0]);
    return n * n + square(load_lanes(f.value[k][1]), load_lanes(f.value[k][2]));
  };
  const Lanes slide2 = largest_slide2(*block.constants, at, f), tilt2 = norm2(1) + norm2(2);
  for (int l = 0; l < kWidth; ++l) {
    if (!(chosen >> l & 1U)) continue;
    result[l].gap = gap[l], result[l].slide2 = slide2[l], result[l].tilt2 = tilt2[l];
    result[l].u = {field(f, 0, l), field(f, 1, l), field(f, 2, l)};
  }
}

}  // namespace

void advance_damaged(const SideBlock& block, int at, unsigned chosen, const BlockState& state, Kinematics& k, const Rows& rows,
                     StepClock clock, FailureOptions o, SumLanes& sums, DamagedSide* result, EventSink& sink) noexcept {
  k.n = (1.0 / sqrt(dot(k.n, k.n))) * k.n;
  LaneFields fields;
  const FrameLanes f = frame_of(block, at, k, k.n);
  put_fields(block, at, k, f, rows, fields);
  SumRows by_lane[kWidth];
  Literal found_literally;
  unsigned touching = 0;
  for (int l = 0; l < kWidth; ++l) {
    if (!(chosen >> l & 1U)) {
      std::fill_n(by_lane[l].total, 12, 0.0);
      std::fill_n(by_lane[l].dash, 12, 0.0);
      continue;
    }
    const SideParts& parts = state.parts[at + l];
    const SideLaws& laws = state.laws != nullptr ? state.laws[at + l] : kNoLaws;
    const GaveWay gave = laws.moves_contacts() ? give_way(laws, fields, l, block.constants->kn[at + l], parts, clock.dt) : GaveWay{};
    advance_side(block, at + l, fields, l, parts, laws, clock, o, found_literally, by_lane[l], result[l], sink);
    result[l].fracture += gave.fracture, result[l].impact += gave.impact;
    touching |= static_cast<unsigned>(result[l].touching) << l;
  }
  const LaneMask mask = lanes_of(chosen);
  const SumLanes found = global_sums(f, by_lane, &SumRows::total);
  sums = {select3(mask, found.f, sums.f), select3(mask, found.sf, sums.sf), select3(mask, found.tf, sums.tf)};
  if (touching != 0) {
    assemble(block, at, state.first, wrench_of(k, global_sums(f, by_lane, &SumRows::dash)), touching, rows, true);
    note_pushes(block, at, found.f, touching, rows);
  }
  report_facing(block, at, fields, chosen, result);
}

}  // namespace voussoir::kernels
