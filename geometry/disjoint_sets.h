// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace voussoir::geometry {

/// Disjoint sets of the numbers 0 to n − 1, as for connected components. The smallest number of a set represents the set, whatever the
/// order of the unions.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// The smallest number of the set that contains i. Halves paths on the way.
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t a = of(i), b = of(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  [[nodiscard]] bool same(std::size_t i, std::size_t j) { return of(i) == of(j); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace voussoir::geometry
