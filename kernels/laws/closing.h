// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/laws/crushing.h"

/// A dry joint that stiffens as it closes, by the hyperbola of Bandis, Lumsden and Barton (1983), in series with its blocks: THEORY.md
/// (17a)-(17c). As in crushing, only the closure of a point is changed: to a value at which a spring of the stiffness without pressure has
/// the pressure of the hyperbola. The laws of contact (segment_law.h, chunk_law.h) then apply unchanged.
namespace voussoir::kernels {

/// Pressure [Pa] at a closure of x [m] of joint and blocks, (17b); 0 for an open joint.
inline double pressure_at(double x, const Closing& a) noexcept {
  if (x <= 0.0) return 0.0;
  const double b = a.most + a.scale / a.blocks - x;
  const double root = std::sqrt(b * b + 4.0 * x * a.scale / a.blocks);
  return b > 0.0 ? 2.0 * x * a.scale / (b + root) : 0.5 * a.blocks * (root - b);  // the form without cancellation
}

/// Slope of the pressure over the closure [Pa/m] at the pressure p [Pa]: (17d).
inline double stiffness_at(double p, const Closing& a) noexcept {
  const double whole = a.scale + p;
  return 1.0 / (1.0 / a.blocks + a.most * a.scale / (whole * whole));
}

namespace detail {

/// ln(1 + z) − z/(1 + z) for z ≥ 0, without the standard library, so that its bits are the same everywhere.
inline double stored_share(double z) noexcept {
  if (z < 0.05) {  // Σ (−1)^n (n − 1)/n zⁿ
    double sum = 0.0;
    for (int n = 14; n > 1; --n) sum = (n % 2 == 0 ? 1.0 : -1.0) * (n - 1.0) / n + z * sum;
    return z * z * sum;
  }
  constexpr double kLn2 = 0.6931471805599453, kHalfRoot = 0.7071067811865476;
  int halvings = 0;
  double m = std::frexp(1.0 + z, &halvings);
  if (m < kHalfRoot) m *= 2.0, --halvings;
  const double s = (m - 1.0) / (m + 1.0), s2 = s * s;
  double sum = 0.0;
  for (int n = 21; n > 0; n -= 2) sum = 1.0 / n + s2 * sum;
  return halvings * kLn2 + 2.0 * s * sum - z / (1.0 + z);
}

}  // namespace detail

/// Elastic energy [J/m2] under the pressure p [Pa]: (17c).
inline double stored_at(double p, const Closing& a) noexcept {
  return 0.5 * p * p / a.blocks + a.most * a.scale * detail::stored_share(p / a.scale);
}

/// Further crushing [m] of a point at a closure of x [m], crushed by `crushed` [m] before: (19b) with the hyperbola, by bisection.
/// \pre the slope of crushing is below stiffness_at all pressures on the way
inline double crushed_further(double x, double crushed, const Closing& a, const Crushing& c) noexcept {
  if (pressure_at(x, a) <= bearing(crushed, c)) return 0.0;
  double low = 0.0, high = x;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (pressure_at(x - middle, a) > bearing(crushed + middle, c) ? low : high) = middle;
  }
  return std::min(high, std::max(0.0, c.depth - crushed));
}

/// Normal behaviour of an unbonded point in a step, determined before the law of contact is applied.
struct Closed {
  double closure = 0.0;  // m, new closure
  double crushed = 0.0;  // m, further crushing
  double lost = 0.0;     // J/m2: loss by (28) for the whole step, less the loss that the law of contact books with the new closure
};

/// Closes and crushes a point under the hyperbola.
/// \param u  m, opening of the faces now \param du  m, growth of the opening in this step
/// \param kn  Pa/m, stiffness without pressure, used by the law of contact \param crushing  nullptr: the point bears any pressure
inline Closed close_point(double u, double du, double crushed, double kn, const Closing& a, const Crushing* crushing) noexcept {
  const double x = -(u + crushed), x_before = x + du;
  Closed r{.closure = -crushed};
  if (x <= 0.0 && x_before <= 0.0) return r;
  if (crushing != nullptr && x > 0.0) r.crushed = crushed_further(x, crushed, a, *crushing);
  const double before = pressure_at(x_before, a), now = pressure_at(x - r.crushed, a);
  r.closure = now > 0.0 ? u + now / kn : -crushed;
  const double n = std::min(0.0, u - r.closure), n_before = std::min(0.0, u - r.closure - du);
  const double whole = stored_at(before, a) - stored_at(now, a) - 0.5 * (before + now) * du;
  r.lost = whole - 0.5 * kn * (n_before * n_before - n * n + (n_before + n) * du);
  return r;
}

/// Moves the closures of the contacts of a side. \param crushing, crushed  nullptr: any pressure is borne
VOUSSOIR_INLINE GaveWay close_segments(const NormalFields& f, double kn, double factor, PointsView p, SegmentsView q, double step,
                                       const Closing& a, const Crushing* crushing, double* crushed) noexcept {
  GaveWay lost;
  for (int i = 0; i < p.n; ++i) {
    if (holds(q.bond[i])) continue;
    const double s = p.s[i], t = p.t[i], u = f.d + s * f.ds + t * f.dt, du = step * (f.v + s * f.vs + t * f.vt);
    const Closed r = close_point(u, du, crushed == nullptr ? 0.0 : crushed[i], kn, a, crushing);
    q.closure(i) = r.closure;
    (r.crushed > 0.0 ? lost.fracture : lost.impact) += factor * p.area[i] * r.lost;
    if (r.crushed > 0.0) crushed[i] += r.crushed;
  }
  return lost;
}

}  // namespace voussoir::kernels
