// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/forces.h"

#include <omp.h>

namespace voussoir::solver {

namespace {

/// What each element takes from the slots of its contacts.
void gather(World& w, int due, LapClock& clock) {
  if (w.contacts.active.empty()) return;
#pragma omp barrier
  clock.begin();
  const std::int64_t elements = gatherers(w, due).size();
#pragma omp for schedule(static) nowait
  for (std::int64_t e = 0; e < elements; ++e) gather_contacts(w, due, e);
  clock.lap(ForcePart::assembly);
}

}  // namespace

void forces(World& w, double time, std::int64_t step, ForceStage& stage) {
  stage.by_thread.resize(static_cast<std::size_t>(w.threads));
  stage.tasks.begin(w.threads);
  const int due = w.multirate.due(step);
  const JointStep joints{w, time, step, due, stage.tasks};
  int team = 0;  // the system may give fewer
#pragma omp parallel num_threads(w.threads) reduction(+ : team)
  {
    team = 1;
    ThreadRoom& mine = stage.by_thread[static_cast<std::size_t>(omp_get_thread_num())];
    mine.clock = LapClock(stage.split);
    const auto note = [&w, first = omp_get_thread_num() == 0](StepStage s) {
      if (first) w.log.note(s);
    };
    note(StepStage::own_joints);
    advance_own_joints(joints, mine.joints, mine.clock);
    mine.clock.begin();
    note(StepStage::contacts);
    advance_contacts(w, due, mine.contacts);
    note(StepStage::overlaps);
    find_overlaps(w, due, mine.overlaps);
    mine.clock.lap(ForcePart::contacts);
    note(StepStage::late_joints);
    help_with_joints(joints, mine.joints, mine.clock);
    note(StepStage::gather);
    gather(w, due, mine.clock);
  }
  const double ended = stage.split ? omp_get_wtime() : 0.0;
  std::vector<JointFindings*> found;
  std::vector<OverlapFound> overlaps;
  for (std::size_t thread = 0; thread < static_cast<std::size_t>(team); ++thread) {
    ThreadRoom& r = stage.by_thread[thread];
    for (const std::int32_t e : r.joints.looked_at) w.travel.activate_at_next_drift(e);
    r.joints.looked_at.clear();
    found.push_back(&r.joints);
    overlaps.insert(overlaps.end(), r.overlaps.begin(), r.overlaps.end());
    r.overlaps.clear();
    for (std::size_t k = 0; k < kForceParts; ++k) stage.parts[k] += r.clock.times()[k] / team;
  }
  w.log.note(StepStage::findings);
  collect(found, stage.events);
  w.log.note(StepStage::overlap_forces);
  apply_overlaps(w, due, overlaps);
  if (stage.split) stage.alone += omp_get_wtime() - ended;
}

}  // namespace voussoir::solver
