// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/schedule/joint_tasks.h"
#include "solver/world/stages.h"

/// A simple model of the schedule of a step, which predicts its time on more cores than the machine has.
namespace voussoir::solver {

/// Measured times: means over some steps, with joints in tasks by colour.
struct MeasuredStep {
  std::vector<double> tasks;  // s, of joints on one thread, by task
  StageTimes one{}, two{};    // s, of one and of two threads; two: zeros if the machine has one core only
  ForceTimes parts{};         // s, of one thread
  double alone = 0.0;         // s, of one thread working alone at the end of the stage of forces
  double handover = 0.0;      // s, until one thread sees a value written by another
};

/// Predicted times of a step on a number of cores [s].
struct PredictedStep {
  int cores = 1;
  double step = 0.0;
  double joints = 0.0, contacts = 0.0;  // of the mean thread
  double waiting = 0.0;                 // of the mean thread: for tasks of other threads, for the last at a barrier, and for the barriers
  double others = 0.0;                  // update, search, ledger, as far as shared by threads
  double alone = 0.0;                   // work of one thread alone
};

/// Predicts the time of a step on `cores` cores. Joints: each thread processes its queue (JointTasks::plan); a task begins when all tasks
/// that it waits for have ended, plus a hand-over if another thread did them. Borders of shares move as in a run, but threads do not help
/// each other, as they do there. Contacts and the update are shared evenly. A search or a row of the ledger that took t1 on one thread and
/// t2 on two has a serial part of 2 t2 − t1, and the rest is shared; damage and output are serial. A barrier of n threads takes n
/// hand-overs. Every core is assumed to have the caches and the share of the memory bandwidth of one core here; other traffic between
/// caches is ignored.
PredictedStep predict(const JointTasks& tasks, const MeasuredStep& measured, int cores);

/// By thread, the end of its queue, and its time of waiting for other threads [s].
struct QueueTimes {
  std::vector<double> end, waited;
};
QueueTimes go_through(const JointTasks& tasks, const JointTasks::Plan& plan, const std::vector<double>& times, double handover);

}  // namespace voussoir::solver
