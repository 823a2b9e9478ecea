// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace voussoir::solver {

/// The stages of a step, in order. What each needs and makes: run/step_stages.h.
enum class StepStage : std::uint8_t {
  supports,
  search,
  contact_levels,
  gather_lists,
  moves,
  own_joints,
  contacts,
  overlaps,
  late_joints,
  gather,
  findings,
  overlap_forces,
  ties,
  cuts,
  damage,
  base_forces,
  impulses,
  ledger_before,
  support_work,
  velocities_before,
  load_program,
  loads,
  support_velocities,
  relaxation,
  kick,
  samples,
  drift,
  support_spins,
  ledger_after
};

/// Writes down which stages a step goes through, for tests. Of a team of threads, the first one notes.
class StepLog {
 public:
  void note(StepStage stage) {
    if (stages_ != nullptr) stages_->push_back(stage);
  }
  /// From now on they go there; nullptr: nowhere, as at first.
  void write_to(std::vector<StepStage>* stages) { stages_ = stages; }

 private:
  std::vector<StepStage>* stages_ = nullptr;
};

}  // namespace voussoir::solver
