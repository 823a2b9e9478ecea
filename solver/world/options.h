// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace voussoir::solver {

/// How a run is computed. Two change what is computed: `step`, and `merge_sides` (for the test of THEORY.md's merging).
struct Options {
  bool reference_kernels = false;  // --kernels reference: every segment on its own, in plain scalar code
  bool merge_sides = true;         // false: the literal pair of springs of Eq. 11 for coinciding grids too
  double cell = 0.0;               // m, cells of the decomposition; 0: chosen from the model
  std::size_t out_of_cache_from =
      25'000;  // elements from which a model is out of cache, see World::out_of_cache; a number of its own, or bits would depend on caches
  int threads = 0;             // 0: OpenMP's default
  std::optional<double> step;  // s; overrides the case
};

}  // namespace voussoir::solver
