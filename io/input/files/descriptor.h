// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>
#include <utility>

#include "io/input/files/errors.h"

/// Shared by the sources of this folder that use system calls; not for other code.
namespace voussoir::io {

inline std::string system_words(int error) { return std::generic_category().message(error); }

/// A file descriptor, closed by the destructor.
class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : id_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (id_ < 0) throw FileError(path, "cannot open: " + system_words(errno));
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (id_ >= 0) ::close(id_);
  }
  [[nodiscard]] int id() const noexcept { return id_; }
  int release() noexcept { return std::exchange(id_, -1); }

 private:
  int id_;
};

inline void write_all(int file, const char* data, std::size_t bytes, const std::string& path) {
  while (bytes > 0) {
    const ssize_t n = ::write(file, data, bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FileError(path, "cannot write: " + system_words(errno));
    data += n;
    bytes -= static_cast<std::size_t>(n);
  }
}

}  // namespace voussoir::io
