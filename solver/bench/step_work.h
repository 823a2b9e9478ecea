// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// Minimum work of a step, for comparison of its time with the limits of the machine (machine.h).
namespace voussoir::solver {

struct Work {
  double operations = 0.0;  // floating-point; a multiply-add counts as two; 0: unknown
  double bytes = 0.0;       // read or written, each location once per step however often it is fetched, as in STREAM
};

/// Work of a step of a world in its current state. Operations are those of the vector kernels, counted by scripts/count_operations
/// (perf/README.md): for damaged joints and contacts they depend on the state of segments and points, and are those of a house during
/// collapse.
struct StepWork {
  Work whole_joints, damaged_joints, contacts, assembly, update;
  double whole_sides = 0.0, damaged_sides = 0.0;  // sides with forces: in undamaged blocks, and in others
};
StepWork step_work(const World& w);

}  // namespace voussoir::solver
