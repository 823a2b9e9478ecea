// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/vec3.h"

/// Contact of two parallel faces, or of a block and the base, written down a second time from Eqs. 2 and 8 to 10 and the choices of
/// THEORY.md (17) to (20): what tests expect of the program, by none of its code but the vectors.
namespace voussoir::testing {

/// Springs and dashpots per area of a face at the distance `l` from its centroid, against its like or against the rigid base.
struct ContactByHand {
  double kn = 0.0, ks = 0.0, cn = 0.0, cs = 0.0;  // Pa/m, Pa s/m
  double tan_phi = 0.0;

  /// \param plane, shear  E' and G, Pa  \param density  kg/m3  \param rates  Δt (β_A + β_B)
  static ContactByHand between_likes(double plane, double shear, double density, double l, double h, double rates, double tan_phi) {
    return made(plane / (2.0 * l), shear / (2.0 * l), 2.0 * density * l, h, rates, tan_phi);
  }
  static ContactByHand on_base(double plane, double shear, double density, double l, double h, double rates, double tan_phi) {
    return made(plane / l, shear / l, 2.0 * density * l, h, rates, tan_phi);
  }

 private:
  static ContactByHand made(double kn, double ks, double mass, double h, double rates, double tan_phi) {
    const double f = 2.0 * h / (1.0 + rates);
    return {kn, ks, f * std::sqrt(mass * kn), f * std::sqrt(mass * ks), tan_phi};
  }
};

/// One point in contact; z is the normal, upwards, of what lies below.
class PointByHand {
 public:
  explicit PointByHand(const ContactByHand& law) : law_(law) {}

  /// Traction [Pa] on what lies above. \param gap  m, below zero: pressed  \param rate  m/s, of what lies above relative to the other
  Vec3 step(double gap, Vec3 rate, double dt) {
    if (gap >= 0.0) {
      x_ = y_ = 0.0;
      return {};
    }
    x_ += dt * rate.x, y_ += dt * rate.y;
    const double normal = std::max(0.0, -law_.kn * gap - law_.cn * rate.z);  // the two together never pull
    const double limit = normal * law_.tan_phi, spring = law_.ks * std::hypot(x_, y_);
    if (spring > limit) x_ *= limit / spring, y_ *= limit / spring;
    // The dashpot carries what the spring leaves of the limit: the largest share h with |spring + h dashpot| <= limit, by halving.
    const auto total = [&](double h) { return Vec3{-law_.ks * x_ - h * law_.cs * rate.x, -law_.ks * y_ - h * law_.cs * rate.y, normal}; };
    const auto within = [&](double h) { return std::hypot(total(h).x, total(h).y) <= limit; };
    if (within(1.0)) return total(1.0);
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) (within(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return total(low);
  }

 private:
  ContactByHand law_;
  double x_ = 0.0, y_ = 0.0;  // m, elongation of the shear spring
};

/// β of a box whose faces all have the dashpots 2 h √(ρE') and 2 h √(ρG) per area, on points at the centres of equal cells: the largest
/// eigenvalue of M⁻¹C, whose matrices are diagonal, as the points lie symmetrically. \param edge  m  \param cell  m, of the faces
inline double box_damping_rate(Vec3 edge, double cell, double plane, double shear, double density, double h) {
  const double size[3] = {edge.x, edge.y, edge.z};
  const double cn = 2.0 * h * std::sqrt(density * plane), cs = 2.0 * h * std::sqrt(density * shear);
  double along[3] = {}, about[3] = {};
  for (int n = 0; n < 3; ++n) {
    const int s = (n + 1) % 3, t = (n + 2) % 3;
    const int count_s = std::max(1, static_cast<int>(std::lround(size[s] / cell))),
              count_t = std::max(1, static_cast<int>(std::lround(size[t] / cell)));
    const double area = size[s] * size[t] / (count_s * count_t);
    for (int i = 0; i < count_s; ++i) {
      for (int j = 0; j < count_t; ++j) {
        const double ps = size[s] * ((i + 0.5) / count_s - 0.5), pt = size[t] * ((j + 0.5) / count_t - 0.5), pn = 0.5 * size[n];
        along[n] += 2.0 * area * cn, along[s] += 2.0 * area * cs, along[t] += 2.0 * area * cs;  // of both faces
        about[n] += 2.0 * area * cs * (ps * ps + pt * pt);
        about[s] += 2.0 * area * (cn * pt * pt + cs * pn * pn);
        about[t] += 2.0 * area * (cn * ps * ps + cs * pn * pn);
      }
    }
  }
  const double mass = density * size[0] * size[1] * size[2];
  double rate = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double a = size[(k + 1) % 3], b = size[(k + 2) % 3];
    rate = std::max({rate, along[k] / mass, about[k] / (mass * (a * a + b * b) / 12.0)});
  }
  return rate;
}

}  // namespace voussoir::testing
