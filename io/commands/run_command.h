// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/case_file/case_file.h"
#include "io/results/checkpoints.h"
#include "io/session/exit_code.h"
#include "io/session/views.h"

/// `voussoir run`, `check` and `cases`: what they do once the command line is read. Results go to standard output, progress to standard
/// error.
namespace voussoir::io {

struct RunOptions {
  std::string folder;  // of the results
  bool reference_kernels = false;
  bool gather = false;  // --scatter gather
  bool overwrite = false, quiet = false;
  CheckpointSchedule checkpoints;
  Views views;  // to write at the end
};

/// Builds, settles, shakes, writes. \return kDone, kNumericalFailure, or 128 + the signal that stopped it.
/// \throw cases::InputError, FileError before anything runs; FileError later if results cannot be written
int run_command(const LoadedCase& c, const RunOptions& o);

struct CheckOptions {
  std::string draw;  // SVG file of a drawing; empty: none
  bool overwrite = false;
  bool json = false;
};

/// Reads, builds and reports; runs nothing. \throw cases::InputError, FileError
int check_command(const LoadedCase& c, const CheckOptions& o);

/// The catalogue, one line a case.
int cases_command();

}  // namespace voussoir::io
