// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/law.h"
#include "kernels/laws/local.h"
#include "kernels/laws/tension.h"

/// The constitutive law of one segment, literally: Eqs. 4-9, THEORY.md (11)-(19). The plain twin of the vector kernels; every rare event
/// (breaking, crushing) is decided here for both.
///
/// Components (n, 1, 2): along the outward normal of the master, and two tangents. u = x_slave − x_master, so tension is positive.
namespace voussoir::kernels {

/// History of a segment. While bonded, slip is the plastic slip; in contact it is the elongation of the shear spring [m].
/// closure is the opening [m] at which the normal spring has no force: negative after crushing, and for a point found deep inside; positive
/// by dilatancy (13e), in a joint that stiffens as it closes (closing.h), and for points that a tilted joint hands over to patches.
struct SegmentState {
  Bond bond = Bond::bonded;
  double slip1 = 0.0, slip2 = 0.0, closure = 0.0;
};

/// Result of a segment's step, per area: total traction on the master, its dashpot part, stored and lost energy.
struct SegmentStep {
  Local traction;             // Pa, springs and dashpots
  Local dashpot;              // Pa
  double stored = 0.0;        // J/m2, in the springs after the step
  double friction = 0.0;      // J/m2, lost by slip in this step
  double impact = 0.0;        // J/m2, lost or gained in the step in which a contact closes or opens (trapezoid rule over the kink)
  double fracture = 0.0;      // J/m2, lost by breaking in this step
  Mode reached = Mode::none;  // limit reached for the first time in this step
  Mode broke = Mode::none;    // mode by which the bond broke in this step
};

/// Shear limit of a bonded segment: Eq. 6 and `shear_in_tension`, THEORY.md (15).
inline double shear_limit(double sigma, Strength s, FailureOptions o) noexcept {
  if (!o.shear) return std::numeric_limits<double>::infinity();
  if (sigma < 0.0) return s.cohesion - sigma * s.tan_phi;
  switch (o.in_tension) {
    case ShearInTension::cohesion:
      return s.cohesion;
    case ShearInTension::none:
      return std::numeric_limits<double>::infinity();
    case ShearInTension::coulomb:
      return std::max(0.0, s.cohesion - sigma * s.tan_phi);
  }
  return s.cohesion;
}

namespace detail {

/// Elongation of the springs of a closed or bonded segment before this step, from the rates, since the state holds no old displacement.
inline Local elongation_before(const SegmentState& q, Local u, Local du) noexcept {
  const double n = u.n - du.n - q.closure;
  if (holds(q.bond)) return {n, u.s1 - du.s1 - q.slip1, u.s2 - du.s2 - q.slip2};
  return {std::min(n, 0.0), q.slip1, q.slip2};
}

inline double stored_energy(Local x, Stiffness k) noexcept { return 0.5 * (k.kn * x.n * x.n + k.ks * (x.s1 * x.s1 + x.s2 * x.s2)); }

/// Scales the elastic elongation back to the compression cap (Eq. 7) and keeps the rest as closure and slip. Returns whether the cap was
/// exceeded.
inline bool return_to_cap(Local& x, SegmentState& q, Local u, Stiffness k, Strength s) noexcept {
  const double sigma = k.kn * x.n;
  const double tau2 = k.ks * k.ks * (x.s1 * x.s1 + x.s2 * x.s2);
  const double f2 = sigma * sigma + s.cap * tau2;
  if (sigma >= 0.0 || f2 <= s.compression * s.compression) return false;
  x = (s.compression / std::sqrt(f2)) * x;
  q.closure = u.n - x.n;
  return true;
}

/// The largest h in [0, 1] for which a spring p and a dashpot h·d together stay within the limit L: |p + h d| ≤ L. Arguments: p·p ≤ L²,
/// p·d, d·d, L².
inline double dashpot_share(double pp, double pd, double dd, double limit2) noexcept {
  if (pp + 2.0 * pd + dd <= limit2) return 1.0;
  return std::max(0.0, (std::sqrt(std::max(0.0, pd * pd + dd * (limit2 - pp))) - pd) / dd);
}

/// Friction contact, closed (x.n < 0): the spring is cut to Coulomb's limit (Eq. 8), the dashpot is cut to the rest of the limit. Scaling
/// their sum and giving the spring the remainder would stretch the spring backwards in fast sliding, which would create energy.
/// \param excess  kBounded or kUnbounded
inline void contact_traction(Local& x, Local rate, Stiffness k, double tan_phi, double excess, SegmentStep& out) noexcept {
  // Bounded: the total normal force never pulls, since the dashpot at most cancels the spring.
  const double dn = std::min(k.cn * rate.n, excess - k.kn * x.n);
  const double limit = std::max(0.0, -(k.kn * x.n + dn) * tan_phi);  // with fused operations the sum may exceed 0 by round-off
  const double spring = k.ks * std::sqrt(x.s1 * x.s1 + x.s2 * x.s2);
  if (spring > limit) x.s1 *= limit / spring, x.s2 *= limit / spring;
  const double p1 = k.ks * x.s1, p2 = k.ks * x.s2, d1 = k.cs * rate.s1, d2 = k.cs * rate.s2;
  const double h = dashpot_share(std::min(p1 * p1 + p2 * p2, limit * limit), p1 * d1 + p2 * d2, d1 * d1 + d2 * d2, limit * limit + excess);
  out.dashpot = {dn, h * d1, h * d2};
  out.traction = {k.kn * x.n + dn, p1 + h * d1, p2 + h * d2};
}

}  // namespace detail

/// Advances one segment by one step. `u` displacement [m] and `rate` velocity [m/s] of the slave relative to the master at the contact
/// point.
inline SegmentStep advance_segment(SegmentState& q, Local u, Local rate, double dt, Stiffness k, Strength s, FailureOptions o) noexcept {
  SegmentStep out;
  const Local du = dt * rate;
  const Local before = detail::elongation_before(q, u, du);
  const bool held = holds(q.bond);
  Local x;            // elongation of the springs now
  bool open = false;  // no force
  if (held) {
    x = {u.n - q.closure, u.s1 - q.slip1, u.s2 - q.slip2};
    const double sigma = k.kn * x.n;
    const double tau = k.ks * std::sqrt(x.s1 * x.s1 + x.s2 * x.s2);
    const double limit = shear_limit(sigma, s, o);
    if (tension_fails(sigma, s.tension)) {  // Eq. 5
      out.broke = Mode::tension;
      open = true;
    } else {
      if (tau > limit) {  // Eq. 6
        x.s1 *= limit / tau, x.s2 *= limit / tau;
        q.slip1 = u.s1 - x.s1, q.slip2 = u.s2 - x.s2;  // only here: round-off of an elastic step must not change the slip
        if (o.brittle) {
          out.broke = Mode::shear;
          open = sigma >= 0.0;
        } else if (q.bond == Bond::bonded) {
          q.bond = Bond::slipped;
          out.reached = Mode::shear;
        }
      }
      if (detail::return_to_cap(x, q, u, k, s)) out.broke = Mode::compression;  // Eq. 7
    }
    if (out.broke == Mode::none) {
      out.traction = {k.kn * x.n, k.ks * x.s1, k.ks * x.s2};
    } else {
      if (out.reached == Mode::none) out.reached = out.broke;
      q.bond = out.broke == Mode::compression ? Bond::crushed : Bond::contact;
      // Eq. 8 at once: a segment that is still closed goes on as a contact, without a jump of its normal force.
      if (!open) detail::contact_traction(x, rate, k, s.friction, o.dashpot_excess, out);
    }
  } else {
    x = {u.n - q.closure, q.slip1 + du.s1, q.slip2 + du.s2};
    open = x.n >= 0.0;
    if (!open) {
      if (q.bond == Bond::crushed) detail::return_to_cap(x, q, u, k, s);
      detail::contact_traction(x, rate, k, s.friction, o.dashpot_excess, out);
    }
  }
  if (open) {
    x = {};
    q.bond = Bond::contact;
  }
  if (!holds(q.bond)) q.slip1 = x.s1, q.slip2 = x.s2;
  out.stored = detail::stored_energy(x, k);
  // Loss of the springs in this step, THEORY.md (28): U_before − U_now + ½ (f_before + f_now)·du, the trapezoid rule of the scheme; zero
  // while elastic.
  const double normal = 0.5 * k.kn * (before.n * before.n - x.n * x.n + (before.n + x.n) * du.n);
  const double shear =
      0.5 * k.ks *
      (before.s1 * before.s1 + before.s2 * before.s2 - x.s1 * x.s1 - x.s2 * x.s2 + (before.s1 + x.s1) * du.s1 + (before.s2 + x.s2) * du.s2);
  if (out.broke != Mode::none) {
    out.fracture = normal + shear;
  } else {
    const bool crushing = q.bond == Bond::crushed;  // plastic closure counts as loss of the material, not of an impact
    out.friction = crushing ? shear + normal : shear;
    out.impact = held || crushing ? 0.0 : normal;
  }
  return out;
}

}  // namespace voussoir::kernels
