// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

/// The law of a tie (THEORY.md (31)): force over elongation of a bar with elasticity, yielding, hardening and breaking, slack in
/// compression unless the bar bears compression.
namespace voussoir::kernels {

struct TieLaw {
  double stiffness = 0.0;  // k, N/m
  double yield = 0.0;      // N_y, N; infinite: elastic
  double hardening = 0.0;  // H, N/m, growth of the yield force with the plastic elongation
  double breaking = 0.0;   // e_u, m, elongation at which the tie breaks; infinite: never
  bool compression = false;
};

/// State of a tie.
struct TieState {
  double elongation = 0.0;  // e, m, including that of the pretension
  double plastic = 0.0;     // e_p, m
  double worked = 0.0;      // q, m, accumulated plastic elongation, absolute values
  double force = 0.0;       // N; tension is positive
  double lost = 0.0;        // J, by yielding, and by going slack or taut within a step
  double released = 0.0;    // J, at breaking
  std::int64_t broken = 0;  // 1: broken
};

/// Elastic energy [J].
inline double stored_energy(const TieLaw& law, const TieState& s) noexcept { return 0.5 * s.force * s.force / law.stiffness; }

/// The state at the elongation `e` [m], by return to the yield force with linear isotropic hardening. The loss of a step is the trapezoidal
/// work less the growth of the elastic energy.
inline TieState advance_tie(const TieLaw& law, const TieState& last, double e) noexcept {
  TieState s = last;
  s.elongation = e;
  if (last.broken != 0) return s;
  const double trial = law.stiffness * (e - last.plastic), limit = law.yield + law.hardening * last.worked, over = std::abs(trial) - limit;
  s.force = trial;
  if (e >= law.breaking) {
    s.broken = 1, s.force = 0.0;
  } else if (trial < 0.0 && !law.compression) {
    s.force = 0.0;
  } else if (over > 0.0) {
    const double more = over / (law.stiffness + law.hardening);
    s.plastic += std::copysign(more, trial);
    s.worked += more;
    s.force = std::copysign(limit + law.hardening * more, trial);
  }
  const double work = 0.5 * (last.force + s.force) * (e - last.elongation);
  (s.broken != 0 ? s.released : s.lost) += work - (stored_energy(law, s) - stored_energy(law, last));
  return s;
}

}  // namespace voussoir::kernels
