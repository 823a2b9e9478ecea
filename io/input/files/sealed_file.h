// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

/// A file with a checksum: a header of 512 bytes, and contents. The header is text: kind of file, version, and the number and a hash
/// (FNV-1a) of the following bytes. A truncated file, or one with a single changed bit, is thus detected before its contents are
/// interpreted. HDF5's own tools also look for HDF5 contents behind a header of this size.
namespace voussoir::io {

/// A sealed file that is truncated or changed, or a file that is not sealed.
class DamagedFile : public FileError {
 public:
  using FileError::FileError;
};

inline constexpr std::size_t kSealBytes = 512;

/// Versions of a layout that are read.
struct SealedVersions {
  std::int64_t oldest, newest;
};

/// The contents of a sealed file in memory. \param name  for messages \param what  "voussoir checkpoint"
/// \throw DamagedFile; FileError if the file is intact but has another version
std::span<const std::byte> unsealed(const std::string& name, const std::string& what, SealedVersions versions,
                                    std::span<const std::byte> bytes);

/// Checks that a file on disk is intact, reading it in pieces. \throw as unsealed()
void check_seal(const std::string& path, const std::string& what, SealedVersions versions);

/// A sealed file being written. HDF5 writes the contents to disk behind the space for the header, under a temporary name, so that they need
/// no memory; seal() completes the file and renames it: complete and on disk, or not at all. Destroyed before seal(), it leaves no file.
class SealedFile {
 public:
  /// \param room  upper bound on the size of the contents in bytes: reserved on disk before anything is written, since HDF5 does not
  /// reliably survive a full disk \throw FileError
  SealedFile(std::string path, std::uint64_t room);
  ~SealedFile();
  SealedFile(const SealedFile&) = delete;
  SealedFile& operator=(const SealedFile&) = delete;

  [[nodiscard]] Hdf5File& contents() noexcept { return contents_; }
  /// Completes the file and gives it its name. \throw FileError
  void seal(const std::string& what, std::int64_t version);

 private:
  std::string path_, temporary_;
  Hdf5File contents_;
  bool sealed_ = false;
};

}  // namespace voussoir::io
