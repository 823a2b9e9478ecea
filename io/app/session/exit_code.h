// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Exit codes of the program.
namespace voussoir::io {

/// Exit codes of commands; a stop by signal N exits with 128 + N. Code 4 means an unsupported processor (io/app/processor) and is given
/// before any command.
enum ExitCode : int { kDone = 0, kNumericalFailure = 1, kInputFault = 2, kFileFault = 3 };

}  // namespace voussoir::io
