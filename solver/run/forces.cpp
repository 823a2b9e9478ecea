// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/forces.h"

#include <chrono>

#include "geometry/nth.h"

namespace voussoir::solver {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t kElementsAtATime = 256, kOverlapsAtATime = 64;

void begin(World& w, int due, ForceStage& stage) {
  const auto threads = static_cast<std::size_t>(w.team.size());
  if (stage.by_thread.size() < threads) stage.by_thread.resize(threads);
  for (ThreadRoom& r : stage.by_thread) r.clock = LapClock(stage.split);
  stage.tasks.begin(w.team);
  stage.contacts.begin(w, due);
  stage.overlaps.begin(overlaps_due(w, due).size(), kOverlapsAtATime);
}

/// What each element takes from the slots of its contacts.
void gather(World& w, int due, ForceStage& stage) {
  if (w.contacts.active.empty()) return;
  w.team.share_out(gatherers(w, due).size(), kElementsAtATime, [&](std::int64_t first, std::int64_t last, int thread) {
    LapClock& clock = nth(stage.by_thread, thread).clock;
    clock.begin();
    for (std::int64_t e = first; e < last; ++e) gather_contacts(w, due, e);
    clock.lap(ForcePart::assembly);
  });
}

/// What the threads have found, in an order that does not depend on them.
void merge(World& w, int due, ForceStage& stage) {
  std::vector<JointFindings*> found;
  std::vector<OverlapFound> overlaps;
  for (ThreadRoom& r : stage.by_thread) {
    for (const std::int32_t e : r.joints.looked_at) w.travel.activate_at_next_drift(e);
    r.joints.looked_at.clear();
    found.push_back(&r.joints);
    overlaps.insert(overlaps.end(), r.overlaps.begin(), r.overlaps.end());
    r.overlaps.clear();
    for (std::size_t k = 0; k < kForceParts; ++k) stage.parts[k] += r.clock.times()[k] / w.team.size();
  }
  w.log.note(StepStage::findings);
  collect(found, stage.events);
  w.log.note(StepStage::overlap_forces);
  apply_overlaps(w, due, overlaps);
}

}  // namespace

void forces(World& w, double time, std::int64_t step, ForceStage& stage) {
  const int due = w.multirate.due(step);
  begin(w, due, stage);
  const JointStep joints{w, time, step, due, stage.tasks};
  w.team.run([&](int thread) {
    ThreadRoom& mine = nth(stage.by_thread, thread);
    const auto note = [&w, first = thread == 0](StepStage s) {
      if (first) w.log.note(s);
    };
    note(StepStage::own_joints);
    advance_own_joints(joints, thread, mine.joints, mine.clock);
    mine.clock.begin();
    note(StepStage::contacts);
    advance_contacts(w, due, stage.contacts, mine.contacts);
    note(StepStage::overlaps);
    find_overlaps(w, due, stage.overlaps, mine.overlaps);
    mine.clock.lap(ForcePart::contacts);
    note(StepStage::late_joints);
    help_with_joints(joints, thread, mine.joints, mine.clock);
  });
  w.log.note(StepStage::gather);
  gather(w, due, stage);
  const Clock::time_point ended = Clock::now();
  merge(w, due, stage);
  if (stage.split) stage.alone += std::chrono::duration<double>(Clock::now() - ended).count();
}

}  // namespace voussoir::solver
