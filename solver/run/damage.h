// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/joints/joint_forces.h"
#include "solver/run/recorder.h"
#include "solver/world/world.h"

/// Counts of broken and slipped segments, in segment sides (a merged spring counts two).
namespace voussoir::solver {

/// Bonded sides, slipped ones among these, and broken sides by the mode that opened them.
struct Damage {
  std::int64_t bonded = 0, slipped = 0, tension = 0, shear = 0, compression = 0;
};

/// Segment sides by the limit that they reached first, whether broken since or only slipped. Reads all segments.
FirstLimits first_limits(const World& w);

/// Counts of a world before its first step.
Damage initial_damage(const World& w);

/// Records the events of a step: counts, bonds of the elements, damping of debris, one crack row per broken segment; then retires the sides
/// that came apart (breaking their remaining bonds). Rows are appended in a fixed order.
void record_damage(World& w, const JointEvents& events, double time, Damage& d, std::vector<CrackRow>& cracks);

}  // namespace voussoir::solver
