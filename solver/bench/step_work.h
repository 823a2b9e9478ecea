// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// What a step has to do at least, to measure its time against what the machine can do (machine.h).
namespace voussoir::solver {

struct Work {
  double operations = 0.0;  // floating-point; a multiply-add counts two; 0: not known
  double bytes = 0.0;       // read or written, each place once a step however often it is fetched, as STREAM counts
};

/// Of a step of a world as it is. Operations are those of the vector kernels, as scripts/count_operations counts them (perf/README.md):
/// for damaged joints and contacts they depend on what segments and points do, and stand here for a house in its collapse.
struct StepWork {
  Work whole_joints, damaged_joints, contacts, assembly, update;
  double whole_sides = 0.0, damaged_sides = 0.0;  // that hand out forces: in blocks in which nothing has happened, and in others
};
StepWork step_work(const World& w);

}  // namespace voussoir::solver
