// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/input/case_file/case_file.h"

/// `voussoir run CASE --verify`: the promise of equal bits, tried on the user's own case and machine in about a minute. Writes no results.
namespace voussoir::io {

/// Steps a short run (the first half settling, the second shaking) with one thread, with all of them, and with all of them and two stops
/// with a checkpoint each, and compares the whole state.
/// \return kDone if all have the same bits; kNumericalFailure if not, or if the numbers go wrong \throw as `run`
int verify(const LoadedCase& c, bool reference_kernels);

}  // namespace voussoir::io
