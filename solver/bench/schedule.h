// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/schedule/joint_tasks.h"
#include "solver/world/stages.h"

/// A small model of the schedule of a step: what it would take on more cores than the machine has.
namespace voussoir::solver {

/// What was measured: means over some steps, joints handed out by colour.
struct MeasuredStep {
  std::vector<double> tasks;  // s, of joints on one thread, by task
  StageTimes one{}, two{};    // s, of one and of two threads; two: zeros if there is one core only
  ForceTimes parts{};         // s, of one thread
  double alone = 0.0;         // s, that one thread works alone at the end of the stage of forces
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
/// later if another thread did them. Borders of shares move as in a run, but no thread helps another, as it does there. Contacts and the
/// update are shared evenly. Of a search or a row of the ledger, which took t1 on one thread and t2 on two, 2 t2 − t1 is done alone and the
/// rest shared; the booking of damage and the output are done alone. A barrier of n threads takes n hand-overs. Every core has the caches
/// and the share of the memory that one has here; what cores take from each other's caches otherwise is left out.
PredictedStep predict(const JointTasks& tasks, const MeasuredStep& measured, int cores);

/// When each thread has done its queue, and how long it waited for others meanwhile, s.
struct QueueTimes {
  std::vector<double> end, waited;
};
QueueTimes go_through(const JointTasks& tasks, const JointTasks::Plan& plan, const std::vector<double>& times, double handover);

}  // namespace voussoir::solver
