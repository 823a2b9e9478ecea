// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "geometry/vec3.h"

/// Tables [[load]] of the case file.
namespace voussoir::cases {

struct Load {
  std::string block;                     // empty: what the force meets from `at` on, or at the points of `path`
  Vec3 force, moment;                    // N, N m
  std::optional<Vec3> at;                // m, a material point; default the centroid
  std::array<double, 2> ramp{0.0, 0.0};  // s: grows linearly from the first to the second (time zero = start of shaking; also acts while
                                         // settling with the value it has at time 0)
  std::optional<std::string> history;    // file of t, x, y, z: force over time, in place of `force` and `ramp`
  bool follows = false;                  // the force turns with its block; else it keeps its direction (a dead load)
  bool grows = false;                    // the force is multiplied by the load factor of the analysis
  std::optional<std::string> path;       // file of t, x, y, z: the place of the force over time, in place of `block` and `at`
};

}  // namespace voussoir::cases
