// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace voussoir::geometry {

/// Numbers 0 to n − 1 in sets that can be joined: what holds together. The smallest number of a set stands for it, whatever the order of the joins.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// The smallest number of the set that i is in. Paths are halved on the way.
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
