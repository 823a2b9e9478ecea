// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/gravity.h"

#include <cmath>
#include <numbers>

#include "cases/case.h"

namespace voussoir::cases {

Vec3 gravity_on_base(const Case& c) noexcept {
  const Vec3 g = c.gravity.acceleration;
  if (!c.base) return g;
  const double ax = c.base->tilt[0] * std::numbers::pi / 180.0, ay = c.base->tilt[1] * std::numbers::pi / 180.0;
  const Vec3 about_x{g.x, std::cos(ax) * g.y + std::sin(ax) * g.z, -std::sin(ax) * g.y + std::cos(ax) * g.z};
  return {std::cos(ay) * about_x.x - std::sin(ay) * about_x.z, about_x.y, std::sin(ay) * about_x.x + std::cos(ay) * about_x.z};
}

}  // namespace voussoir::cases
