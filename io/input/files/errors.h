// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "io/input/messages/messages.h"

namespace voussoir::io {

/// A fault of a file that cannot be read, written or understood. The message is "path: what", or "path:line: what".
class FileError : public std::runtime_error {
 public:
  FileError(std::string path, const std::string& what) : std::runtime_error(path + ": " + what), path_(std::move(path)) {}
  FileError(std::string path, long line, const std::string& what)
      : std::runtime_error(path + ":" + std::to_string(line) + ": " + what), path_(std::move(path)), line_(line) {}
  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// From 1; 0: the whole file.
  [[nodiscard]] long line() const noexcept { return line_; }
  [[nodiscard]] Message message() const { return {.text = what(), .file = path_, .line = line_}; }

 private:
  std::string path_;
  long line_ = 0;
};

/// A fault of a file that is named by a key of the case.
class NamedFileError : public FileError {
 public:
  NamedFileError(const FileError& fault, std::string key) : FileError(fault), key_(std::move(key)) {}
  [[nodiscard]] const std::string& key() const noexcept { return key_; }

 private:
  std::string key_;
};

}  // namespace voussoir::io
