// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/steady_sides.h"

#include <algorithm>

namespace voussoir::kernels {

namespace {

constexpr double kTiny = 1e-13;  // m, far above the round-off of any displacement: the margin of a limit of zero
constexpr double kFar = 1e150;   // no limit; finite, as checkpoints require, and its square too

/// Distances of the nearest segment so far from the limits.
struct Distances {
  double tension = kFar, shear = kFar, cap = kFar, contact = kFar;
  [[nodiscard]] bool positive() const noexcept { return std::min({tension, shear, cap, contact}) > 0.0; }
};

/// A lower bound of the shear limit (THEORY.md (15)) that falls by at most tan φ times the growth of σ.
double safe_shear_limit(double sigma, Strength s, FailureOptions o) noexcept {
  if (!o.shear) return kFar;
  const double c = kMargin * s.cohesion;
  return sigma < 0.0 || o.in_tension == ShearInTension::coulomb ? c - sigma * s.tan_phi : c;
}

/// Updates the distances by a segment with elongation x, with round-off on the safe side.
void approach(Distances& least, Local x, Stiffness k, Strength s, FailureOptions o) noexcept {
  const double tiny = (k.kn + k.ks) * kTiny;
  const double sigma = k.kn * x.n, tau = k.ks * std::sqrt(x.s1 * x.s1 + x.s2 * x.s2);
  least.tension = std::min(least.tension, kMargin * s.tension - sigma - tiny);
  least.shear = std::min(least.shear, safe_shear_limit(sigma, s, o) - tau - tiny);
  least.cap = std::min(least.cap, kMargin * s.compression - std::sqrt(sigma * sigma + s.cap * tau * tau) - tiny);
}

void write(SteadySides& known, int l, const AffineField& u, const Distances& to) noexcept {
  const auto put = [l](double(&row)[3][kLanes], Local v) { row[0][l] = v.n, row[1][l] = v.s1, row[2][l] = v.s2; };
  put(known.d, u.d), put(known.ds, u.ds), put(known.dt, u.dt);
  known.to_tension[l] = to.tension, known.to_shear[l] = to.shear, known.to_cap[l] = to.cap, known.to_contact[l] = to.contact;
}

void clear_sums(SteadySides& known, int l) noexcept {
  for (double* sum : {known.area, known.as, known.at, known.ass, known.ast, known.att}) sum[l] = 0.0;
  for (auto* sums : {&known.slip, &known.slip_s, &known.slip_t}) (*sums)[0][l] = (*sums)[1][l] = 0.0;
}

void add_bond(SteadySides& known, int l, double da, double s, double t, double slip1, double slip2) noexcept {
  known.area[l] += da, known.as[l] += s * da, known.at[l] += t * da;
  known.ass[l] += s * s * da, known.ast[l] += s * t * da, known.att[l] += t * t * da;
  known.slip[0][l] += slip1 * da, known.slip_s[0][l] += s * slip1 * da, known.slip_t[0][l] += t * slip1 * da;
  known.slip[1][l] += slip2 * da, known.slip_s[1][l] += s * slip2 * da, known.slip_t[1][l] += t * slip2 * da;
}

}  // namespace

bool make_steady(const SideBlock& block, int lane, const SideParts& parts, const AffineField& faces, double farthest, FailureOptions o,
                 SteadySides& known) noexcept {
  const Side side = side_of(block, lane, parts);
  const PointsView& p = parts.points;
  const SegmentsView& q = parts.segments;
  AffineField u = faces;  // of bonded segments; of the others u_n alone counts
  u.ds.s2 *= 1.0 + side.twist, u.dt.s1 *= 1.0 + side.twist;
  Distances to;
  to.shear = side.k.ks * farthest * std::min(1.0, 1.0 + side.twist);
  bool any = false;
  clear_sums(known, lane);
  for (int i = 0; i < p.n; ++i) {
    const Local x = u.d + (p.s[i] * u.ds + p.t[i] * u.dt);
    if (holds(q.bond[i])) {
      any = true;
      approach(to, {x.n, x.s1 - q.slip1(i), x.s2 - q.slip2(i)}, side.k, side.strength, o);
      add_bond(known, lane, side.factor * p.area[i], p.s[i], p.t[i], q.slip1(i), q.slip2(i));
    } else {
      if (q.bond[i] == Bond::crushed) return false;
      to.contact = std::min(to.contact, x.n - q.closure(i) - kTiny);
    }
    if (!to.positive()) return false;
  }
  write(known, lane, u, to);
  return any;
}

}  // namespace voussoir::kernels
