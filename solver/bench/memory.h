// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "solver/world/world.h"

/// What the step keeps in memory, by what it belongs to.
namespace voussoir::solver {

struct MemoryUse {
  std::size_t elements = 0;  // bytes: their columns and rows, those of several rates too; faces, ties
  std::size_t sides = 0;     // constants and sums of sides, of their laws too; the contact points of congruent ones once
  std::size_t segments = 0;  // history of segments; that of segments in which nothing has happened takes no memory
  std::size_t patches = 0;   // free patches, candidates of the search
};
MemoryUse memory_use(const World& w);

}  // namespace voussoir::solver
