// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/world/array.h"

namespace voussoir::solver {

/// How often a pair of bodies is evaluated.
enum class Pace : std::uint8_t { every_step, every_cycle };

/// Multi-rate stepping (THEORY.md (24a), `time.multirate`). A pair is *fast* if one of its two elements is, and is evaluated in every step.
/// All others are *slow*: they are evaluated in the first step of every cycle, as if the cycle were one step, and their forces act in that
/// step with the impulse of the whole cycle. An element is fast if the cycle is longer than its own bound (Eq. 19) allows, and so are its
/// neighbours and their neighbours: the impulses of slow pairs can hardly excite the elements that limit the step then
/// (perf/multirate_resonance.py).
struct Multirate {
  std::int32_t wanted = 1;         // steps of a cycle while it shakes
  std::int32_t cycle = 1;          // now: 1 while it settles
  std::vector<std::uint8_t> fast;  // Constant by row of elements; empty: every pair is fast
  // Rows as in kernels/rows.h, of slow pairs alone.
  Array<double> twist;            // State: sums over the steps of this cycle; when the cycle is over, the means
  Array<double> wrench, dashpot;  // N, N m, in the first step of a cycle; else 0

  [[nodiscard]] bool on() const noexcept { return cycle > 1; }
  [[nodiscard]] bool starts_cycle(std::int64_t step) const noexcept { return step % cycle == 0; }
  /// Steps whose impulse acts in this one, of slow pairs, gravity and ground: those of a cycle in its first step, else none. The first
  /// cycle of all begins with a velocity of half a step before it, so half a cycle and half a step.
  [[nodiscard]] double impulse_steps(std::int64_t step) const noexcept {
    return step == 0 ? 0.5 * (cycle + 1.0) : starts_cycle(step) ? cycle : 0.0;
  }
  /// Of the pair of two elements while it shakes: by this sides are put in blocks. The base is never fast.
  [[nodiscard]] Pace pace_in_cycles(std::int32_t a, std::int32_t b) const noexcept {
    const auto is_fast = [&](std::int32_t e) { return fast.empty() || fast[static_cast<std::size_t>(e)] != 0; };
    return is_fast(a) || is_fast(b) ? Pace::every_step : Pace::every_cycle;
  }
  /// The same in this step: while it settles every pair is evaluated in every step.
  [[nodiscard]] Pace pace_now(std::int32_t a, std::int32_t b) const noexcept { return on() ? pace_in_cycles(a, b) : Pace::every_step; }
};

}  // namespace voussoir::solver
