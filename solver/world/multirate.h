// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/world/array.h"

namespace voussoir::solver {

/// Multi-rate stepping (THEORY.md (24a), `time.multirate`). A pair of elements has a *level*: those of level l are evaluated in every
/// `every[l]`-th step, as if that were one step, and their forces act there with the impulse of all these steps. Level 0 is every step. An
/// element has the highest level that its own bound (Eq. 19), those of its neighbours and those of their neighbours all allow: impulses of
/// slow pairs can hardly excite stiff elements then (perf/multirate_resonance.py). After that, levels of neighbours are made to differ by
/// one at most: else fast dashpots would take energy that nobody put in. A pair has the lower level of its two elements.
struct Multirate {
  static constexpr std::size_t kMostLevels = 4;  // 1, 2, 4 and 8 steps
  std::int32_t wanted = 1;                       // steps of a cycle while it shakes: the last of `every`
  std::int32_t cycle = 1;                        // now: 1 while it settles
  std::vector<std::int32_t> every{1};            // by level: steps, twice those of the level before
  std::vector<std::uint8_t> own;                 // Constant by row of elements: the highest level that its own bound allows; empty: 0
  std::vector<std::uint8_t> of_joints;           // Constant by row of elements: for its joints, as they are at first
  std::vector<std::uint8_t> of_contacts;         // State by row of elements: for its contacts; not above that of its joints while one holds
  /// Rows as in kernels/rows.h, of the pairs of one level alone.
  struct Rows {
    Array<double> twist;            // State: sums over the steps since the last evaluation; in the last of them, the means
    Array<double> wrench, dashpot;  // N, N m, in a step of evaluation; else 0
  };
  std::vector<Rows> rows;  // of levels from 1 on

  [[nodiscard]] bool on() const noexcept { return cycle > 1; }
  [[nodiscard]] bool starts_cycle(std::int64_t step) const noexcept { return step % cycle == 0; }
  /// Those that a pair can have in this phase.
  [[nodiscard]] int levels() const noexcept { return on() ? static_cast<int>(every.size()) : 1; }
  /// How many levels are evaluated in a step: it is these from 0 on.
  [[nodiscard]] int due(std::int64_t step) const noexcept {
    int levels_due = 1;
    while (levels_due < levels() && step % every[static_cast<std::size_t>(levels_due)] == 0) ++levels_due;
    return levels_due;
  }
  /// Steps from one evaluation of a level to the next.
  [[nodiscard]] std::int32_t steps_of(int level) const noexcept { return level == 0 ? 1 : every[static_cast<std::size_t>(level)]; }
  /// Steps whose impulse acts in one in which a level is evaluated. The first begins with a velocity of half a step before it.
  [[nodiscard]] double impulse_steps(int level, std::int64_t step) const noexcept {
    return step == 0 ? 0.5 * (steps_of(level) + 1.0) : steps_of(level);
  }
  /// Of the joint of two elements while it shakes: by this sides are put in blocks. The base has the highest.
  [[nodiscard]] int joint_level_in_cycles(std::int32_t a, std::int32_t b) const noexcept { return lower(of_joints, a, b); }
  /// The same in this step: while it settles there is one level.
  [[nodiscard]] int joint_level(std::int32_t a, std::int32_t b) const noexcept { return on() ? lower(of_joints, a, b) : 0; }
  [[nodiscard]] int contact_level(std::int32_t a, std::int32_t b) const noexcept { return on() ? lower(of_contacts, a, b) : 0; }

 private:
  static int lower(const std::vector<std::uint8_t>& of, std::int32_t a, std::int32_t b) noexcept {
    return of.empty() ? 0 : std::min(of[static_cast<std::size_t>(a)], of[static_cast<std::size_t>(b)]);
  }
};

/// Numbers sorted by their level, ascending within each level: those that are due in a step come first.
struct ByLevel {
  std::vector<std::int32_t> list;
  std::vector<std::int64_t> end;  // by level
  /// \param level  of each number from 0 on; those of `levels` or above are left out
  void sort(const std::vector<std::uint8_t>& level, int levels);
};

}  // namespace voussoir::solver
