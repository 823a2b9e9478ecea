// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/joints/joint_energy.h"

#include <vector>

namespace voussoir::solver {

namespace {

constexpr std::int64_t kBlocksAtATime = 16;

StoredEnergy energy_of(World& w, std::size_t id, double whole) {
  Sides& s = w.sides;
  if (s.retired[id]) return {};
  if (s.side_state[id] == kernels::SideState::whole) return {whole, 0.0};
  if (s.side_state[id] == kernels::SideState::open) return {};
  const kernels::Side side = s.side(static_cast<std::int64_t>(id));
  const double *pose = w.elements.pose.data(), *twist = w.elements.twist.data();
  const kernels::SideFrame f = kernels::side_frame(side, kernels::load_pose(pose, side.master), kernels::load_pose(pose, side.slave),
                                                   kernels::load_twist(twist, side.master), kernels::load_twist(twist, side.slave));
  const kernels::SideParts& parts = s.parts[id];
  const kernels::SideEnergy e = kernels::segment_energy(side, f, parts.points, parts.segments);
  return {e.bonds, e.contact};
}

}  // namespace

StoredEnergy joint_energy(World& w) {
  const auto blocks = static_cast<std::int64_t>(w.sides.blocks.size());
  std::vector<StoredEnergy> by_block(static_cast<std::size_t>(blocks));
  const auto add_block = [&](std::int64_t b) {
    double whole[kernels::kLanes];
    const auto block = static_cast<std::size_t>(b);
    kernels::whole_side_energies(w.sides.blocks[block], w.elements.pose.data(), whole);
    for (std::size_t l = 0; l < kernels::kLanes; ++l) {
      const StoredEnergy e = energy_of(w, block * kernels::kLanes + l, whole[l]);
      by_block[block].bonds += e.bonds, by_block[block].contact += e.contact;
    }
  };
  w.team.share_out(blocks, kBlocksAtATime, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t b = first; b < last; ++b) add_block(b);
  });
  StoredEnergy sum;  // in one fixed order
  for (const StoredEnergy& e : by_block) sum.bonds += e.bonds, sum.contact += e.contact;
  return sum;
}

}  // namespace voussoir::solver
