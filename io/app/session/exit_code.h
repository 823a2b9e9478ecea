// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// How the program ends.
namespace voussoir::io {

/// Exit codes of commands; a stop by signal N exits with 128 + N. 4 is that of a processor that is too old (io/app/processor), which no
/// command sees.
enum ExitCode : int { kDone = 0, kNumericalFailure = 1, kInputFault = 2, kFileFault = 3 };

}  // namespace voussoir::io
