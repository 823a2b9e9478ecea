// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/multirate.h"

#include <array>

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
    for (std::size_t k = 0; k < now.size(); ++k) m.twist[i * kernels::kTwistStride + k] = now[k];
  }
  w.contacts.gather_stale = true;  // patches are fast or slow from now on
}

void add_slow_impulses(World& w, double steps) {
  Multirate& m = w.multirate;
#pragma omp parallel for schedule(static) num_threads(w.threads)
  for (std::int64_t i = 0; i < w.elements.rows; ++i) {
    double* slow = m.wrench.data() + i * kernels::kWrenchStride;
    if (slow[kernels::kDashedColumn] != 0.0) {
      move_row(w.elements.dashpot.data() + i * kernels::kDashpotStride, m.dashpot.data() + i * kernels::kDashpotStride, steps);
    }
    move_row(w.elements.wrench.data() + i * kernels::kWrenchStride, slow, steps);
  }
}

void sum_velocities(World& w, std::int64_t step, std::int64_t first, std::int64_t last) {
  Multirate& m = w.multirate;
  const double before = m.starts_cycle(step) ? 0.0 : 1.0, scale = m.starts_cycle(step + 1) ? 1.0 / m.cycle : 1.0;
  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
    const std::array<double, 6> now = velocities_of(w.elements, i);
    double* row = m.twist.data() + i * kernels::kTwistStride;
    for (std::size_t k = 0; k < now.size(); ++k) row[k] = scale * (before * row[k] + now[k]);
  }
}

}  // namespace voussoir::solver
