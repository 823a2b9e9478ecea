// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace voussoir::io {

/// A program that reads what it is given from its standard input; what it says goes to a file.
class ChildInput {
 public:
  /// Starts it. \param words  the program, of the PATH or with its folders, and its arguments \param log  file for both of its outputs
  /// \param hint  what to do if it cannot be started, for the message \throw FileError
  ChildInput(std::vector<std::string> words, std::string log, const std::string& hint);
  ChildInput(const ChildInput&) = delete;
  ChildInput& operator=(const ChildInput&) = delete;
  /// Ends it, if it has not been waited for.
  ~ChildInput();

  /// \throw FileError with its last words if it takes no more
  void write(std::span<const std::byte> bytes);
  /// Closes its input and waits until it is done. \throw FileError with its last words if it fails
  void finish();

 private:
  [[noreturn]] void fail(const std::string& what);

  std::vector<std::string> words_;
  std::string log_;
  pid_t pid_ = -1;
  int input_ = -1;
};

}  // namespace voussoir::io
