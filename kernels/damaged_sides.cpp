// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "kernels/damaged_sides.h"

// Damaged sides. Frames and wrenches are made for kWidth sides at a time, their segments are run through for one side, kWidth points at a
// time. Only what happens all the time is here: elastic, slipping, touching, open. A chunk of points in which a bond breaks, first yields or
// is crushed goes through the literal law (segment_law.h), so each rare event is decided in one place. Losses are worked out only for chunks
// in which a point slips, closes or opens: in all others they are zero, exactly.
namespace voussoir::kernels {

namespace {

struct LocalLanes {
  Lanes n, s1, s2;
};
VOUSSOIR_INLINE LocalLanes operator+(LocalLanes a, LocalLanes b) noexcept { return {a.n + b.n, a.s1 + b.s1, a.s2 + b.s2}; }
VOUSSOIR_INLINE LocalLanes operator*(Lanes f, LocalLanes a) noexcept { return {f * a.n, f * a.s1, f * a.s2}; }
VOUSSOIR_INLINE LocalLanes select3(LaneMask m, LocalLanes a, LocalLanes b) noexcept {
  return {select(m, a.n, b.n), select(m, a.s1, b.s1), select(m, a.s2, b.s2)};
}
VOUSSOIR_INLINE VecLanes select3(LaneMask m, VecLanes a, VecLanes b) noexcept {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
VOUSSOIR_INLINE Lanes square(Lanes a, Lanes b) noexcept { return a * a + b * b; }

// ---- kWidth sides at a time: the frame of each, and the affine fields in it

/// u(s,t) and its rate in the frame of each lane's side, as in SideFrame: d, ds, dt, v, vs, vt.
constexpr int kFields = 6;
struct alignas(64) FieldTable {
  double value[kFields][3][kWidth];
};

struct Frames {
  const Kinematics& k;
  VecLanes t1, t2;
};

VOUSSOIR_INLINE void put(FieldTable& f, int field, const Frames& g, VecLanes v) noexcept {
  store_lanes(f.value[field][0], dot(v, g.k.n));
  store_lanes(f.value[field][1], dot(v, g.t1));
  store_lanes(f.value[field][2], dot(v, g.t2));
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

VOUSSOIR_INLINE Frames frames(const SideBlock& block, int at, const Kinematics& k, const Rows& rows, FieldTable& fields) noexcept {
  const VecLanes along = k.es - dot(k.es, k.n) * k.n;
  Frames f{k, (1.0 / sqrt(dot(along, along))) * along, {}};
  f.t2 = cross(k.n, f.t1);
  put(fields, 0, f, f.k.d);
  put(fields, 1, f, f.k.a);
  put(fields, 2, f, f.k.b);
  // Rates at the point of action, the conjugate of the force applied there.
  const TwistLanes a = gather_twists(rows.twist, block.master + at), b = gather_twists(rows.twist, block.slave + at);
  const VecLanes w = b.w - a.w;
  put(fields, 3, f, (b.v + cross(b.w, f.k.arm_b)) - (a.v + cross(a.w, f.k.arm_a)));
  put(fields, 4, f, cross(w, f.k.es));
  put(fields, 5, f, cross(w, f.k.et));
  return f;
}

// ---- one side, kWidth points at a time

/// What the points of one side share.
struct Law {
  LocalLanes d, ds, dt, v, vs, vt;
  Stiffness k;
  Strength strength;
  double factor, step;
  FailureOptions o;
};

VOUSSOIR_INLINE LocalLanes spread_field(const FieldTable& f, int field, int lane) noexcept {
  return {lanes(f.value[field][0][lane]), lanes(f.value[field][1][lane]), lanes(f.value[field][2][lane])};
}

VOUSSOIR_INLINE Law law_of(const SideBlock& b, int l, const FieldTable& f, int lane, const SideParts& p, double step,
                           FailureOptions o) noexcept {
  return {spread_field(f, 0, lane),
          spread_field(f, 1, lane),
          spread_field(f, 2, lane),
          spread_field(f, 3, lane),
          spread_field(f, 4, lane),
          spread_field(f, 5, lane),
          {b.kn[l], b.ks[l], p.cn, p.cs},
          {b.tension[l], b.cohesion[l], b.tan_phi[l], b.compression[l], b.cap[l]},
          p.factor,
          step,
          o};
}

/// kWidth points and their history.
struct Chunk {
  Lanes s, t, da;
  LaneMask held, slipped;
  LocalLanes u;
  Lanes slip1, slip2;
};

struct Sums {
  LocalLanes f{}, sf{}, tf{};
  VOUSSOIR_INLINE void add(LocalLanes v, Lanes s, Lanes t) noexcept {
    f = f + v;
    sf = sf + s * v;
    tf = tf + t * v;
  }
};

struct Totals {
  Sums total, dash;
  Lanes friction{}, impact{};
  int held = 0;
  bool touching = false;
};

/// Springs of a chunk after this step.
struct Springs {
  LocalLanes traction;    // Pa
  Lanes slip1, slip2;     // history after the step
  LaneMask rare{};        // lanes that the literal law must decide
  Lanes shear{}, normal{};  // J/m2, lost in this step
};

VOUSSOIR_INLINE LocalLanes rate(const Law& a, const Chunk& c) noexcept { return a.v + (c.s * a.vs + c.t * a.vt); }

VOUSSOIR_INLINE Lanes bonded_limit(Lanes sigma, const Law& a) noexcept {
  const Lanes none = lanes(std::numeric_limits<double>::infinity());
  if (!a.o.shear) return none;
  const Lanes coulomb = a.strength.cohesion - sigma * a.strength.tan_phi;
  const Lanes in_tension = a.o.in_tension == ShearInTension::cohesion ? lanes(a.strength.cohesion)
                           : a.o.in_tension == ShearInTension::none   ? none
                                                                      : max(coulomb, Lanes{});
  return select(sigma < 0.0, coulomb, in_tension);
}

/// U_before − U_now + ½ (f_before + f_now)·du of the shear springs: see advance_segment.
VOUSSOIR_INLINE Lanes shear_loss(double ks, Lanes b1, Lanes b2, Lanes x1, Lanes x2, Lanes du1, Lanes du2) noexcept {
  return 0.5 * ks * (square(b1, b2) - square(x1, x2) + (b1 + x1) * du1 + (b2 + x2) * du2);
}

/// Bonded lanes: elastic, or slipping on the shear limit.
VOUSSOIR_INLINE Springs bonded(const Law& a, const Chunk& c) noexcept {
  Springs r;
  const Lanes sigma = a.k.kn * c.u.n;  // a bond has no closure: crushing breaks it
  Lanes x1 = c.u.s1 - c.slip1, x2 = c.u.s2 - c.slip2;
  const Lanes tau2 = a.k.ks * a.k.ks * square(x1, x2);
  const Lanes limit = bonded_limit(sigma, a);
  const LaneMask yields = tau2 > limit * limit;
  const Lanes fm2 = lanes(a.strength.compression * a.strength.compression);
  r.rare = (sigma > a.strength.tension) | ((sigma < 0.0) & (sigma * sigma + a.strength.cap * tau2 > fm2));
  r.rare |= a.o.brittle ? yields : yields & ~c.slipped;
  r.slip1 = c.slip1, r.slip2 = c.slip2;
  if (bits(yields & c.held) != 0) {
    const Lanes scale = select(yields, limit / sqrt(tau2), lanes(1.0));
    const LocalLanes v = rate(a, c);
    const Lanes du1 = a.step * v.s1, du2 = a.step * v.s2, b1 = x1 - du1, b2 = x2 - du2;
    x1 = scale * x1, x2 = scale * x2;
    // Only where it slips: round-off must not creep into an elastic bond.
    r.slip1 = select(yields & c.slipped, c.u.s1 - x1, c.slip1);
    r.slip2 = select(yields & c.slipped, c.u.s2 - x2, c.slip2);
    r.shear = select(yields, shear_loss(a.k.ks, b1, b2, x1, x2, du1, du2), Lanes{});
  }
  r.traction = {sigma, a.k.ks * x1, a.k.ks * x2};
  return r;
}

/// See detail::dashpot_share. Here the spring is within its limit already.
VOUSSOIR_INLINE Lanes dashpot_share(Lanes pp, Lanes pd, Lanes dd, Lanes limit2) noexcept {
  const LaneMask within = pp + 2.0 * pd + dd <= limit2;
  if (bits(~within) == 0) return lanes(1.0);
  const Lanes root = sqrt(max(pd * pd + dd * (limit2 - pp), Lanes{}));
  return select(within, lanes(1.0), max((root - pd) / dd, Lanes{}));
}

/// Springs and dashpots of the lanes that are closed: see contact_traction in segment_law.h.
VOUSSOIR_INLINE void closed_contact(const Law& a, const Chunk& c, LocalLanes v, Lanes xn, LaneMask mine, LaneMask closed, Springs& r,
                                    LocalLanes& dashpot) noexcept {
  const Lanes zero{};
  const Lanes du1 = a.step * v.s1, du2 = a.step * v.s2;
  Lanes x1 = c.slip1 + du1, x2 = c.slip2 + du2;
  const Lanes dn = min(a.k.cn * v.n, -a.k.kn * xn);
  const Lanes limit = -(a.k.kn * xn + dn) * a.strength.tan_phi, limit2 = limit * limit;
  Lanes spring2 = a.k.ks * a.k.ks * square(x1, x2);
  const LaneMask cut = closed & (spring2 > limit2);
  if (bits(cut) != 0) {
    const Lanes f = select(cut, limit / sqrt(spring2), lanes(1.0));
    x1 = f * x1, x2 = f * x2;
    spring2 = min(spring2, limit2);
  }
  const Lanes p1 = a.k.ks * x1, p2 = a.k.ks * x2, d1 = a.k.cs * v.s1, d2 = a.k.cs * v.s2;
  const Lanes h = dashpot_share(spring2, p1 * d1 + p2 * d2, square(d1, d2), limit2);
  dashpot = select3(closed, LocalLanes{dn, h * d1, h * d2}, LocalLanes{});
  r.traction = select3(closed, LocalLanes{a.k.kn * xn, p1, p2}, LocalLanes{}) + dashpot;
  r.slip1 = select(closed, x1, zero);
  r.slip2 = select(closed, x2, zero);
  // A point that was closed, stays closed and does not slip loses nothing.
  const LaneMask changed = mine & (cut | (closed ^ (xn - a.step * v.n < 0.0)) | (~closed & ((c.slip1 != 0.0) | (c.slip2 != 0.0))));
  if (bits(changed) == 0) return;
  const Lanes dun = a.step * v.n, before = min(xn - dun, zero), now = min(xn, zero);
  r.shear = select(changed, shear_loss(a.k.ks, c.slip1, c.slip2, r.slip1, r.slip2, du1, du2), zero);
  r.normal = select(changed, 0.5 * a.k.kn * (before * before - now * now + (before + now) * dun), zero);
}

/// Lanes in contact, closed or open.
VOUSSOIR_INLINE Springs contact(const Law& a, const Chunk& c, Lanes closure, LaneMask mine, bool& touching, LocalLanes& dashpot) noexcept {
  Springs r;
  const Lanes xn = c.u.n - closure;
  const LaneMask closed = mine & (xn < 0.0);
  const LocalLanes v = rate(a, c);
  dashpot = LocalLanes{};
  // All open now and before, as most broken segments are: no force, no history.
  if (bits(closed | (mine & ((xn - a.step * v.n < 0.0) | (c.slip1 != 0.0) | (c.slip2 != 0.0)))) == 0) {
    r.traction = LocalLanes{};
    r.slip1 = r.slip2 = Lanes{};
    return r;
  }
  touching = touching || bits(closed) != 0;
  closed_contact(a, c, v, xn, mine, closed, r, dashpot);
  return r;
}

VOUSSOIR_INLINE Chunk load(const Law& a, PointsView p, SegmentsView q, int i, LaneMask bond) noexcept {
  Chunk c;
  c.s = load_lanes(p.s + i), c.t = load_lanes(p.t + i), c.da = a.factor * load_lanes(p.area + i);
  c.held = bond <= static_cast<long long>(Bond::slipped);
  c.slipped = bond == static_cast<long long>(Bond::slipped);
  c.slip1 = load_lanes(q.slip1 + i), c.slip2 = load_lanes(q.slip2 + i);
  c.u = a.d + (c.s * a.ds + c.t * a.dt);
  return c;
}

/// One chunk. Returns false, with nothing written, if the literal law must decide.
VOUSSOIR_INLINE bool advance_chunk(const Law& a, PointsView p, SegmentsView q, int i, Totals& sum) noexcept {
  const int live = p.n - i < kWidth ? p.n - i : kWidth;
  const unsigned real = (1U << live) - 1U;
  constexpr unsigned kAll = (1U << kWidth) - 1U;
  const LaneMask bond = widened(reinterpret_cast<const unsigned char*>(q.bond + i));
  if ((bits(bond == static_cast<long long>(Bond::crushed)) & real) != 0) return false;
  const Chunk c = load(a, p, q, i, bond);
  const unsigned held = bits(c.held);
  Springs r;
  if (held == kAll) {
    r = bonded(a, c);
    if ((bits(r.rare) & real) != 0) return false;
  } else {
    bool touching = false;
    LocalLanes dashpot;
    r = contact(a, c, load_lanes(q.closure + i), ~c.held, touching, dashpot);
    if (held != 0) {
      const Springs b = bonded(a, c);
      if ((bits(b.rare & c.held) & real) != 0) return false;
      r.traction = select3(c.held, b.traction, r.traction);
      r.slip1 = select(c.held, b.slip1, r.slip1);
      r.slip2 = select(c.held, b.slip2, r.slip2);
      r.shear = select(c.held, b.shear, r.shear);
    }
    sum.touching |= touching;
    if (touching) sum.dash.add(c.da * dashpot, c.s, c.t);
    sum.impact += c.da * r.normal;
  }
  store_lanes(q.slip1 + i, r.slip1);
  store_lanes(q.slip2 + i, r.slip2);
  sum.total.add(c.da * r.traction, c.s, c.t);
  sum.friction += c.da * r.shear;
  sum.held += __builtin_popcount(held & real);
  return true;
}

VOUSSOIR_INLINE void write_row(const Sums& s, Lanes extra1, Lanes extra2, double* row) noexcept {
  store_quad(row, sums_of(s.f.n, s.f.s1, s.f.s2, s.sf.n));
  store_quad(row + 4, sums_of(s.sf.s1, s.sf.s2, s.tf.n, s.tf.s1));
  store_quad(row + 8, sums_of(s.tf.s2, extra1, extra2, Lanes{}));
}

Local field(const FieldTable& f, int k, int lane) noexcept { return {f.value[k][0][lane], f.value[k][1][lane], f.value[k][2][lane]}; }

/// What the literal law found in the rare chunks of a side; empty between two sides.
struct Literal {
  SegmentTotals sum;
  bool any = false;
};

void add(SideSums& a, const SideSums& b) noexcept { a = {a.f + b.f, a.sf + b.sf, a.tf + b.tf}; }

/// The literal law for the points from `i` on, at most kWidth.
[[gnu::noinline]] void advance_literally(const Side& side, const FieldTable& f, int lane, const SideParts& parts, int i, StepClock clock,
                                         FailureOptions o, Literal& found, EventSink& sink) noexcept {
  SideFrame frame{};
  frame.d = field(f, 0, lane), frame.ds = field(f, 1, lane), frame.dt = field(f, 2, lane);
  frame.v = field(f, 3, lane), frame.vs = field(f, 4, lane), frame.vt = field(f, 5, lane);
  const PointsView& p = parts.points;
  const SegmentsView& q = parts.segments;
  const int live = p.n - i < kWidth ? p.n - i : kWidth, first = sink.count;
  const SegmentTotals r =
      advance_segments(side, parts.id, frame, {p.s + i, p.t + i, p.area + i, live},
                       {q.bond + i, q.first_mode + i, q.first_time + i, q.slip1 + i, q.slip2 + i, q.closure + i}, clock.dt, clock.time, o, sink);
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

/// All segments of one side.
VOUSSOIR_INLINE void advance_side(const SideBlock& block, int l, const FieldTable& f, int lane, const SideParts& parts, StepClock clock,
                                  FailureOptions o, Literal& found, SumRows& rows, DamagedSide& result, EventSink& sink) noexcept {
  const Law law = law_of(block, l, f, lane, parts, clock.dt, o);
  Totals sum;
  const int before = sink.count;
  for (int i = 0; i < parts.points.n; i += kWidth) {
    if (advance_chunk(law, parts.points, parts.segments, i, sum)) continue;
    advance_literally(side_of(block, l, parts), f, lane, parts, i, clock, o, found, sink);
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

// ---- kWidth sides again: from sums to forces on the elements

VOUSSOIR_INLINE SumLanes global_sums(const Frames& f, const SumRows* rows, double (SumRows::*part)[12]) noexcept {
  const auto row = [=](int l) { return rows[l].*part; };
  LocalLanes x[3];
  Lanes unused;
  load_columns(row, 0, x[0].n, x[0].s1, x[0].s2, x[1].n);
  load_columns(row, 4, x[1].s1, x[1].s2, x[2].n, x[2].s1);
  load_columns(row, 8, x[2].s2, unused, unused, unused);
  const auto global = [&](LocalLanes v) { return v.n * f.k.n + (v.s1 * f.t1 + v.s2 * f.t2); };
  return {global(x[0]), global(x[1]), global(x[2])};
}

/// How the faces of each lane's side lie to each other.
void report_facing(const SideBlock& block, int at, const FieldTable& f, unsigned chosen, DamagedSide* result) noexcept {
  const Lanes gap = least_opening(block, at, load_lanes(f.value[0][0]), load_lanes(f.value[1][0]), load_lanes(f.value[2][0]));
  const auto norm2 = [&](int k) {
    const Lanes n = load_lanes(f.value[k][0]);
    return n * n + square(load_lanes(f.value[k][1]), load_lanes(f.value[k][2]));
  };
  const Lanes slide2 = square(load_lanes(f.value[0][1]), load_lanes(f.value[0][2])), tilt2 = norm2(1) + norm2(2);
  for (int l = 0; l < kWidth; ++l) {
    if (!(chosen >> l & 1U)) continue;
    result[l].gap = gap[l], result[l].slide2 = slide2[l], result[l].tilt2 = tilt2[l];
  }
}

}  // namespace

unsigned advance_damaged(const SideBlock& block, int at, unsigned chosen, std::int64_t first, const SideParts* parts, Kinematics& k,
                         const Rows& rows, StepClock clock, FailureOptions o, SumLanes& sums, DamagedSide* result,
                         EventSink& sink) noexcept {
  k.n = (1.0 / sqrt(dot(k.n, k.n))) * k.n;
  FieldTable fields;
  const Frames f = frames(block, at, k, rows, fields);
  SumRows by_lane[kWidth];
  Literal found_literally;
  unsigned touching = 0;
  LaneMask mask{};
  for (int l = 0; l < kWidth; ++l) {
    if (!(chosen >> l & 1U)) {
      std::fill_n(by_lane[l].total, 12, 0.0);
      std::fill_n(by_lane[l].dash, 12, 0.0);
      continue;
    }
    advance_side(block, at + l, fields, l, parts[l], clock, o, found_literally, by_lane[l], result[l], sink);
    touching |= static_cast<unsigned>(result[l].touching) << l;
    mask[l] = -1;
  }
  const SumLanes found = global_sums(f, by_lane, &SumRows::total);
  sums = {select3(mask, found.f, sums.f), select3(mask, found.sf, sums.sf), select3(mask, found.tf, sums.tf)};
  if (touching != 0) scatter(block, at, first, wrench_of(k, global_sums(f, by_lane, &SumRows::dash)), touching, rows, true);
  report_facing(block, at, fields, chosen, result);
  return touching;
}

}  // namespace voussoir::kernels
