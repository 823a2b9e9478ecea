// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// How the program ends.
namespace voussoir::io {

/// Exit codes of the program; a stop by signal N exits with 128 + N.
enum ExitCode : int { kDone = 0, kNumericalFailure = 1, kInputFault = 2, kFileFault = 3 };

}  // namespace voussoir::io
