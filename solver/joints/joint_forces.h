// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/schedule/joint_tasks.h"
#include "solver/world/stages.h"
#include "solver/world/world.h"

/// Stage 3 of the step: forces of all joints.
namespace voussoir::solver {

/// What one thread found; sorted together afterwards.
struct JointFindings {
  std::vector<kernels::SegmentEvent> events;
  std::vector<std::int32_t> coming_apart;
  std::vector<std::int32_t> looked_at;  // elements whose velocities were read, in batches that were not active
  // For the block in hand.
  std::vector<kernels::SegmentEvent> room;
  std::array<kernels::DamagedSide, kernels::kLanes> sides;
};

/// What the joints did in a step, in an order that does not depend on the threads.
struct JointEvents {
  std::vector<kernels::SegmentEvent> events;  // sorted by (side, point)
  std::vector<std::int32_t> coming_apart;     // sides whose faces no longer face each other, ascending
};

/// The joints in one step, to be advanced by every thread of a team, each with its findings. Threads may leave before all is done.
struct JointStep {
  World& w;
  double time;  // s
  std::int64_t step;
  int levels;  // that are due in it, from 0 on
  JointTasks& tasks;
};
/// Those of a thread's own queue.
void advance_own_joints(const JointStep& s, JointFindings& found, LapClock& clock);
/// Then: what other threads have left of theirs, if they are late.
void help_with_joints(const JointStep& s, JointFindings& found, LapClock& clock);

/// Merges the threads' findings; sorting makes their order a property of the model, not of the scheduling. Empties them.
void collect(std::span<JointFindings*> found, JointEvents& out);

}  // namespace voussoir::solver
