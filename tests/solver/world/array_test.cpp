// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/array.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

using namespace voussoir::solver;

TEST_CASE("arrays begin on cache lines, and far from the end of any other") {
  std::vector<Array<double>> arrays;
  for (const std::size_t n : {1U, 8U, 1000U, 4264U, 4264U, 300'000U, 300'000U}) arrays.emplace_back(n, 1.0);
  for (const Array<double>& a : arrays) {
    const auto begin = reinterpret_cast<std::uintptr_t>(a.data());
    CHECK(begin % 64 == 0);
    const auto too_near = [&](const Array<double>& other) {
      const auto end = reinterpret_cast<std::uintptr_t>(other.data() + other.size());
      return &a != &other && begin >= end && begin < end + kApart;
    };
    CHECK(std::ranges::none_of(arrays, too_near));
  }
}
