// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/census.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

namespace {

// Rows of springs round the elements that limit the step: with one, a beam in a hundred of perf/multirate_resonance.py grew at k = 2.
constexpr int kRings = 2;

/// Elements for which a step of that length is longer than Eq. 19 allows.
std::vector<std::uint8_t> stiff_elements(const World& w, double step) {
  std::vector<std::uint8_t> stiff(static_cast<std::size_t>(w.elements.rows), 0);
  for (std::size_t e = 0; e < static_cast<std::size_t>(w.elements.count); ++e) {
    if (!w.elements.fixed[e]) stiff[e] = cases::step_bound(w.model, e).step < step * (1.0 - 1e-9) ? 1 : 0;
  }
  return stiff;
}

/// With all that are joined to a marked one.
std::vector<std::uint8_t> with_neighbours(const World& w, const std::vector<std::uint8_t>& marked) {
  std::vector<std::uint8_t> all = marked;
  for (const geometry::Joint& j : w.model.assembly.joints) {
    if (j.element_b == geometry::kBase) continue;
    const auto a = static_cast<std::size_t>(j.element_a), b = static_cast<std::size_t>(j.element_b);
    if (marked[a] || marked[b]) all[a] = all[b] = 1;
  }
  return all;
}

}  // namespace

void set_up_multirate(World& w, const cases::Case& c) {
  Multirate& m = w.multirate;
  m.wanted = c.time.multirate;
  if (m.wanted == 1) return;
  if (w.options.gather) throw cases::InputError("time.multirate", "= " + std::to_string(m.wanted) + " goes with --scatter colour alone");
  if (cases::is_assessment(c.analysis))
    throw cases::InputError("time.multirate",
                            "= " + std::to_string(m.wanted) + " goes with time histories alone; allowed with [analysis]: 1");
  m.fast = stiff_elements(w, m.wanted * w.dt);
  for (int ring = 0; ring < kRings; ++ring) m.fast = with_neighbours(w, m.fast);
  const auto rows = static_cast<std::size_t>(w.elements.rows);
  m.twist.assign(rows * kernels::kTwistStride, 0.0);
  m.wrench.assign(rows * kernels::kWrenchStride, 0.0);
  m.dashpot.assign(rows * kernels::kDashpotStride, 0.0);
}

}  // namespace voussoir::solver
