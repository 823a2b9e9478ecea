// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vec3.h"
#include "kernels/laws/tie_law.h"

namespace voussoir::solver {

/// Bars between points of elements (cases/ties.h).
struct Ties {
  struct Hold {
    std::int32_t tie = 0, element = 0;
    double share = 0.0;  // fraction of the tie's force; negative at its first end
    Vec3 arm;            // m, from the centroid (for the base, from its reference point), body axes
  };
  struct Tie {
    kernels::TieLaw law;
    Vec3 axis;                                   // unit, from the first end to the second in the initial position
    double length = 0.0;                         // m, initial
    double pretension = 0.0;                     // N
    double wanted = 0.0;                         // N/m, E A / length; law.stiffness is less if limited by the step
    std::int32_t first_hold = 0, last_hold = 0;  // range in `hold`
  };
  // Constants.
  std::vector<Tie> tie;
  std::vector<Hold> hold;                                       // by tie, first end before second
  std::vector<std::int32_t> element;                            // elements with holds that move or are fixed blocks, ascending
  std::vector<std::int32_t> first_of_element, hold_of_element;  // by entry of `element`; ascending, index into `hold`
  // State.
  std::vector<kernels::TieState> state;
  std::vector<double> jack;  // m, elongation by pretensioning so far
  // Results of the last step.
  std::vector<double> jack_work;  // J
  std::vector<Vec3> pull;         // N, along the tie, on its first end
};

}  // namespace voussoir::solver
