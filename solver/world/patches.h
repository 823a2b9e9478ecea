// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/contact/contact_patch.h"
#include "solver/world/array.h"

namespace voussoir::solver {

/// A free patch and what it has been through: three cache lines, all of which a patch needs that is pushed.
struct alignas(64) FreePatch : kernels::Patch {
  std::int32_t set = 0;                                               // of its points in World::points
  std::int32_t touching = 0;                                          // points with a partner (state)
  std::int64_t first_point = 0;                                       // into the arrays by point, a multiple of kLanes
  double stored = 0.0, friction = 0.0, impact = 0.0, fracture = 0.0;  // J (state)
};
static_assert(sizeof(FreePatch) == 192);

/// Free patches: segments in no joint, or whose joint has come apart. Grows as sides retire.
struct Patches {
  Array<FreePatch> patch;
  std::vector<std::int32_t> element;  // by patch: Patch::element, close together (derived)
  double beyond = 0.0;                // m, by which the rectangle of some patch reaches out of the box round its element (derived)
  // State by patch.
  Array<std::int32_t> from_side;  // the side it comes from, −1: never joined
  Array<std::uint8_t> mastered;   // 1: its element was the master of from_side
  // State by point.
  Array<std::int32_t> partner, face;
  ZeroArray<kernels::PointSprings> springs;  // of kWidth points each
  Array<double> crushed;                     // m; empty: contacts bear any pressure

  [[nodiscard]] kernels::ContactPoints points(std::int64_t p) noexcept;
};

}  // namespace voussoir::solver
