// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstring>

#include "solver/world.h"

/// What is known of the sides of a block from the last step (kernels::Quick).
namespace voussoir::solver {

/// Lanes of a block that are as named, one bit each.
inline unsigned lanes_that_are(const Sides& s, std::size_t block, kernels::Quick quick) {
  unsigned lanes = 0;
  for (std::size_t l = 0; l < kernels::kLanes; ++l) {
    lanes |= static_cast<unsigned>(s.quick[block * kernels::kLanes + l] == quick) << l;
  }
  return lanes & s.live_lanes[block];
}

/// True if nothing has happened in a block: then its constants are all there is to it.
inline bool is_whole(const Sides& s, std::size_t block) {
  constexpr std::array kAllWhole = [] {
    std::array<kernels::Quick, kernels::kLanes> all{};
    all.fill(kernels::Quick::whole);
    return all;
  }();
  if (std::memcmp(&s.quick[block * kernels::kLanes], kAllWhole.data(), sizeof kAllWhole) == 0) return true;
  return lanes_that_are(s, block, kernels::Quick::whole) == s.live_lanes[block];  // the last block of a task has lanes without a side
}

}  // namespace voussoir::solver
