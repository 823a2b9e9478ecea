// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/rows.h"
#include "solver/world.h"

/// Rows of twists hold the velocities of the state once more, for those who look at both at a time. Joints that are whole do not, so the
/// drift keeps only the rows of bunches that are watched. Who looks at an element that is not makes its row, and has it watched.
namespace voussoir::solver {

[[nodiscard]] inline bool is_watched(const Elements& e, std::int32_t element) {
  return e.watched[static_cast<std::size_t>(element / kernels::kBunch)] != 0;
}

inline void make_twist(Elements& e, std::int32_t element) {
  const auto i = static_cast<std::size_t>(element);
  kernels::store_twist(e.twist.data(), element, {{e.vx[i], e.vy[i], e.vz[i]}, {e.wx[i], e.wy[i], e.wz[i]}});
}

/// Of all elements.
inline void make_twists(Elements& e) {
  for (std::int32_t i = 0; i < e.count; ++i) make_twist(e, i);
}

/// From the next drift on. Between two steps: then all elements of the bunch have their rows at once.
inline void watch(Elements& e, std::int32_t element) {
  if (is_watched(e, element)) return;
  const std::int32_t bunch = element / kernels::kBunch;
  for (std::int32_t i = bunch * kernels::kBunch; i < (bunch + 1) * kernels::kBunch; ++i) make_twist(e, i);
  e.watched[static_cast<std::size_t>(bunch)] = 1;
}

}  // namespace voussoir::solver
