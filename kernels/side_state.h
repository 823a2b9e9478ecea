// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>

#include "kernels/side.h"

namespace voussoir::kernels {

/// Sides of a block by state, one bit per side.
struct StateBits {
  unsigned segments, whole, open, steady;
};

namespace detail {
/// Bit i of the result is the lowest bit of byte i: the product moves it to position 56 + i.
inline unsigned lowest_bits(std::uint64_t bytes) noexcept {
  return static_cast<unsigned>((bytes & 0x0101010101010101U) * 0x0102040810204080U >> 56);
}
}  // namespace detail

/// State bits of kLanes sides.
inline StateBits state_bits(const SideState* side_state) noexcept {
  static_assert(static_cast<int>(SideState::segments) == 0 && static_cast<int>(SideState::whole) == 1 &&
                static_cast<int>(SideState::open) == 2 && static_cast<int>(SideState::steady) == 3);
  std::uint64_t bytes;
  static_assert(sizeof bytes == kLanes * sizeof(SideState));
  std::memcpy(&bytes, side_state, sizeof bytes);
  const unsigned low = detail::lowest_bits(bytes), high = detail::lowest_bits(bytes >> 1);
  constexpr unsigned kAll = (1U << kLanes) - 1U;
  return {kAll & ~(low | high), low & ~high, high & ~low, low & high};
}

}  // namespace voussoir::kernels
