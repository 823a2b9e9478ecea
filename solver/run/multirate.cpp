// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/multirate.h"

#include <algorithm>
#include <array>

#include "solver/contact/overlap_contact.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

namespace {

std::array<double, 6> velocities_of(const Elements& e, std::size_t i) { return {e.vx[i], e.vy[i], e.vz[i], e.wx[i], e.wy[i], e.wz[i]}; }

static_assert(kernels::kTwistStride == 8 && kernels::kWrenchStride == 8 && kernels::kDashpotStride == 8);

/// to += factor × from; from = 0: one row.
void move_row(double* to, double* from, double factor) {
  for (int k = 0; k < kernels::kWrenchStride; ++k) to[k] += factor * from[k], from[k] = 0.0;
}

}  // namespace

void start_cycles(World& w) {
  Multirate& m = w.multirate;
  m.cycle = m.wanted;
  if (!m.on()) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(w.elements.rows); ++i) {
    const std::array<double, 6> now = velocities_of(w.elements, i);
    for (Multirate::Rows& r : m.rows) std::ranges::copy(now, r.twist.data() + i * kernels::kTwistStride);
  }
  w.contacts.stale_level = 0;  // patches and pairs have levels from now on
  list_overlap_levels(w);
}

void renew_contact_levels(World& w) {
  const Sides& s = w.sides;
  Pairs joined;
  for (std::size_t id = 0; id < s.retired.size(); ++id) {
    if (s.retired[id]) continue;
    const kernels::SideBlock& b = s.blocks[id / kernels::kLanes];
    const std::size_t lane = id % kernels::kLanes;
    if (b.slave[lane] != w.elements.base) joined.emplace_back(b.master[lane], b.slave[lane]);
  }
  w.multirate.of_contacts = with_rings(w.multirate.own, joined);
  list_overlap_levels(w);
}

void add_impulses(World& w, std::int64_t step) {
  Multirate& m = w.multirate;
  for (int level = 1; level < m.due(step); ++level) {
    Multirate::Rows& of_level = m.rows[static_cast<std::size_t>(level) - 1];
    const double steps = m.impulse_steps(level, step);
#pragma omp parallel for schedule(static) num_threads(w.threads)
    for (std::int64_t i = 0; i < w.elements.rows; ++i) {
      double* wrench = of_level.wrench.data() + i * kernels::kWrenchStride;
      if (wrench[kernels::kDashedColumn] != 0.0) {
        move_row(w.elements.dashpot.data() + i * kernels::kDashpotStride, of_level.dashpot.data() + i * kernels::kDashpotStride, steps);
      }
      move_row(w.elements.wrench.data() + i * kernels::kWrenchStride, wrench, steps);
    }
  }
}

void sum_velocities(World& w, std::int64_t step, std::int64_t first, std::int64_t last) {
  Multirate& m = w.multirate;
  for (std::size_t level = 1; level < m.every.size(); ++level) {
    const std::int32_t every = m.every[level];
    const double before = step % every == 0 ? 0.0 : 1.0, scale = (step + 1) % every == 0 ? 1.0 / every : 1.0;
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
      const std::array<double, 6> now = velocities_of(w.elements, i);
      double* row = m.rows[level - 1].twist.data() + i * kernels::kTwistStride;
      for (std::size_t k = 0; k < now.size(); ++k) row[k] = scale * (before * row[k] + now[k]);
    }
  }
}

}  // namespace voussoir::solver
