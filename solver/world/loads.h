// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "cases/forward.h"
#include "geometry/vec3.h"

namespace voussoir::solver {

/// Loads and supports on single elements.
struct PointLoad {
  std::int32_t element = 0;
  Vec3 force, moment, arm;                         // N, N m; arm: m, from the centroid, body axes
  double ramp_begin = 0, ramp_end = 0;             // s
  const cases::SupportHistory* history = nullptr;  // of the force, instead of the ramp
  bool follows = false;                            // force and moment rotate with the element
  bool grows = false;                              // multiplied by the load factor (run/load_program.h)
  double part = 1.0;                               // share of the history's force on this element
  bool moves = false;                              // one of the places of a load that moves along a path
  std::int32_t load = 0;                           // number of the [[load]] that this is a share of
};
struct Support {
  std::int32_t element = 0;
  const cases::SupportHistory* history = nullptr;
  Vec3 spin{};  // rad/s, angular velocity of the next step, from move_supports_on to spin_supports
};

}  // namespace voussoir::solver
