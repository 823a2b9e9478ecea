// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>

/// Set-up of the process before a command, and its end.
namespace voussoir::io {

/// Raises the limit of open files. Makes a file at the size limit an error like a full disk instead of a signal. Makes the program end with
/// a message and an exit code when memory runs out within a team of threads, where no handler is reached.
void prepare_process();

/// \return `code`, or that of a file fault if standard output has been lost, as on a full disk
int code_after_output(int code);

/// Prints an otherwise unhandled exception. \return the exit code
int end_unexpectedly(const std::exception& e);

}  // namespace voussoir::io
