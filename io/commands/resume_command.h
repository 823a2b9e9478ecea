// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "io/results/checkpoints.h"
#include "io/session/views.h"

/// `voussoir resume`: goes on with a run that was stopped, killed, or is to last longer.
namespace voussoir::io {

struct ResumeOptions {
  std::string folder;           // of the run
  std::optional<double> until;  // s of shaking; absent: as the run was meant
  bool quiet = false;
  CheckpointSchedule checkpoints;
  Views views;  // to write at the end
};

/// Goes on from the newest checkpoint that is whole; rows of the results behind it are dropped and computed again, to the same bits.
/// \return as run_command; kDone at once if the run is finished and `until` absent
/// \throw FileError if no checkpoint is good, or case, layout, physics or model are others than those of the checkpoint; it names the
/// difference. cases::InputError for an `until` that has passed
int resume_command(const ResumeOptions& o);

}  // namespace voussoir::io
