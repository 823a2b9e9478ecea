// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "geometry/nth.h"
#include "kernels/side.h"
#include "solver/world/array.h"

/// Sharing of constants by congruent sides. A building has thousands of joints but only a few dozen kinds of them: the kernels then read,
/// for each joint, its two elements and a block of constants that is already in the cache.
namespace voussoir::solver {

/// Kinds of sides: sides whose constants agree to 12 digits; the digits of the first are used for all (coordinates that differ by whole
/// bricks also differ by round-off).
class SideKinds {
 public:
  using Numbers = std::array<double, kernels::kSideNumbers>;  // of one side, in the order of SideConstants

  /// Number of the kind of the side in lane 0 of `c`. Kinds are numbered in order of appearance.
  std::int32_t add(const kernels::SideConstants& c);
  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(kinds_.size()); }
  [[nodiscard]] const Numbers& numbers(std::int32_t kind) const { return nth(kinds_, kind); }

 private:
  using Key = std::array<std::int64_t, kernels::kSideNumbers>;
  static Key key_of(const kernels::SideConstants& c);

  std::map<Key, std::int32_t> known_;
  std::vector<Numbers> kinds_;
};

/// Constants of blocks, each distinct combination of kinds in the lanes once.
class BlockKinds {
 public:
  using Lanes = std::array<std::int32_t, kernels::kLanes>;
  explicit BlockKinds(const SideKinds& sides) : sides_(sides) {}

  std::size_t add(const Lanes& kinds);
  [[nodiscard]] Array<kernels::SideConstants> take() { return std::move(constants_); }

 private:
  const SideKinds& sides_;
  std::map<Lanes, std::size_t> known_;
  Array<kernels::SideConstants> constants_;
};

}  // namespace voussoir::solver
