// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/colouring.h"

#include <bit>

namespace voussoir::solver {

Colouring colour(std::span<const Writes> items, std::int32_t elements, int max_colours) {
  Colouring result;
  std::vector<std::uint64_t> used(static_cast<std::size_t>(elements), 0);
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::uint64_t taken = 0;
    for (const std::int32_t e : items[i]) {
      if (e >= 0) taken |= used[static_cast<std::size_t>(e)];
    }
    const int c = std::countr_one(taken);
    if (c >= max_colours) {
      result.overflow.push_back(static_cast<std::int32_t>(i));
      continue;
    }
    for (const std::int32_t e : items[i]) {
      if (e >= 0) used[static_cast<std::size_t>(e)] |= std::uint64_t{1} << c;
    }
    if (static_cast<std::size_t>(c) >= result.colours.size()) result.colours.resize(static_cast<std::size_t>(c) + 1);
    result.colours[static_cast<std::size_t>(c)].push_back(static_cast<std::int32_t>(i));
  }
  return result;
}

}  // namespace voussoir::solver
