// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

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

/// The contents of a sealed file in memory. \param name  for messages \param what  "voussoir checkpoint"
/// \throw DamagedFile; FileError if it is whole and has another version
std::span<const std::byte> unsealed(const std::string& name, const std::string& what, std::int64_t version,
                                    std::span<const std::byte> bytes);

/// Whether a file on disk is whole, read piece by piece: as unsealed().
void check_seal(const std::string& path, const std::string& what, std::int64_t version);

/// A sealed file on its way. HDF5 writes the contents to disk behind the room for the header, under a temporary name, so that they need no
/// memory; seal() completes the file and gives it its name: whole and on disk, or not at all. Dropped before, it leaves nothing.
class SealedFile {
 public:
  /// \param room  bytes that the contents will take, or more: asked from the disk before anything is written, since HDF5 cannot be trusted
  /// to survive a full one \throw FileError
  SealedFile(std::string path, std::uint64_t room);
  ~SealedFile();
  SealedFile(const SealedFile&) = delete;
  SealedFile& operator=(const SealedFile&) = delete;

  [[nodiscard]] Hdf5File& contents() noexcept { return contents_; }
  /// \throw FileError
  void seal(const std::string& what, std::int64_t version);

 private:
  std::string path_, temporary_;
  Hdf5File contents_;
  bool sealed_ = false;
};

}  // namespace voussoir::io
