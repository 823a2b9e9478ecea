// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/certificate.h"

/// Damaged sides in which no segment changes state, kWidth at a time (THEORY.md (16a), (16b)): three in four damaged sides of a cracked
/// house. Bonded segments are elastic, each from its own plastic slip, and unbonded segments are open, so the sums of tractions have a
/// closed form over the bonded ones. No segment changes state while the side has moved less, since its segments were processed, than takes
/// the nearest segment to its limit.
namespace voussoir::kernels {

/// Displacement of faces since their segments were processed last, greatest over the rectangle of the points [m].
struct MovedLanes {
  Lanes apart, together, slide;  // along the normal, apart and together (≥ 0); along the faces
};
VOUSSOIR_INLINE MovedLanes moved_since(const SideConstants& s, int at, LocalLanes d, LocalLanes ds, LocalLanes dt) noexcept {
  const Lanes zero{};
  const Lanes s0 = load_lanes(s.s_low + at), s1 = load_lanes(s.s_high + at), t0 = load_lanes(s.t_low + at), t1 = load_lanes(s.t_high + at);
  MovedLanes m{zero, zero, zero};
  for (const Lanes x : {s0, s1}) {
    for (const Lanes y : {t0, t1}) {
      const LocalLanes u = d + (x * ds + y * dt);
      m.apart = max(m.apart, u.n);
      m.together = max(m.together, -u.n);
      m.slide = max(m.slide, u.s1 * u.s1 + u.s2 * u.s2);
    }
  }
  m.slide = sqrt(m.slide);
  return m;
}

/// Writes the sums of tractions of the chosen lanes into `sums`; other lanes are unchanged.
/// \return lanes in which certainly no segment changes state
VOUSSOIR_INLINE LaneMask stay_steady(const SideBlock& block, const SteadySides& known, int at, const Kinematics& k, LaneMask chosen,
                                     SumLanes& sums) noexcept {
  const SideConstants& s = *block.constants;
  const FrameLanes frame = frame_of(block, at, k, (1.0 / sqrt(dot(k.n, k.n))) * k.n);
  const LocalLanes d = frame.local(k.d), ds = frame.local(k.a), dt = frame.local(k.b);
  const Lanes kn = load_lanes(s.kn + at), ks = load_lanes(s.ks + at);
  const MovedLanes m = moved_since(s, at, d - load_local(known.d, at), ds - load_local(known.ds, at), dt - load_local(known.dt, at));
  // |τ| grows by no more than k_s·slide, and the limit falls by no more than tan φ times the growth of σ; √(σ² + C_s τ²) is a norm.
  const Lanes sigma = kn * m.apart, tau = ks * m.slide, most = max(sigma, kn * m.together), to_cap = load_lanes(known.to_cap + at);
  const LaneMask stays =
      (sigma <= load_lanes(known.to_tension + at)) & (tau + load_lanes(s.tan_phi + at) * sigma <= load_lanes(known.to_shear + at)) &
      (most * most + load_lanes(s.cap + at) * (tau * tau) <= to_cap * to_cap) & (m.together <= load_lanes(known.to_contact + at));
  const auto over = [&](const double* one, const double* by_s, const double* by_t, const double(&p)[2][kLanes]) {
    const LocalLanes v = load_lanes(one + at) * d + (load_lanes(by_s + at) * ds + load_lanes(by_t + at) * dt);
    return frame.global({kn * v.n, ks * (v.s1 - load_lanes(p[0] + at)), ks * (v.s2 - load_lanes(p[1] + at))});
  };
  sums.f = select3(chosen, over(known.area, known.as, known.at, known.slip), sums.f);
  sums.sf = select3(chosen, over(known.as, known.ass, known.ast, known.slip_s), sums.sf);
  sums.tf = select3(chosen, over(known.at, known.ast, known.att, known.slip_t), sums.tf);
  return stays;
}

}  // namespace voussoir::kernels
