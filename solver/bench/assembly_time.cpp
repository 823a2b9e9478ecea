// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/assembly_time.h"

#include <numeric>
#include <vector>

#include "geometry/nth.h"
#include "kernels/side.h"
#include "solver/joints/block_state.h"
#include "solver/world/stages.h"

namespace voussoir::solver {

double assembly_time(World& w, JointTasks& tasks) {
  const Sides& s = w.sides;
  const kernels::Rows rows = w.rows();
  tasks.begin(w.team);
  std::vector<double> times(static_cast<std::size_t>(w.team.size()), 0.0);
  w.team.run([&](int thread) {
    LapClock clock(true);
    const auto hand_out = [&](std::size_t task, std::span<const std::int32_t> /*next*/) {
      clock.begin();
      for (auto i = static_cast<std::size_t>(s.live_first[task]); i < static_cast<std::size_t>(s.live_first[task + 1]); ++i) {
        const auto block = static_cast<std::size_t>(s.live[i]);
        kernels::assemble_zeros(s.blocks[block], s.live_lanes[block] & ~states_of(s, block).open, rows);
      }
      clock.lap(ForcePart::assembly);
    };
    tasks.run_own(thread, hand_out);
    tasks.help(thread, hand_out);
    nth(times, thread) = clock.time(ForcePart::assembly);
  });
  return std::accumulate(times.begin(), times.end(), 0.0) / w.team.size();
}

}  // namespace voussoir::solver
