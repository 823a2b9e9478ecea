// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace voussoir::solver {

/// Two elements that one piece of work writes to; −1 writes nothing (the base).
using Writes = std::array<std::int32_t, 2>;

struct Colouring {
  std::vector<std::vector<std::int32_t>> colours;  // items by colour, ascending
  std::vector<std::int32_t> overflow;              // items that no colour could take, ascending
};

/// Greedy first fit in the given order: items of one colour share no element, so their scatter needs no atomics.
/// \pre 1 <= max_colours <= 64
Colouring colour(std::span<const Writes> items, std::int32_t elements, int max_colours);

}  // namespace voussoir::solver
