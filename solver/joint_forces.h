// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/world.h"

/// Stage 3 of the step: forces of all joints, colour by colour.
namespace voussoir::solver {

/// What the joints did in a step, in an order that does not depend on the threads.
/// What one thread found; sorted together afterwards.
struct JointFindings {
  std::vector<kernels::SegmentEvent> events;
  std::vector<std::int32_t> coming_apart;
  std::vector<kernels::SegmentEvent> room;  // for the block in hand
};

struct JointEvents {
  std::vector<kernels::SegmentEvent> events;  // sorted by (side, point)
  std::vector<std::int32_t> coming_apart;     // sides whose faces no longer face each other, ascending
  std::vector<JointFindings> by_thread;       // scratch
};

/// Adds the forces of all sides to the wrench rows; advances the history of damaged ones. \param time of the step [s], for first_time
void joint_forces(World& w, double time, std::int64_t step, JointEvents& out);

/// Elastic energy now [J]: of bonded springs, and of contact springs of joints. Valid after joint_forces, before the positions move on.
struct StoredEnergy {
  double bonds = 0.0, contact = 0.0;
};
/// Of all joints as they are after joint_forces.
StoredEnergy joint_energy(World& w);

}  // namespace voussoir::solver
