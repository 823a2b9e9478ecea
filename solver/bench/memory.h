// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "solver/world/world.h"

/// Memory of the data of a step, by kind.
namespace voussoir::solver {

struct MemoryUse {
  std::size_t elements = 0;  // bytes: columns and rows, those of several rates too; faces, ties
  std::size_t sides = 0;     // constants and sums of sides, and of their laws; contact points of congruent sides once
  std::size_t segments = 0;  // history of segments; unchanged segments take no memory
  std::size_t patches = 0;   // free patches, candidates of the search
};
MemoryUse memory_use(const World& w);

}  // namespace voussoir::solver
