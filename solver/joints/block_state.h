// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/side_state.h"
#include "solver/world/world.h"

namespace voussoir::solver {

/// States of the live sides of a block after the last step, one bit each.
inline kernels::StateBits states_of(const Sides& s, std::size_t block) {
  const kernels::StateBits all = kernels::state_bits(&s.side_state[block * kernels::kLanes]);
  const unsigned live = s.live_lanes[block];
  return {all.segments & live, all.whole & live, all.open & live, all.steady & live};
}

/// Whether all live sides of a block are whole: then its constants are its only data.
inline bool is_whole(const Sides& s, std::size_t block) { return states_of(s, block).whole == s.live_lanes[block]; }

}  // namespace voussoir::solver
