// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/turn.h"

#include <cmath>

namespace voussoir::geometry {

Quaternion quaternion_of(Vec3 rotation) noexcept {
  constexpr double kSmall = 1e-2;  // rad, of half the angle: the series below leave 1e-18 of it
  Vec3 h = 0.5 * rotation;
  int halvings = 0;
  for (; dot(h, h) > kSmall * kSmall && halvings < 64; ++halvings) h = 0.5 * h;
  const double h2 = dot(h, h);
  const double s = 1.0 - h2 * (1.0 / 6.0 - h2 * (1.0 / 120.0 - h2 * (1.0 / 5040.0)));
  double less = -h2 * (0.5 - h2 * (1.0 / 24.0 - h2 * (1.0 / 720.0)));  // cos - 1, which keeps the digits that cos loses
  Vec3 v = s * h;
  for (; halvings > 0; --halvings) {
    v = (2.0 + 2.0 * less) * v;
    less = 2.0 * less * (2.0 + less);
  }
  return {1.0 + less, v.x, v.y, v.z};
}

Vec3 small_rotation(Quaternion from, Quaternion to) noexcept {
  if (from == to) return {};  // not round-off
  // to * from^-1
  const double w = to.w * from.w + to.x * from.x + to.y * from.y + to.z * from.z;
  const Vec3 v{to.x * from.w - to.w * from.x - to.y * from.z + to.z * from.y, to.y * from.w - to.w * from.y - to.z * from.x + to.x * from.z,
               to.z * from.w - to.w * from.z - to.x * from.y + to.y * from.x};
  const double s2 = dot(v, v);
  const double arc = 1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0 + s2 * (105.0 / 3456.0))));  // arcsin(s) / s
  return (w < 0.0 ? -2.0 : 2.0) * arc * v;
}

}  // namespace voussoir::geometry
