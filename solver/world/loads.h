// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "cases/model.h"
#include "geometry/vec3.h"

namespace voussoir::solver {

/// Loads and supports that act on single elements.
struct PointLoad {
  std::int32_t element = 0;
  Vec3 force, moment, arm;                         // N, N m; m, from the centroid, body axes
  double ramp_begin = 0, ramp_end = 0;             // s
  const cases::SupportHistory* history = nullptr;  // of the force, in place of the ramp
  bool follows = false;                            // force and moment turn with the element
  bool grows = false;                              // multiplied by the load factor (run/load_program.h)
  double part = 1.0;                               // that this element bears of the history's force
};
struct Support {
  std::int32_t element = 0;
  const cases::SupportHistory* history = nullptr;
};

}  // namespace voussoir::solver
