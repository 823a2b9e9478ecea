// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace voussoir::fuzz {

/// A file in memory that readers open by its path.
class MemoryFile {
 public:
  MemoryFile() : id_(::memfd_create("fuzz", 0)), path_("/proc/self/fd/" + std::to_string(id_)) {
    if (id_ < 0) std::abort();
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(id_); }

  void fill(const std::uint8_t* data, std::size_t size) {
    if (::ftruncate(id_, 0) != 0 || ::pwrite(id_, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  int id_;
  std::string path_;
};

}  // namespace voussoir::fuzz
