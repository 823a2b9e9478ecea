// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// Lists of stages say what each needs and what it makes, one bit a part: the order is checked where the list stands, by a static_assert,
/// and does not hide in the order of calls.
namespace voussoir::solver {

/// Whether every stage comes after those that make what it needs, and no part is made twice. \param there  parts before the first
template <typename Stages>
constexpr bool in_order(const Stages& stages, std::uint32_t there = 0) {
  for (const auto& stage : stages) {
    if ((stage.needs & ~there) != 0 || (stage.makes & there) != 0) return false;
    there |= stage.makes;
  }
  return true;
}

}  // namespace voussoir::solver
