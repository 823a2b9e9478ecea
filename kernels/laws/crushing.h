// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "kernels/laws/laws_of_side.h"
#include "kernels/laws/segment_law.h"
#include "kernels/segments.h"

/// Pressure that a contact bears, and how its surface gives way beyond it: THEORY.md (19a)-(19c). What is crushed is gone for good: the
/// point lies that much deeper in its face from then on, whoever it meets. So crushing lowers the closure of a point, and the laws of
/// contact (segment_law.h, patch_work.h) go on from there as they are.
namespace voussoir::kernels {

/// Pressure [Pa] that a point bears after being crushed by `crushed` [m].
inline double bearing(double crushed, const Crushing& a) noexcept {
  return a.slope > 0.0 ? std::max(a.residual, a.strength - a.slope * crushed) : a.strength;
}

/// Further crushing [m] of a point at the elongation xn of its spring [m], below 0 under pressure: (19b).
/// \pre slope < kn
inline double crushed_further(double xn, double crushed, double kn, const Crushing& a) noexcept {
  const double over = -kn * xn - bearing(crushed, a);
  if (over <= 0.0) return 0.0;
  const double softens = a.slope > 0.0 ? (a.strength - a.residual) / a.slope - crushed : 0.0;  // m, crushed depth left until `residual`
  double by = over / kn;
  if (softens > 0.0) {
    by = over / (kn - a.slope);
    if (by > softens) by = (-kn * xn - a.residual) / kn;
  }
  return std::min(by, std::max(0.0, a.depth - crushed));
}

/// Loss by crushing in this step [J/m2]: that of (28) for the whole step, less that of (28) with the new closure, which the law of contact
/// books. \param xn  m, before crushing \param by  m, further crushing \param du  m, growth of xn in this step
inline double lost_by_crushing(double xn, double by, double du, double kn) noexcept {
  const double old = std::min(0.0, xn - du), from = std::min(0.0, xn + by - du);
  return 0.5 * kn * (old * old - from * from + (old - from) * du);
}

/// Lets the contacts of a side give way that are pressed harder than they bear. \param factor  of Eq. 11, on the segment areas
/// \param crushed  m, by segment \return J, lost by it
VOUSSOIR_INLINE double crush_segments(const NormalFields& f, double kn, double factor, PointsView p, SegmentsView q, double step,
                                      const Crushing& a, double* crushed) noexcept {
  double lost = 0.0;
  for (int i = 0; i < p.n; ++i) {
    if (holds(q.bond[i])) continue;
    const double s = p.s[i], t = p.t[i], xn = f.d + s * f.ds + t * f.dt - q.closure(i);
    const double by = crushed_further(xn, crushed[i], kn, a);
    if (by == 0.0) continue;
    lost += factor * p.area[i] * lost_by_crushing(xn, by, step * (f.v + s * f.vs + t * f.vt), kn);
    crushed[i] += by;
    q.closure(i) -= by;
  }
  return lost;
}

/// A segment of a side whose contacts crush: its cap (14), where it was crushed with its bond, falls as (19a), and what the cap takes counts
/// as crushed (19d). \param law  of the segment otherwise: Strength -> SegmentStep
template <typename Law>
VOUSSOIR_INLINE SegmentStep advance_under_falling_cap(const Law& law, SegmentState& q, double& crushed, Strength s,
                                                      const Crushing& a) noexcept {
  if (q.bond == Bond::crushed) {
    s.compression = crushed < a.depth ? std::min(s.compression, bearing(crushed, a)) : std::numeric_limits<double>::infinity();
  }
  const double closure = q.closure;
  const SegmentStep out = law(s);
  if (q.bond == Bond::crushed) crushed = std::min(a.depth, crushed + std::max(0.0, closure - q.closure));
  return out;
}

}  // namespace voussoir::kernels
