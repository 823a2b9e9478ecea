// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cases/motion.h"

/// What every synthetic motion has to be.
namespace voussoir::testing {

/// m/s2, the largest magnitude in [from, to) s.
inline double peak_between(const cases::Accelerogram& a, double from, double to) {
  double peak = 0.0;
  for (std::size_t i = 0; i < a.acceleration.size(); ++i) {
    const double t = static_cast<double>(i) * a.dt;
    if (t >= from && t < to) peak = std::max(peak, std::abs(a.acceleration[i]));
  }
  return peak;
}

/// It ends at rest where it began, without a correction.
inline void check_ends_at_rest(const cases::Accelerogram& a) {
  double velocity = 0.0, displacement = 0.0;
  for (std::size_t i = 1; i < a.acceleration.size(); ++i) {
    const double before = velocity;
    velocity += 0.5 * a.dt * (a.acceleration[i - 1] + a.acceleration[i]);
    displacement += 0.5 * a.dt * (before + velocity);
  }
  CHECK(std::abs(velocity) < 1e-6);
  CHECK(std::abs(displacement) < 1e-5);
  CHECK(a.acceleration.back() == 0.0);
}

}  // namespace voussoir::testing
