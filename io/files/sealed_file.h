// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/files/errors.h"

/// A file that knows whether it is whole: a header of 512 bytes, and contents. The header is text: what it is, its version, and the number
/// and a hash (FNV-1a) of the bytes that follow. A file that is cut off or has changed in a single bit is known before anybody tries to
/// understand it. HDF5's own tools look for their file behind a header of this size, too, and find it.
namespace voussoir::io {

/// A sealed file that is cut off, changed, or none at all.
class DamagedFile : public FileError {
 public:
  using FileError::FileError;
};

inline constexpr std::size_t kSealBytes = 512;

/// The header for contents. \param what  "voussoir checkpoint"
std::string seal(const std::string& what, std::int64_t version, std::span<const std::byte> contents);

/// The contents of a sealed file in memory. \param name  for messages
/// \throw DamagedFile; FileError if it is whole and has another version
std::span<const std::byte> unsealed(const std::string& name, const std::string& what, std::int64_t version,
                                    std::span<const std::byte> bytes);

/// Writes header and contents under the final name: whole and on disk, or not at all. \throw FileError
void write_sealed(const std::string& path, const std::string& what, std::int64_t version, std::span<const std::byte> contents);

/// All bytes of a regular file. \throw FileError
std::vector<std::byte> read_bytes(const std::string& path);

}  // namespace voussoir::io
