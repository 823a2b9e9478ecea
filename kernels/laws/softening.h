// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/laws/laws_of_side.h"
#include "kernels/laws/segment_law.h"

/// Softening bonds: THEORY.md (13a)-(13e). One number per segment, its *wear* κ, measures its damage: both opening and slip increase it, so
/// a bond that has slipped is weaker in tension, and vice versa. Segments that do not soften, and all that are no longer bonded, follow
/// segment_law.h.
namespace voussoir::kernels {

/// Whether some bonded segment of [first, last) has wear.
inline bool is_worn(const SoftSide& side, int first, int last) noexcept {
  double sum = 0.0;  // wear is never negative, and is reset to zero where a bond breaks
  for (int i = first; i < last; ++i) sum += side.wear[i];
  return sum > 0.0;
}

namespace detail {

/// exp(−x) for x ≥ 0, without the standard library, so that its bits are the same everywhere.
inline double decay(double x) noexcept {
  constexpr double kLog2E = 1.4426950408889634, kLn2High = 0x1.62e42fee00000p-1, kLn2Low = 0x1.a39ef35793c76p-33;
  const double halvings = std::floor(std::min(x, 700.0) * kLog2E + 0.5);
  const double r = (halvings * kLn2High - std::min(x, 700.0)) + halvings * kLn2Low;
  double sum = 1.0;
  for (int i = 12; i > 0; --i) sum = 1.0 + sum * (r * (1.0 / i));
  return std::ldexp(sum, -static_cast<int>(halvings));
}

}  // namespace detail

/// Remaining share of f_t and c.
inline double share_left(double wear, const Softening& a) noexcept {
  return a.linear ? std::max(0.0, 1.0 - 0.5 * wear) : detail::decay(wear);
}

/// Wear at which the bond is gone: the remaining share is a thousandth (exponential) or zero (linear).
inline double wear_at_end(const Softening& a) noexcept { return a.linear ? 2.0 : 6.907755278982137; }

/// Normal stiffness of a bonded segment [Pa/m]: full under compression, the secant of (13b) under tension.
inline double stiffness_left(double n, double wear, double kn, const Softening& a) noexcept {
  return n > 0.0 && wear > 0.0 ? kn * share_left(wear, a) / (1.0 + wear * a.opening) : kn;
}
/// stiffness_left for a known share `left`, whose computation costs more than the rest of the law.
inline double stiffness_left(double n, double wear, double left, double kn, const Softening& a) noexcept {
  return n > 0.0 && wear > 0.0 ? kn * left / (1.0 + wear * a.opening) : kn;
}

inline double stored_when_worn(Local x, double wear, Stiffness k, const Softening& a) noexcept {
  return 0.5 * (stiffness_left(x.n, wear, k.kn, a) * x.n * x.n + k.ks * (x.s1 * x.s1 + x.s2 * x.s2));
}

namespace detail {

/// A bonded segment within a step.
struct Wearing {
  Local x;                    // m, elongation of its springs
  double wear = 0.0;          // at this point of the step
  double left = 1.0;          // share_left(wear)
  double cohesive = 0.0;      // share of cohesion in the shear limit under which the segment slid
  Mode reached = Mode::none;  // the limit that increased the wear
  Mode broke = Mode::none;
  bool open = false;
};

/// Increases the wear by opening beyond the limit: (13b).
inline void wear_by_opening(Wearing& w, Stiffness k, Strength s, const Softening& a) noexcept {
  const double sigma = k.kn * w.x.n;  // of a bond without wear
  if (!tension_fails(sigma, s.tension * (1.0 + w.wear * a.opening))) return;
  w.reached = Mode::tension;
  if (a.opening > 0.0) {
    w.wear = (sigma / s.tension - 1.0) / a.opening;
    w.left = share_left(w.wear, a);
  } else {
    w.broke = Mode::tension, w.open = true;
  }
}

/// Slides the segment at the shear limit and increases the wear by the slip: (13c), (13d).
inline void wear_by_slip(Wearing& w, SegmentState& q, Local u, Stiffness k, Strength s, const Softening& a, FailureOptions o) noexcept {
  const double left = w.left, tan_phi = s.friction + (s.tan_phi - s.friction) * left;
  const double sigma = stiffness_left(w.x.n, w.wear, left, k.kn, a) * w.x.n, tau = k.ks * std::sqrt(w.x.s1 * w.x.s1 + w.x.s2 * w.x.s2);
  const double limit = shear_limit(sigma, {.cohesion = s.cohesion * left, .tan_phi = tan_phi}, o);
  if (tau <= limit) return;
  if (w.reached == Mode::none) w.reached = Mode::shear;
  double stress = limit;
  if (a.slip > 0.0) {
    w.wear += (tau - limit) / (k.ks * a.slip);
    w.left = share_left(w.wear, a);
    stress = std::max(0.0, limit - s.cohesion * (left - w.left));
    w.cohesive = limit > 0.0 ? std::min(1.0, s.cohesion * left / limit) : 1.0;
  } else if (o.brittle) {
    w.broke = Mode::shear, w.open = sigma >= 0.0;
  }
  w.x.s1 *= stress / tau, w.x.s2 *= stress / tau;
  q.slip1 = u.s1 - w.x.s1, q.slip2 = u.s2 - w.x.s2;
  if (a.dilatancy > 0.0 && w.x.n < 0.0) {
    q.closure += a.dilatancy * left * (tau - stress) / k.ks;
    w.x.n = u.n - q.closure;
  }
}

/// Books the losses of the springs in this step, (28). \param before  the segment before the step
inline void book_losses(SegmentStep& out, const Wearing& before, const Wearing& now, Local du, Stiffness k, const Softening& a) noexcept {
  const Local b = before.x, x = now.x;
  const double kb = stiffness_left(b.n, before.wear, before.left, k.kn, a);
  const double kx = now.open ? 0.0 : stiffness_left(x.n, now.wear, now.left, k.kn, a);
  const double normal = 0.5 * (kb * b.n * b.n - kx * x.n * x.n + (kb * b.n + kx * x.n) * du.n);
  const double shear = 0.5 * k.ks * (b.s1 * b.s1 + b.s2 * b.s2 - x.s1 * x.s1 - x.s2 * x.s2 + (b.s1 + x.s1) * du.s1 + (b.s2 + x.s2) * du.s2);
  if (now.broke != Mode::none) {
    out.fracture = normal + shear;
  } else if (now.reached != Mode::none) {
    const bool dilated = b.n < 0.0 && x.n < 0.0;  // then the pressure does work on the sliding faces
    out.fracture = now.cohesive * shear + (dilated ? 0.0 : normal);
    out.friction = (1.0 - now.cohesive) * shear + (dilated ? normal : 0.0);
  } else {
    out.friction = shear;
    if (b.n * x.n < 0.0) out.impact = normal;  // the stiffness changes at closing, within the step
  }
}

}  // namespace detail

/// Advances one segment of a softening side by one step; see advance_segment.
inline SegmentStep advance_soft_segment(SegmentState& q, double& wear, Local u, Local rate, double dt, Stiffness k, Strength s,
                                        const Softening& a, FailureOptions o) noexcept {
  if (!holds(q.bond)) return advance_segment(q, u, rate, dt, k, s, o);
  SegmentStep out;
  const Local du = dt * rate;
  const double left = wear > 0.0 ? share_left(wear, a) : 1.0;
  detail::Wearing before{.x = detail::elongation_before(q, u, du), .wear = wear, .left = left};
  detail::Wearing now{.x = {u.n - q.closure, u.s1 - q.slip1, u.s2 - q.slip2}, .wear = wear, .left = left};
  detail::wear_by_opening(now, k, s, a);
  if (now.broke == Mode::none) {
    detail::wear_by_slip(now, q, u, k, s, a, o);
    if (now.broke == Mode::none && now.wear >= wear_at_end(a)) now.broke = now.reached, now.open = now.x.n >= 0.0;
    if (!now.open && detail::return_to_cap(now.x, q, u, k, s)) now.broke = Mode::compression;
  }
  const bool first = q.bond == Bond::bonded;
  if (now.broke == Mode::none) {
    detail::book_losses(out, before, now, du, k, a);
    wear = now.wear;
    const double kn = stiffness_left(now.x.n, wear, now.left, k.kn, a);
    out.traction = {kn * now.x.n, k.ks * now.x.s1, k.ks * now.x.s2};
    out.stored = 0.5 * (kn * now.x.n * now.x.n + k.ks * (now.x.s1 * now.x.s1 + now.x.s2 * now.x.s2));
    if (first) out.reached = now.reached;
    if (now.reached != Mode::none) q.bond = Bond::slipped;
    return out;
  }
  q.bond = now.broke == Mode::compression ? Bond::crushed : Bond::contact;
  if (now.open) {
    now.x = {};
  } else {
    detail::contact_traction(now.x, rate, k, s.friction, o.dashpot_excess, out);
  }
  detail::book_losses(out, before, now, du, k, a);
  wear = 0.0;
  q.slip1 = now.x.s1, q.slip2 = now.x.s2;
  out.stored = detail::stored_energy(now.x, k);
  out.broke = now.broke;
  if (first) out.reached = now.reached == Mode::none ? now.broke : now.reached;
  return out;
}

}  // namespace voussoir::kernels
