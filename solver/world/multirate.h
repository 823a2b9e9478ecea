// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/nth.h"
#include "solver/world/array.h"

namespace voussoir::solver {

/// Multi-rate stepping (THEORY.md (24a), `time.multirate`). A pair of elements has a *level*: pairs of level l are evaluated in every
/// `every[l]`-th step, as if all these steps were one, and their forces act there with the impulse of all these steps. Level 0 is every
/// step. An element has the highest level that its own bound (Eq. 19), those of its neighbours and those of their neighbours all allow:
/// impulses of slow pairs can then hardly excite stiff elements (perf/multirate_resonance.py). Levels are then lowered until neighbours
/// differ by at most one, since fast dashpots would otherwise dissipate more energy than was put in. A pair has the lower level of its two
/// elements.
struct Multirate {
  static constexpr std::size_t kMostLevels = 4;  // 1, 2, 4 and 8 steps
  std::int32_t wanted = 1;                       // steps of a cycle during the shaking: last entry of `every`
  std::int32_t cycle = 1;                        // current value: 1 while settling
  std::vector<std::int32_t> every{1};            // by level: steps, twice as many as of the level below
  std::vector<std::uint8_t> own;                 // Constant by row of elements: highest level allowed by its own bound; empty: 0
  std::vector<std::uint8_t> of_joints;    // State by row of elements: level for its contacts; at most that of its joints while any holds
  std::vector<std::uint8_t> of_contacts;  // State by row of elements: for its contacts; not above that of its joints while one holds
  /// Rows as in kernels/rows.h, for pairs of one level only.
  struct Rows {
    Array<double> twist;            // State: sums over the steps since the last evaluation; in the step of evaluation, means
    Array<double> wrench, dashpot;  // N, N m, in a step of evaluation; else 0
  };
  std::vector<Rows> rows;  // of levels from 1 on

  [[nodiscard]] bool on() const noexcept { return cycle > 1; }
  [[nodiscard]] bool starts_cycle(std::int64_t step) const noexcept { return step % cycle == 0; }
  /// Number of levels in this phase of the run.
  [[nodiscard]] int levels() const noexcept { return on() ? static_cast<int>(every.size()) : 1; }
  /// Number of levels evaluated in a step: those from 0 on.
  [[nodiscard]] int due(std::int64_t step) const noexcept {
    int levels_due = 1;
    while (levels_due < levels() && step % nth(every, levels_due) == 0) ++levels_due;
    return levels_due;
  }
  /// Number of steps from one evaluation of a level to the next.
  [[nodiscard]] std::int32_t steps_of(int level) const noexcept { return level == 0 ? 1 : nth(every, level); }
  /// Number of steps whose impulse acts in a step of evaluation. At the first one velocities are half a step old.
  [[nodiscard]] double impulse_steps(int level, std::int64_t step) const noexcept {
    return step == 0 ? 0.5 * (steps_of(level) + 1.0) : steps_of(level);
  }
  /// The same as a share of all steps of the level: of the impulse of a force that acts as long as pairs of that level do.
  [[nodiscard]] double impulse_share(int level, std::int64_t step) const noexcept { return impulse_steps(level, step) / steps_of(level); }
  /// Level of the joint of two elements during the shaking, by which sides are sorted into blocks. The base has the highest level.
  [[nodiscard]] int joint_level_in_cycles(std::int32_t a, std::int32_t b) const noexcept { return lower(of_joints, a, b); }
  /// Level of the joint of two elements in this step: 0 while settling.
  [[nodiscard]] int joint_level(std::int32_t a, std::int32_t b) const noexcept { return on() ? lower(of_joints, a, b) : 0; }
  [[nodiscard]] int contact_level(std::int32_t a, std::int32_t b) const noexcept { return on() ? lower(of_contacts, a, b) : 0; }

 private:
  static int lower(const std::vector<std::uint8_t>& of, std::int32_t a, std::int32_t b) noexcept {
    return of.empty() ? 0 : std::min(nth(of, a), nth(of, b));
  }
};

/// Numbers sorted by level, ascending within each level: numbers due in a step come first.
struct ByLevel {
  std::vector<std::int32_t> list;
  std::vector<std::int64_t> end;  // by level
  /// \param level  of each number from 0 on; numbers of level `levels` or above are left out
  void sort(const std::vector<std::uint8_t>& level, int levels);
};

/// The numbers of 0 ... count - 1 whose turn it is in a step: at several rates those that are listed for its levels, else all.
class DueNumbers {
 public:
  /// \param due  see Multirate::due
  DueNumbers(const Multirate& m, const ByLevel& listed, int due, std::size_t count)
      : list_(m.on() ? listed.list.data() : nullptr),
        size_(m.on() ? listed.end[static_cast<std::size_t>(due) - 1] : static_cast<std::int64_t>(count)) {}
  [[nodiscard]] std::int64_t size() const noexcept { return size_; }
  [[nodiscard]] std::size_t operator[](std::int64_t i) const noexcept {
    return static_cast<std::size_t>(list_ != nullptr ? std::int64_t{list_[i]} : i);
  }

 private:
  const std::int32_t* list_;  // nullptr: all
  std::int64_t size_;
};

}  // namespace voussoir::solver
