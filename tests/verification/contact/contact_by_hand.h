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

/// The largest eigenvalue of M⁻¹C of a box with the dashpots 2 h √(ρE') and 2 h √(ρG) per area all over one face, by the bound that the
/// program takes: the 64th root of the sum of the 64th powers of all six. By symmetry four of them are those of two pairs, a slide with
/// a turn. \param edge  m; the face is normal to z
inline double face_damping_bound(Vec3 edge, double plane, double shear, double density, double h) {
  const double area = edge.x * edge.y, arm = 0.5 * edge.z, mass = density * area * edge.z;
  const double cn = 2.0 * h * std::sqrt(density * plane) * area, cs = 2.0 * h * std::sqrt(density * shear) * area;
  double sum = std::pow(cn / mass, 64.0) + std::pow(cs / mass, 64.0);  // up; about z, where the second moments are those of the mass
  for (const double side : {edge.x, edge.y}) {
    const double slide = cs / mass, inertia = mass * (side * side + edge.z * edge.z) / 12.0;
    const double turn = (cn * side * side / 12.0 + cs * arm * arm) / inertia;
    const double mean = 0.5 * (slide + turn), apart = std::sqrt(0.25 * (slide - turn) * (slide - turn) + slide * cs * arm * arm / inertia);
    sum += std::pow(mean + apart, 64.0) + std::pow(mean - apart, 64.0);
  }
  return std::pow(sum, 1.0 / 64);
}

}  // namespace voussoir::testing
