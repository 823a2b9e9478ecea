// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace voussoir::solver {

/// Options of the computation. Two of them change results: `step`, and `merge_sides` (for the test of merging in THEORY.md).
struct Options {
  bool reference_kernels = false;  // --kernels reference: every segment by itself, in plain scalar code
  bool merge_sides = true;         // false: the two springs of Eq. 11 also for coinciding grids
  double cell = 0.0;               // m, cell size of the decomposition; 0: chosen from the model
  std::size_t out_of_cache_from =
      25'000;       // elements from which a model is out of cache, see World::out_of_cache; fixed, so that bits do not depend on caches
  int threads = 1;  // at most; at least 1
  bool own_pace = false;       // continue with fewer threads while fewer are faster (team/team_size.h)
  std::optional<double> step;  // s; overrides the case
};

}  // namespace voussoir::solver
