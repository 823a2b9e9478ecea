// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// Seeds of random numbers: integer arithmetic only, so the same on every machine.
namespace voussoir::cases {

/// SplitMix64 (Steele, Lea and Flood 2014): every bit of the input changes half the bits of the output.
constexpr std::uint64_t mixed(std::uint64_t x) noexcept {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ x >> 27) * 0x94d049bb133111ebULL;
  return x ^ x >> 31;
}

}  // namespace voussoir::cases
