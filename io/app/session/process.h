// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>

/// What is set up before a command runs, and how the program ends.
namespace voussoir::io {

/// Many files may be open at once. A file at the size limit is an error like a full disk, not a signal. Running out of memory within a team
/// of threads, where no handler is reached, ends the program as elsewhere: with a message and an exit code.
void prepare_process();

/// \return the exit code; that of a file that cannot be written if standard output has been lost, as on a full disk
int code_after_output(int code);

/// Prints an exception that nothing else handles. \return the exit code
int end_unexpectedly(const std::exception& e);

}  // namespace voussoir::io
