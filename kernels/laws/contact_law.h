// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "geometry/vec3.h"
#include "kernels/laws/segment_law.h"

/// The law of a contact (Eqs. 8-10, THEORY.md (17)-(19)) in global axes, for one point of two free bodies. `detail::contact_traction` is
/// the same law in the frame of a joint.
namespace voussoir::kernels {

struct ContactStep {
  Vec3 spring;            // m, elongation of the shear spring at the end of the step
  Vec3 before;            // m, elongation at the beginning, turned into the plane of the current contact
  Vec3 elastic, dashpot;  // Pa or N, on the body that `normal` points out of
};

/// Advances a closed contact by one step.
/// \param xn  m, elongation along `normal`, below 0
/// \param rate  m/s, of the other body relative to this one
/// \param spring  m, elongation of the shear spring at the end of the last step
/// \param excess  of dashpots: kBounded or kUnbounded
inline ContactStep advance_contact(double xn, Vec3 normal, Vec3 rate, Vec3 spring, Stiffness k, double tan_phi, double step,
                                   double excess) noexcept {
  ContactStep c;
  const double vn = dot(rate, normal);
  const Vec3 slide = rate - vn * normal;
  c.before = spring - dot(spring, normal) * normal;
  c.spring = c.before + step * slide;
  const double dn = std::min(k.cn * vn, excess - k.kn * xn);  // bounded: the total normal force never pulls
  const double limit = std::max(0.0, -(k.kn * xn + dn) * tan_phi);
  const double shear = k.ks * norm(c.spring);
  if (shear > limit) c.spring *= limit / shear;
  const Vec3 p = k.ks * c.spring, all = k.cs * slide;
  const double share = detail::dashpot_share(std::min(dot(p, p), limit * limit), dot(p, all), dot(all, all), limit * limit + excess);
  c.elastic = p + (k.kn * xn) * normal;
  c.dashpot = share * all + dn * normal;
  return c;
}

}  // namespace voussoir::kernels
