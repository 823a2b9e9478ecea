// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

/// Pressure that a contact bears, and how its surface gives way beyond it: THEORY.md (19a)-(19c). What is crushed is gone for good: the
/// point lies that much deeper in its face from then on, whoever it meets. So crushing lowers the closure of a point, and the laws of
/// contact (segment_law.h, patch_work.h) go on from there as they are.
namespace voussoir::kernels {

struct Crushing {
  double strength = 0.0;  // Pa; 0: contacts bear any pressure
  double residual = 0.0;  // Pa, of what is crushed
  double slope = 0.0;     // Pa/m, by which strength falls to it; 0: it does not fall
  double depth = 0.0;     // m, most that a point is crushed: from there on it bears any pressure

  [[nodiscard]] bool on() const noexcept { return strength > 0.0; }
};

/// Pa, that a point bears which has been crushed by `crushed` [m].
inline double bearing(double crushed, const Crushing& a) noexcept {
  return a.slope > 0.0 ? std::max(a.residual, a.strength - a.slope * crushed) : a.strength;
}

/// By how much [m] a point is crushed further by the elongation xn of its spring [m], below 0 where it is pressed: (19b).
/// \pre slope < kn
inline double crushed_further(double xn, double crushed, double kn, const Crushing& a) noexcept {
  const double over = -kn * xn - bearing(crushed, a);
  if (over <= 0.0) return 0.0;
  const double softens = a.slope > 0.0 ? (a.strength - a.residual) / a.slope - crushed : 0.0;  // m, that are left of the slope
  double by = over / kn;
  if (softens > 0.0) {
    by = over / (kn - a.slope);
    if (by > softens) by = (-kn * xn - a.residual) / kn;
  }
  return std::min(by, std::max(0.0, a.depth - crushed));
}

/// J/m2, lost by it in this step: what (28) gives for the whole step, less what it gives from the new closure on, which the law of contact
/// books. \param xn  m, before the point gave way  \param du  m, by which xn has grown in this step
inline double lost_by_crushing(double xn, double by, double du, double kn) noexcept {
  const double old = std::min(0.0, xn - du), from = std::min(0.0, xn + by - du);
  return 0.5 * kn * (old * old - from * from + (old - from) * du);
}

}  // namespace voussoir::kernels
