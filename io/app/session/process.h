// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

/// Set-up of the process before a command, and its end.
namespace voussoir::io {

inline constexpr int kMostThreads = 1024;

/// Raises the limits of open files and of the stack; ends the program with a message if the stack is too small to work with. Makes a file
/// at the size limit an error like a full disk instead of a signal. Makes the program end with a message and an exit code when memory runs
/// out within a team of threads, where no handler is reached.
void prepare_process();

/// Number of threads to work with: as many as wanted; under limits on memory or processes a quarter of those that could be had, with a
/// warning, since threads are not all that takes memory.
int threads_to_be_had(int wanted);

/// Notes what the command does now, for the message if memory runs out. \param what  a literal: "building the model"
void now_doing(const char* what);

/// Gives memory that is free back to the system. The allocator keeps what lies between blocks in use: after a model is built as much again
/// as the model. For use where one large thing ends and before the next begins.
void give_memory_back() noexcept;

/// \return `code`, or that of a file fault if standard output has been lost, as on a full disk
int code_after_output(int code);

/// Prints an otherwise unhandled exception. \return the exit code
int end_unexpectedly(const std::exception& e);

}  // namespace voussoir::io
