// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "tests/verification/fixture.h"

/// What the problems share that ask at which load or size a structure falls.
namespace voussoir::testing {

inline constexpr double kFalls = 1e-2;  // m; what stands moves by some 1e-4 m as its springs take up the load

inline double largest_displacement(const Run& run) {
  double most = 0.0;
  for (std::size_t i = 0; i < run.count(); ++i) most = std::max(most, norm(run.displacement(i)));
  return most;
}

/// How far any block has moved when the case ends, after it has settled [m]; at most a little over kFalls.
inline double movement(Run& run) {
  run.settle();
  while (run.time() < run.description().time.duration && largest_displacement(run) < kFalls) run.until(run.time() + 0.02);
  return largest_displacement(run);
}
inline double movement(const cases::Case& c) {
  Run run(c);
  return movement(run);
}

/// Halves [low, high] until it is narrower than `width`; `above(x)` tells on which side the limit lies.
template <class Above>
double bisect(double low, double high, double width, const Above& above) {
  while (high - low > width) {
    const double middle = 0.5 * (low + high);
    (above(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace voussoir::testing
