// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/laws/tension.h"
#include "kernels/side_lanes.h"

/// Certificates that no segment of a side reaches a limit, kWidth sides at a time (THEORY.md (16)). The relative displacement of two rigid
/// faces is affine, u = d + s·a + t·b, so the force of all springs of a whole side is A·G d and its moment needs only the discrete second
/// moments of the points. All limits are convex in (s, t) once split as below, so four corners bound every segment.
namespace voussoir::kernels {

// Distances that certificates keep from a limit, so that their round-off can only send a side to its segments, never past a limit.
inline constexpr double kMargin = 1.0 - 1e-9;
inline constexpr double kRound = 1e-13;
inline constexpr double kLeast = 1e-14;  // m, round-off of displacements: the margin where the tensile strength is zero

/// Lanes in which every contact point has u_n > 0: no unbonded segment touches.
VOUSSOIR_INLINE LaneMask all_open(const SideConstants& s, int at, const Kinematics& k) noexcept {
  return least_opening(s, at, dot(k.d, k.n), dot(k.a, k.n), dot(k.b, k.n)) > 0.0;
}

/// Normalises the mean normal. Its length falls short of 1 by the square of the relative rotation, so a series gives the result without
/// root and quotient. Returns the lanes in which |n|² − 1 exceeds kSeries: there the omitted terms, from 35/128 of its fourth power on,
/// would show.
VOUSSOIR_INLINE LaneMask normalise(VecLanes& n) noexcept {
  const Lanes e = dot(n, n) - 1.0;
  n = (1.0 - e * (0.5 - e * (0.375 - e * 0.3125))) * n;
  return e * e > kSeries * kSeries;
}

/// Lanes in which all segments are certainly inside all limits.
///
/// Both |u|² and u_n of a corner come from the six products of d, a and b. |u_s|² = |u|² − u_n² therefore has an error of a few 1e-16 of
/// the sum of squares that bounds |u|²; a larger share of that sum, kRound, covers the error.
VOUSSOIR_INLINE LaneMask certified(const SideConstants& s, int at, const Kinematics& k, FailureOptions o) noexcept {
  const Lanes kn = load_lanes(s.kn + at), ks = load_lanes(s.ks + at), ks2 = ks * ks;
  const Lanes ft = kMargin * load_lanes(s.tension + at) - kLeast * kn, c = kMargin * load_lanes(s.cohesion + at),
              tan_phi = load_lanes(s.tan_phi + at);
  const Lanes fm = kMargin * load_lanes(s.compression + at), fm2 = fm * fm, cap = load_lanes(s.cap + at);
  const Lanes sn = kn * dot(k.d, k.n), an = kn * dot(k.a, k.n), bn = kn * dot(k.b, k.n);  // stress: sn + s an + t bn
  const Lanes to_n = ks2 / (kn * kn);
  const Lanes dd = ks2 * dot(k.d, k.d), aa = ks2 * dot(k.a, k.a), bb = ks2 * dot(k.b, k.b);
  const Lanes da = 2.0 * (ks2 * dot(k.d, k.a)), db = 2.0 * (ks2 * dot(k.d, k.b)), ab = 2.0 * (ks2 * dot(k.a, k.b));
  const Lanes reach_s = max(-load_lanes(s.s_low + at), load_lanes(s.s_high + at));
  const Lanes reach_t = max(-load_lanes(s.t_low + at), load_lanes(s.t_high + at));
  const Lanes round = (3.0 * kRound) * (dd + ((reach_s * reach_s) * aa + (reach_t * reach_t) * bb)), c2 = c * c - round;
  const Lanes tt[2] = {load_lanes(s.t_low + at), load_lanes(s.t_high + at)};
  LaneMask tension_or_cap_exceeded{}, above_cohesion{}, above_coulomb{};
  for (const double* edge : {s.s_low + at, s.s_high + at}) {
    const Lanes ss = load_lanes(edge);
    const Lanes square = dd + ss * (da + ss * aa), slope = db + ss * ab, along = sn + ss * an;
    for (const Lanes t : tt) {
      const Lanes sigma = along + t * bn, sigma2 = sigma * sigma;
      const Lanes tau2 = square + t * (slope + t * bb) - to_n * sigma2;
      const Lanes coulomb = c - sigma * tan_phi;
      tension_or_cap_exceeded |= tension_fails(sigma, ft) | (sigma2 + cap * (tau2 + round) > fm2);
      above_cohesion |= tau2 > c2;
      above_coulomb |= (coulomb < 0.0) | (tau2 + round > coulomb * coulomb);
    }
  }
  LaneMask shear_exceeded = above_cohesion & above_coulomb;
  // Under a shear limit of c − σ tan φ in tension only that test is a bound; with no shear limit in tension the test is conservative.
  if (o.in_tension == ShearInTension::coulomb) shear_exceeded = above_coulomb;
  if (!o.shear) shear_exceeded = LaneMask{};
  return ~(tension_or_cap_exceeded | shear_exceeded);
}

VOUSSOIR_INLINE VecLanes spring(Lanes ks, Lanes extra, VecLanes n, VecLanes u) noexcept { return ks * u + (extra * dot(n, u)) * n; }

VOUSSOIR_INLINE SumLanes elastic_sums(const SideConstants& s, int at, const Kinematics& k) noexcept {
  const Lanes ks = load_lanes(s.ks + at), extra = load_lanes(s.kn + at) - ks;
  const Lanes sss = load_lanes(s.sss + at), sst = load_lanes(s.sst + at), stt = load_lanes(s.stt + at);
  const VecLanes ga = spring(ks, extra, k.n, k.a), gb = spring(ks, extra, k.n, k.b);
  return {load_lanes(s.area + at) * spring(ks, extra, k.n, k.d), sss * ga + sst * gb, sst * ga + stt * gb};
}

}  // namespace voussoir::kernels
