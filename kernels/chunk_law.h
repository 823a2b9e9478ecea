// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "kernels/laws/tension.h"
#include "kernels/side_lanes.h"

/// The law of kWidth segments of one side at a time. Only frequent states are handled here: elastic, slipping, touching, open; a chunk of
/// points in which a bond breaks, first yields or is crushed is left to the literal law (segment_law.h), so each rare event is decided in
/// one place. Losses are computed only for chunks in which a point slips, closes or opens: in all other chunks they are exactly zero.
namespace voussoir::kernels {

VOUSSOIR_INLINE Lanes square(Lanes a, Lanes b) noexcept { return a * a + b * b; }

/// Data common to all points of one side.
struct Law {
  LocalLanes d, ds, dt, v, vs, vt;
  Stiffness k;
  Strength strength;
  double factor, step;
  FailureOptions o;
};

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
  LocalLanes traction;      // Pa
  Lanes slip1, slip2;       // history after the step
  LaneMask rare{};          // lanes that the literal law must decide
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

/// Loss of the shear springs [J/m2], U_before − U_now + ½ (f_before + f_now)·du: see advance_segment.
VOUSSOIR_INLINE Lanes shear_loss(double ks, Lanes b1, Lanes b2, Lanes x1, Lanes x2, Lanes du1, Lanes du2) noexcept {
  return 0.5 * ks * (square(b1, b2) - square(x1, x2) + (b1 + x1) * du1 + (b2 + x2) * du2);
}

/// Bonded lanes: elastic, or slipping on the shear limit.
VOUSSOIR_INLINE Springs bonded(const Law& a, const Chunk& c) noexcept {
  Springs r;
  const Lanes sigma = a.k.kn * c.u.n;  // a bonded segment has no closure: crushing breaks the bond
  Lanes x1 = c.u.s1 - c.slip1, x2 = c.u.s2 - c.slip2;
  const Lanes tau2 = a.k.ks * a.k.ks * square(x1, x2);
  const Lanes limit = bonded_limit(sigma, a);
  const LaneMask yields = tau2 > limit * limit;
  const Lanes fm2 = lanes(a.strength.compression * a.strength.compression);
  r.rare = tension_fails(sigma, a.strength.tension) | ((sigma < 0.0) & (sigma * sigma + a.strength.cap * tau2 > fm2));
  r.rare |= a.o.brittle ? yields : yields & ~c.slipped;
  r.slip1 = c.slip1, r.slip2 = c.slip2;
  if (bits(yields & c.held) != 0) {
    const Lanes scale = select(yields, limit / sqrt(tau2), lanes(1.0));
    const LocalLanes v = rate(a, c);
    const Lanes du1 = a.step * v.s1, du2 = a.step * v.s2, b1 = x1 - du1, b2 = x2 - du2;
    x1 = scale * x1, x2 = scale * x2;
    // Slip changes only in lanes that slip: round-off must not add slip to an elastic bond.
    r.slip1 = select(yields & c.slipped, c.u.s1 - x1, c.slip1);
    r.slip2 = select(yields & c.slipped, c.u.s2 - x2, c.slip2);
    r.shear = select(yields, shear_loss(a.k.ks, b1, b2, x1, x2, du1, du2), Lanes{});
  }
  r.traction = {sigma, a.k.ks * x1, a.k.ks * x2};
  return r;
}

/// Share of the dashpot force within the limit, see detail::dashpot_share. The spring alone is within the limit.
VOUSSOIR_INLINE Lanes dashpot_share(Lanes pp, Lanes pd, Lanes dd, Lanes limit2) noexcept {
  const LaneMask within = pp + 2.0 * pd + dd <= limit2;
  if (bits(~within) == 0) return lanes(1.0);
  const Lanes root = sqrt(max(pd * pd + dd * (limit2 - pp), Lanes{}));
  return select(within, lanes(1.0), max((root - pd) / dd, Lanes{}));
}

/// Springs and dashpots of the closed lanes: see contact_traction in segment_law.h.
VOUSSOIR_INLINE void closed_contact(const Law& a, const Chunk& c, LocalLanes v, Lanes xn, LaneMask mine, LaneMask closed, Springs& r,
                                    LocalLanes& dashpot) noexcept {
  const Lanes zero{};
  const Lanes du1 = a.step * v.s1, du2 = a.step * v.s2;
  Lanes x1 = c.slip1 + du1, x2 = c.slip2 + du2;
  const Lanes dn = min(a.k.cn * v.n, a.o.dashpot_excess - a.k.kn * xn);
  const Lanes limit = max(-(a.k.kn * xn + dn) * a.strength.friction, zero), limit2 = limit * limit;
  Lanes spring2 = a.k.ks * a.k.ks * square(x1, x2);
  const LaneMask cut = closed & (spring2 > limit2);
  if (bits(cut) != 0) {
    const Lanes f = select(cut, limit / sqrt(spring2), lanes(1.0));
    x1 = f * x1, x2 = f * x2;
    spring2 = min(spring2, limit2);
  }
  const Lanes p1 = a.k.ks * x1, p2 = a.k.ks * x2, d1 = a.k.cs * v.s1, d2 = a.k.cs * v.s2;
  const Lanes h = dashpot_share(spring2, p1 * d1 + p2 * d2, square(d1, d2), limit2 + a.o.dashpot_excess);
  dashpot = select3(closed, LocalLanes{dn, h * d1, h * d2}, LocalLanes{});
  r.traction = select3(closed, LocalLanes{a.k.kn * xn, p1, p2}, LocalLanes{}) + dashpot;
  r.slip1 = select(closed, x1, zero);
  r.slip2 = select(closed, x2, zero);
  // No loss in a point that was closed, stays closed and does not slip.
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
  // All lanes open now and before, as most broken segments are: no force, no history.
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
  c.slip1 = load_lanes(q.springs_at(i).slip1), c.slip2 = load_lanes(q.springs_at(i).slip2);
  c.u = a.d + (c.s * a.ds + c.t * a.dt);
  return c;
}

/// Advances one chunk. Returns false, with nothing written, if the literal law must decide.
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
    r = contact(a, c, load_lanes(q.springs_at(i).closure), ~c.held, touching, dashpot);
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
  store_lanes(q.springs_at(i).slip1, r.slip1);
  store_lanes(q.springs_at(i).slip2, r.slip2);
  sum.total.add(c.da * r.traction, c.s, c.t);
  sum.friction += c.da * r.shear;
  sum.held += __builtin_popcount(held & real);
  return true;
}

}  // namespace voussoir::kernels
