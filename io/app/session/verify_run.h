// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/input/case_file/case_file.h"

/// `voussoir run CASE --verify`: checks on the user's case and machine, in about a minute, that results have equal bits. Writes no results.
namespace voussoir::io {

/// Runs a short run (the first half settling, the second shaking) with one thread, with all threads, and with all threads and two stops
/// with a checkpoint each, and compares the complete states.
/// \return kDone if all states are equal; kNumericalFailure if not, or after a numerical failure \throw as `run`
int verify(const LoadedCase& c, bool reference_kernels, int threads);

}  // namespace voussoir::io
