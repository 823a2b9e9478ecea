// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/joints/joint_tasks.h"
#include "solver/world/stages.h"

/// A small model of the schedule of a step: what it would take on more cores than the machine has.
namespace voussoir::solver {

/// What was measured of a step, the mean over some, by colour.
struct MeasuredStep {
  std::vector<double> tasks;  // s, of joints on one thread, by task
  StageTimes one{}, two{};    // s, of one and of two threads; two: zeros if there is one core only
  ForceTimes parts{};         // s, of one thread
  double alone = 0.0;         // s, of the forces what one thread does after the team
  double handover = 0.0;      // s, for one thread to see what another has written
};

/// A step on so many cores, s.
struct PredictedStep {
  int cores = 1;
  double step = 0.0;
  double joints = 0.0, contacts = 0.0;  // of the mean thread
  double waiting = 0.0;                 // of the mean thread: for tasks of others, for the last at a barrier, and for the barriers
  double others = 0.0;                  // update, search, ledger, as far as threads share them
  double alone = 0.0;                   // what one thread does alone
};

/// Joints: each thread goes through its queue (JointTasks::plan); a task begins when those that it waits for have ended, and a hand-over
/// later if another thread did them. Borders of shares move as in a run. Nobody helps another. Contacts and the update are shared evenly. So
/// are searches and the ledger as far as two threads made them shorter: what they took on two beyond half of what they took on one is done
/// alone, as are the booking of damage and the output. A barrier takes a hand-over a thread. Every core has the caches and the share of the
/// memory that one has here; what cores take from each other's caches otherwise is left out.
PredictedStep predict(const JointTasks& tasks, const MeasuredStep& measured, int cores);

/// When each thread has done its queue, and how long it waited for others meanwhile, s.
struct QueueTimes {
  std::vector<double> end, waited;
};
QueueTimes go_through(const JointTasks& tasks, const JointTasks::Plan& plan, const std::vector<double>& times, double handover);

}  // namespace voussoir::solver
