// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/contact/contact_patch.h"
#include "solver/world/array.h"

namespace voussoir::solver {

/// A free patch with its history: three cache lines with all data that a patch under force needs.
struct alignas(64) FreePatch : kernels::Patch {
  std::int32_t set = 0;                                               // point set in World::points
  std::int32_t touching = 0;                                          // number of points with a partner (state)
  std::int64_t first_point = 0;                                       // index into the arrays by point, a multiple of kLanes
  double stored = 0.0, friction = 0.0, impact = 0.0, fracture = 0.0;  // J (state)
};
static_assert(sizeof(FreePatch) == 192);

/// Free patches: segments in no joint, or of a joint that has come apart. Grows as sides retire.
struct Patches {
  Array<FreePatch> patch;
  std::vector<std::int32_t> element;  // by patch: Patch::element, densely packed (derived)
  double beyond = 0.0;                // m, greatest distance of a patch's rectangle outside the box of its element (derived)
  // State by patch.
  Array<std::int32_t> from_side;  // side from which the patch comes, −1: never joined
  Array<std::uint8_t> mastered;   // 1: its element was the master of from_side
  // State by point.
  Array<std::int32_t> partner, face;
  ZeroArray<kernels::PointSprings> springs;  // of kWidth points each
  Array<double> crushed;                     // m; empty: contacts bear any pressure
  Array<double> pressed;                     // m; empty: contact.restitution is off

  [[nodiscard]] kernels::ContactPoints points(std::int64_t p) noexcept;
};

}  // namespace voussoir::solver
