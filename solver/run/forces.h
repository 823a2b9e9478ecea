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

/// One thread's room.
struct ThreadRoom {
  JointFindings joints;
  ContactRoom contacts;
  std::vector<OverlapFound> overlaps;
  LapClock clock;
};

struct ForceStage {
  JointEvents events;  // of the last step
  std::vector<ThreadRoom> by_thread;
  JointTasks tasks;
  bool split = false;  // whether parts are timed
  ForceTimes parts{};  // of the mean thread, so far
  double alone = 0.0;  // s, of one thread after the team, so far; while parts are timed
};

/// One team of threads from the first side to the last slot. Contacts and joints need nothing of each other: a thread that has done
/// its own joints goes on with contacts, where others still work on theirs, and helps these last.
/// \pre  the gather lists of contacts are up to date (build_gather)
void forces(World& w, double time, std::int64_t step, ForceStage& stage);

}  // namespace voussoir::solver
