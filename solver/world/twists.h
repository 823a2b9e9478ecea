// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "kernels/rows.h"
#include "solver/world/world.h"

/// Rows of twists hold the velocities of the state once more, for those who look at both at a time. Joints that are whole do not, so the
/// drift keeps only the rows of batches that are active. Who looks at an element that is not makes its row, and has it active.
namespace voussoir::solver {

[[nodiscard]] inline bool is_active(const Elements& e, std::int32_t element) {
  return e.active[static_cast<std::size_t>(element / kernels::kBatch)] != 0;
}

inline void make_twist(Elements& e, std::int32_t element) {
  const auto i = static_cast<std::size_t>(element);
  kernels::store_twist(e.twist.data(), element, {{e.vx[i], e.vy[i], e.vz[i]}, {e.wx[i], e.wy[i], e.wz[i]}});
}

/// Of all elements.
inline void make_twists(Elements& e) {
  for (std::int32_t i = 0; i < e.count; ++i) make_twist(e, i);
}

/// From the next drift on the batch of an element is active. Until then its elements have no ways of their own: so they are looked at.
inline void activate_next_drift(World& w, std::int32_t element) {
  const auto batch = static_cast<std::size_t>(element / kernels::kBatch);
  if (w.elements.active[batch] != 0) return;
  w.elements.active[batch] = 1;
  std::fill_n(w.contacts.until.begin() + static_cast<std::ptrdiff_t>(batch * kernels::kBatch), kernels::kBatch, -1.0);
}

/// The same between two steps: then all elements of the batch have their rows at once.
inline void activate(World& w, std::int32_t element) {
  if (is_active(w.elements, element)) return;
  const std::int32_t first = element / kernels::kBatch * kernels::kBatch;
  for (std::int32_t i = first; i < first + kernels::kBatch; ++i) make_twist(w.elements, i);
  activate_next_drift(w, element);
}

}  // namespace voussoir::solver
