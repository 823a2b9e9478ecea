// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/joints/block_prefetch.h"

#include <bit>

#include "kernels/prefetch.h"
#include "solver/joints/block_state.h"

namespace voussoir::solver {

void prefetch_block(const Sides& s, const kernels::Rows& rows, std::int32_t number) {
  const auto block = static_cast<std::size_t>(number);
  const kernels::StateBits states = states_of(s, block);
  if (states.whole == s.live_lanes[block]) return;
  const kernels::SideBlock& b = s.blocks[block];
  for (const std::int32_t* elements : {b.master, b.slave}) {
    for (int l = 0; l < kernels::kLanes; ++l) {
      const auto e = static_cast<std::int64_t>(elements[l]);
      kernels::prefetch(rows.pose + e * kernels::kPoseStride, kernels::kPoseStride * sizeof(double));
      kernels::prefetch(rows.wrench + e * kernels::kWrenchStride, kernels::kWrenchStride * sizeof(double));
    }
  }
  kernels::prefetch(b.constants, sizeof *b.constants);
  for (unsigned rest = states.segments; rest != 0; rest &= rest - 1) {
    kernels::prefetch(&s.parts[block * kernels::kLanes + static_cast<std::size_t>(std::countr_zero(rest))], sizeof(kernels::SideParts));
  }
}

void prefetch_histories(const Sides& s, std::int32_t number) {
  const auto block = static_cast<std::size_t>(number);
  const kernels::StateBits states = states_of(s, block);
  if (states.steady != 0) kernels::prefetch(&s.steady[block], sizeof s.steady[block]);
  for (unsigned rest = states.segments; rest != 0; rest &= rest - 1) {
    const kernels::SideParts& parts = s.parts[block * kernels::kLanes + static_cast<std::size_t>(std::countr_zero(rest))];
    const auto n = static_cast<std::size_t>(parts.points.n);
    kernels::prefetch(parts.segments.bond, n * sizeof(kernels::Bond));
    kernels::prefetch(parts.segments.springs, n * sizeof(kernels::SegmentSprings) / kernels::kWidth);
  }
}

}  // namespace voussoir::solver
