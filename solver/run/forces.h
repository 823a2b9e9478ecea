// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/contact/contact_forces.h"
#include "solver/contact/overlap_contact.h"
#include "solver/joints/joint_forces.h"
#include "solver/world/stages.h"

/// Stage 3 of the step: the forces of joints and contacts on the elements' rows.
namespace voussoir::solver {

/// Working memory of one thread.
struct ThreadRoom {
  JointFindings joints;
  ContactRoom contacts;
  std::vector<OverlapFound> overlaps;
  LapClock clock;
};

struct ForceStage {
  JointEvents events;  // of the last step
  std::vector<ThreadRoom> by_thread;
  ContactRuns contacts;
  Tickets overlaps;
  JointTasks tasks;
  bool split = false;  // whether parts are timed
  ForceTimes parts{};  // of the mean thread, accumulated
  double alone = 0.0;  // s, of one thread after the team, accumulated while parts are timed
};

/// Computes all forces. Contacts and joints are independent: a thread that has finished its joints continues with contacts while others
/// still process joints, and helps those last. Then the forces of contacts are added to elements.
/// \pre the gather lists of contacts are up to date (build_gather)
void forces(World& w, double time, std::int64_t step, ForceStage& stage);

}  // namespace voussoir::solver
