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
    double share = 0.0;  // of the tie's force; negative at its first end
    Vec3 arm;            // m, from the centroid (of the base: from its reference point), body axes
  };
  struct Tie {
    kernels::TieLaw law;
    Vec3 axis;                                   // unit, from the first end to the second at the start
    double length = 0.0;                         // m, at the start
    double pretension = 0.0;                     // N
    double wanted = 0.0;                         // N/m, E A / length; law.stiffness is less where the step allows no more
    std::int32_t first_hold = 0, last_hold = 0;  // into `hold`
  };
  // Constants.
  std::vector<Tie> tie;
  std::vector<Hold> hold;                                       // by tie, the first end before the second
  std::vector<std::int32_t> element;                            // that are held and move or are fixed blocks, ascending
  std::vector<std::int32_t> first_of_element, hold_of_element;  // by entry of `element`; ascending, into `hold`
  // State.
  std::vector<kernels::TieState> state;
  std::vector<double> jack;  // m, elongation of the pretension so far
  // Of the last step.
  std::vector<double> jack_work;  // J
  std::vector<Vec3> pull;         // N, along the tie, on its first end
};

}  // namespace voussoir::solver
