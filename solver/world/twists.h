// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "kernels/rows.h"
#include "solver/world/world.h"

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

/// From the next drift on the bunch of an element is watched. Until then its elements have no ways of their own: so they are looked at.
inline void watch_from_now_on(World& w, std::int32_t element) {
  const auto bunch = static_cast<std::size_t>(element / kernels::kBunch);
  if (w.elements.watched[bunch] != 0) return;
  w.elements.watched[bunch] = 1;
  std::fill_n(w.contacts.until.begin() + static_cast<std::ptrdiff_t>(bunch * kernels::kBunch), kernels::kBunch, -1.0);
}

/// The same between two steps: then all elements of the bunch have their rows at once.
inline void watch(World& w, std::int32_t element) {
  if (is_watched(w.elements, element)) return;
  const std::int32_t first = element / kernels::kBunch * kernels::kBunch;
  for (std::int32_t i = first; i < first + kernels::kBunch; ++i) make_twist(w.elements, i);
  watch_from_now_on(w, element);
}

}  // namespace voussoir::solver
