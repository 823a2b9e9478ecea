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

/// Findings of one thread; sorted together afterwards.
struct JointFindings {
  std::vector<kernels::SegmentEvent> events;
  std::vector<std::int32_t> coming_apart;
  std::vector<std::int32_t> looked_at;  // elements of inactive batches whose velocities were read
  // For the current block.
  std::vector<kernels::SegmentEvent> room;
  std::array<kernels::DamagedSide, kernels::kLanes> sides;
};

/// Joint events of a step, in an order that does not depend on the threads.
struct JointEvents {
  std::vector<kernels::SegmentEvent> events;  // sorted by (side, point)
  std::vector<std::int32_t> coming_apart;     // sides whose faces no longer face each other, ascending
};

/// The joints in one step, to be advanced by the threads of a team, each with its own findings. Threads may return before all is done.
struct JointStep {
  World& w;
  double time;  // s
  std::int64_t step;
  int levels;  // number of due levels, from level 0 on
  JointTasks& tasks;
};
/// Advances the joints of the thread's own queue.
void advance_own_joints(const JointStep& s, int thread, JointFindings& found, LapClock& clock);
/// Helps threads that are late with the rest of their queues. To be called after advance_own_joints.
void help_with_joints(const JointStep& s, int thread, JointFindings& found, LapClock& clock);

/// Merges and empties the threads' findings; sorting makes their order a property of the model, not of the scheduling.
void collect(std::span<JointFindings*> found, JointEvents& out);

}  // namespace voussoir::solver
