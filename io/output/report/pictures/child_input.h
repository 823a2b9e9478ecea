// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace voussoir::io {

/// A child process that reads its standard input; its output goes to a file.
class ChildInput {
 public:
  /// Starts the process. \param words  program (of the PATH or with its folder) and arguments \param log  file for both of its outputs
  /// \param hint  remedy if it cannot be started, for the message \throw FileError
  ChildInput(std::vector<std::string> words, std::string log, const std::string& hint);
  ChildInput(const ChildInput&) = delete;
  ChildInput& operator=(const ChildInput&) = delete;
  /// Ends the process unless finish() was called.
  ~ChildInput();

  /// Writes to its standard input. \throw FileError with its last output if the process does not accept the data
  void write(std::span<const std::byte> bytes);
  /// Closes its standard input and waits for its end. \throw FileError with its last output if the process fails
  void finish();

 private:
  [[noreturn]] void fail(const std::string& what);

  std::vector<std::string> words_;
  std::string log_;
  pid_t pid_ = -1;
  int input_ = -1;
};

}  // namespace voussoir::io
