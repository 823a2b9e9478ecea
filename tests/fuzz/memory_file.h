// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace voussoir::fuzz {

/// A file in memory that readers and HDF5 open by its path (HDF5 creates none by a path in /proc/self/fd).
class MemoryFile {
 public:
  MemoryFile() : id_(::mkstemp(path_.data())) {
    if (id_ < 0) std::abort();
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    ::close(id_);
    ::unlink(path_.c_str());
  }

  void fill(const std::uint8_t* data, std::size_t size) {
    if (::ftruncate(id_, 0) != 0 || ::pwrite(id_, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_ = "/dev/shm/voussoir-fuzz-XXXXXX";
  int id_;
};

}  // namespace voussoir::fuzz
