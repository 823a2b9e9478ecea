// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/lanes.h"
#include "kernels/side.h"

// Damaged sides, several segments at a time. Only what happens all the time is here: elastic, slipping, touching, open. A chunk in which a
// bond breaks, first yields or is crushed goes through the literal law (segment_law.h), so each rare event is decided in one place.
namespace voussoir::kernels {

namespace {

struct LocalLanes {
  Lanes n, s1, s2;
};
VOUSSOIR_INLINE LocalLanes operator+(LocalLanes a, LocalLanes b) noexcept { return {a.n + b.n, a.s1 + b.s1, a.s2 + b.s2}; }
VOUSSOIR_INLINE LocalLanes operator*(Lanes f, LocalLanes a) noexcept { return {f * a.n, f * a.s1, f * a.s2}; }
VOUSSOIR_INLINE LocalLanes spread(Local v) noexcept { return {lanes(v.n), lanes(v.s1), lanes(v.s2)}; }

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
  Lanes stored_bonds{}, stored_contact{}, friction{}, impact{};
  Lanes gap = lanes(1e300);
};

/// A chunk of segments, loaded.
struct Chunk {
  Lanes s, t, da;
  LaneMask held, slipped, crushed;
  LocalLanes u, du, rate;
  Lanes slip1, slip2, closure;
};

VOUSSOIR_INLINE Chunk load(const SideFrame& f, double factor, PointsView p, SegmentsView q, int i, double step) noexcept {
  Chunk c;
  c.s = load_lanes(p.s + i), c.t = load_lanes(p.t + i), c.da = factor * load_lanes(p.area + i);
  const LaneMask bond = widened(reinterpret_cast<const unsigned char*>(q.bond + i));
  c.held = bond <= static_cast<long long>(Bond::slipped);
  c.slipped = bond == static_cast<long long>(Bond::slipped);
  c.crushed = bond == static_cast<long long>(Bond::crushed);
  c.slip1 = load_lanes(q.slip1 + i), c.slip2 = load_lanes(q.slip2 + i), c.closure = load_lanes(q.closure + i);
  c.u = spread(f.d) + (c.s * spread(f.ds) + c.t * spread(f.dt));
  c.rate = spread(f.v) + (c.s * spread(f.vs) + c.t * spread(f.vt));
  c.du = lanes(step) * c.rate;
  return c;
}

/// Springs of a chunk after this step.
struct Springs {
  LocalLanes x;         // elongation now
  LocalLanes before;    // and before
  LocalLanes traction;  // Pa
  LocalLanes dashpot;
  LaneMask closed;  // contacts that carry force
  LaneMask rare;    // lanes that the literal law must decide
};

VOUSSOIR_INLINE Lanes bonded_limit(Lanes sigma, const Strength& s, FailureOptions o) noexcept {
  const Lanes none = lanes(std::numeric_limits<double>::infinity());
  if (!o.shear) return none;
  const Lanes coulomb = s.cohesion - sigma * s.tan_phi;
  const Lanes in_tension = o.in_tension == ShearInTension::cohesion ? lanes(s.cohesion)
                           : o.in_tension == ShearInTension::none   ? none
                                                                    : max(coulomb, Lanes{});
  return select(sigma < 0.0, coulomb, in_tension);
}

/// Bonded lanes: elastic, or slipping on the shear limit.
VOUSSOIR_INLINE void bonded(const Chunk& c, const Side& side, FailureOptions o, Springs& r) noexcept {
  const Stiffness k = side.k;
  r.x = {c.u.n - c.closure, c.u.s1 - c.slip1, c.u.s2 - c.slip2};
  r.before = {r.x.n - c.du.n, r.x.s1 - c.du.s1, r.x.s2 - c.du.s2};
  const Lanes sigma = k.kn * r.x.n;
  const Lanes tau = k.ks * sqrt(r.x.s1 * r.x.s1 + r.x.s2 * r.x.s2);
  const Lanes limit = bonded_limit(sigma, side.strength, o);
  const LaneMask yields = tau > limit;
  const Lanes fm2 = lanes(side.strength.compression * side.strength.compression);
  const LaneMask cap = (sigma < 0.0) & (sigma * sigma + side.strength.cap * tau * tau > fm2);
  r.rare = (sigma > side.strength.tension) | cap;
  r.rare |= o.brittle ? yields : yields & ~c.slipped;
  const Lanes scale = select(yields, limit / tau, lanes(1.0));
  r.x.s1 = scale * r.x.s1;
  r.x.s2 = scale * r.x.s2;
  r.traction = {sigma, k.ks * r.x.s1, k.ks * r.x.s2};
  r.dashpot = LocalLanes{};
}

/// See detail::dashpot_share.
VOUSSOIR_INLINE Lanes dashpot_share(Lanes pp, Lanes pd, Lanes dd, Lanes limit2) noexcept {
  const Lanes p2 = min(pp, limit2);
  const LaneMask within = p2 + 2.0 * pd + dd <= limit2;
  const Lanes root = sqrt(max(pd * pd + dd * (limit2 - p2), Lanes{}));
  return select(within, lanes(1.0), max((root - pd) / dd, Lanes{}));
}

/// Lanes in contact: see contact_traction in segment_law.h.
VOUSSOIR_INLINE void contact(const Chunk& c, const Side& side, Springs& r) noexcept {
  const Stiffness k = side.k;
  const Lanes zero{};
  r.x = {c.u.n - c.closure, c.slip1 + c.du.s1, c.slip2 + c.du.s2};
  r.before = {min(r.x.n - c.du.n, zero), c.slip1, c.slip2};
  r.closed = r.x.n < 0.0;
  if (bits(r.closed) == 0) {  // all open, as most broken segments are
    r.x = LocalLanes{};
    return;
  }
  const Lanes dn = min(k.cn * c.rate.n, -k.kn * r.x.n);
  const Lanes limit = -(k.kn * r.x.n + dn) * side.strength.tan_phi;
  const Lanes one = lanes(1.0), spring = k.ks * sqrt(r.x.s1 * r.x.s1 + r.x.s2 * r.x.s2);
  const Lanes f = select(r.closed, select(spring > limit, limit / spring, one), zero);
  r.x.n = select(r.closed, r.x.n, zero);
  r.x.s1 = f * r.x.s1;
  r.x.s2 = f * r.x.s2;
  const Lanes p1 = k.ks * r.x.s1, p2 = k.ks * r.x.s2, d1 = k.cs * c.rate.s1, d2 = k.cs * c.rate.s2;
  const Lanes h = select(r.closed, dashpot_share(p1 * p1 + p2 * p2, p1 * d1 + p2 * d2, d1 * d1 + d2 * d2, limit * limit), zero);
  r.dashpot = {select(r.closed, dn, zero), h * d1, h * d2};
  r.traction = {k.kn * r.x.n + r.dashpot.n, p1 + r.dashpot.s1, p2 + r.dashpot.s2};
}

VOUSSOIR_INLINE LocalLanes select3(LaneMask m, LocalLanes a, LocalLanes b) noexcept {
  return {select(m, a.n, b.n), select(m, a.s1, b.s1), select(m, a.s2, b.s2)};
}

VOUSSOIR_INLINE Springs springs(const Chunk& c, const Side& side, FailureOptions o) noexcept {
  constexpr unsigned kAll = (1U << kWidth) - 1U;
  const unsigned held = bits(c.held);
  Springs b{}, t{};
  if (held != 0) bonded(c, side, o, b);
  if (held == kAll) {
    b.rare |= c.crushed;
    return b;
  }
  contact(c, side, t);
  if (held == 0) {
    t.rare = c.crushed;
    return t;
  }
  Springs r;
  r.x = select3(c.held, b.x, t.x);
  r.before = select3(c.held, b.before, t.before);
  r.traction = select3(c.held, b.traction, t.traction);
  r.dashpot = select3(c.held, b.dashpot, t.dashpot);
  r.closed = ~c.held & t.closed;
  r.rare = (c.held & b.rare) | c.crushed;
  return r;
}

VOUSSOIR_INLINE void accumulate(const Chunk& c, const Springs& r, const Stiffness& k, Totals& a) noexcept {
  const Lanes zero{};
  a.total.add(c.da * r.traction, c.s, c.t);
  if (bits(r.closed) != 0) a.dash.add(c.da * r.dashpot, c.s, c.t);
  const auto square = [](LocalLanes v) { return v.s1 * v.s1 + v.s2 * v.s2; };
  const Lanes stored = c.da * (0.5 * k.kn * (r.x.n * r.x.n) + 0.5 * k.ks * square(r.x));
  a.stored_bonds += select(c.held, stored, zero);
  a.stored_contact += select(c.held, zero, stored);
  const Lanes normal = 0.5 * k.kn * (r.before.n * r.before.n - r.x.n * r.x.n + (r.before.n + r.x.n) * c.du.n);
  const Lanes shear = 0.5 * k.ks * (square(r.before) - square(r.x) + (r.before.s1 + r.x.s1) * c.du.s1 + (r.before.s2 + r.x.s2) * c.du.s2);
  a.friction += c.da * shear;
  a.impact += select(c.held, zero, c.da * normal);
  a.gap = min(a.gap, select(c.held, lanes(1e300), c.u.n - c.closure));
}

/// Writes the history back: contacts always, bonds only where they slipped (round-off must not creep into an elastic bond).
VOUSSOIR_INLINE void store(const Chunk& c, const Springs& r, SegmentsView q, int i) noexcept {
  const LaneMask moved = c.held & c.slipped;
  store_lanes(q.slip1 + i, select(c.held, select(moved, c.u.s1 - r.x.s1, c.slip1), r.x.s1));
  store_lanes(q.slip2 + i, select(c.held, select(moved, c.u.s2 - r.x.s2, c.slip2), r.x.s2));
}

VOUSSOIR_INLINE double sum(Lanes v) noexcept {
  double r = 0.0;
  for (int l = 0; l < kWidth; ++l) r += v[l];
  return r;
}
VOUSSOIR_INLINE Local sum(LocalLanes v) noexcept { return {sum(v.n), sum(v.s1), sum(v.s2)}; }
VOUSSOIR_INLINE SideSums sum(const Sums& v) noexcept { return {sum(v.f), sum(v.sf), sum(v.tf)}; }

void add(Vec3& a, Vec3 b) noexcept { a += b; }

/// Adds what the literal law found for one chunk.
void add_part(SideResult& r, const SideResult& part) noexcept {
  add(r.wrench.force, part.wrench.force);
  add(r.wrench.torque_a, part.wrench.torque_a);
  add(r.wrench.torque_b, part.wrench.torque_b);
  add(r.wrench.dash_force, part.wrench.dash_force);
  add(r.wrench.dash_torque_a, part.wrench.dash_torque_a);
  add(r.wrench.dash_torque_b, part.wrench.dash_torque_b);
  r.stored_bonds += part.stored_bonds;
  r.stored_contact += part.stored_contact;
  r.friction += part.friction;
  r.impact += part.impact;
  r.fracture += part.fracture;
  r.held += part.held;
  if (part.gap < r.gap) r.gap = part.gap;
}

/// Adds the sums of the vector chunks.
void add_sums(SideResult& r, const SideFrame& f, const Totals& a) noexcept {
  SideResult part;
  part.gap = 1e300;
  to_wrench(f, sum(a.total), part.wrench.force, part.wrench.torque_a, part.wrench.torque_b);
  to_wrench(f, sum(a.dash), part.wrench.dash_force, part.wrench.dash_torque_a, part.wrench.dash_torque_b);
  part.stored_bonds = sum(a.stored_bonds);
  part.stored_contact = sum(a.stored_contact);
  part.friction = sum(a.friction);
  part.impact = sum(a.impact);
  for (int l = 0; l < kWidth; ++l) part.gap = a.gap[l] < part.gap ? a.gap[l] : part.gap;
  add_part(r, part);
}

}  // namespace

SideResult advance_side(const Side& side, std::int32_t id, const SideFrame& f, PointsView p, SegmentsView q, double step, double time,
                        FailureOptions o, EventSink& sink) noexcept {
  SideResult r;
  r.gap = 1e300;
  Totals a;
  for (int i = 0; i < p.n; i += kWidth) {
    const int live = p.n - i < kWidth ? p.n - i : kWidth;
    const unsigned real = (1U << live) - 1U;
    const Chunk c = load(f, side.factor, p, q, i, step);
    const Springs s = springs(c, side, o);
    if ((bits(s.rare) & real) != 0) {
      const int first = sink.count;
      const SideResult part = advance_side_reference(
          side, id, f, {p.s + i, p.t + i, p.area + i, live},
          {q.bond + i, q.first_mode + i, q.first_time + i, q.slip1 + i, q.slip2 + i, q.closure + i}, step, time, o, sink);
      for (int e = first; e < sink.count; ++e) sink.data[e].point += i;
      add_part(r, part);
      continue;
    }
    store(c, s, q, i);
    accumulate(c, s, side.k, a);
    r.held += __builtin_popcount(bits(c.held) & real);
  }
  add_sums(r, f, a);
  r.touching = r.gap < 0.0;
  return r;
}

}  // namespace voussoir::kernels
