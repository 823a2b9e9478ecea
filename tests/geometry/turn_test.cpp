// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/turn.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace voussoir;

TEST_CASE("quaternions of rotation vectors, small and of several turns, and back") {
  const Vec3 axis{0.48, -0.6, 0.64};
  for (const double angle : {0.0, 1e-300, 1e-12, 1e-3, 0.05, 0.3, 1.0, 3.0, 3.14159, 6.5, -40.0}) {
    CAPTURE(angle);
    const Quaternion q = geometry::quaternion_of(angle * axis);
    CHECK(q.w == doctest::Approx(std::cos(0.5 * angle)).epsilon(1e-13));
    CHECK(norm(Vec3{q.x, q.y, q.z} - std::sin(0.5 * angle) * axis) <= 1e-13 * std::abs(angle));
  }
  const Quaternion from = geometry::quaternion_of({0.3, 2.0, -1.0});
  for (const double angle : {0.0, 1e-14, 1e-6, 0.01, 0.1}) {
    const Mat3 both = rotation(geometry::quaternion_of(angle * axis)) * rotation(from);
    const Quaternion d = geometry::quaternion_of(angle * axis);
    const Quaternion to{
        d.w * from.w - d.x * from.x - d.y * from.y - d.z * from.z, d.w * from.x + d.x * from.w + d.y * from.z - d.z * from.y,
        d.w * from.y - d.x * from.z + d.y * from.w + d.z * from.x, d.w * from.z + d.x * from.y - d.y * from.x + d.z * from.w};
    CHECK(norm(rotation(to).r0 - both.r0) < 1e-14);
    CHECK(norm(geometry::small_rotation(from, to) - angle * axis) < 1e-15 + 1e-12 * angle);
    const Quaternion same{-to.w, -to.x, -to.y, -to.z};
    CHECK(norm(geometry::small_rotation(from, same) - angle * axis) < 1e-15 + 1e-12 * angle);
  }
}
