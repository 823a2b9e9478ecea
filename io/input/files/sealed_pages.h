// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/input/files/sealed_file.h"

/// An HDF5 file whose bytes are checked page by page, as they are read: results, which may be large and of which readers need a part.
///
///   512 bytes  text: size of the HDF5 contents, CRC-32 of the list of digests
///   contents   HDF5, in pages of 4096 bytes, the last one shorter
///   digests    CRC-32 of each page, 4 bytes each, little-endian
///
/// HDF5 gets only bytes of pages that agree with their digests. So everything in the file is sealed: values, texts, names, types, shapes
/// and HDF5's own structure, which could otherwise make it crash or loop. HDF5's tools read the file as it is.
namespace voussoir::io {

/// Start of the header.
inline constexpr const char* kSealedCheckpoint = "voussoir checkpoint ";  // then the version; written by SealedFile
inline constexpr const char* kSealedHdf5 = "voussoir sealed HDF5 1\n";

/// Adds header and digests to a complete HDF5 file that was created with a head of kSealBytes. \return its seal, the CRC-32 of its digests
/// \throw FileError
std::uint32_t seal_pages(const std::string& path);

/// A seal as text: eight hexadecimal digits.
std::string seal_text(std::uint32_t seal);

/// A file for reading: sealed, or HDF5 from its first byte (written by an earlier version), which is read unchecked.
class PagedFile {
 public:
  /// \throw FileError if the file is neither, or no regular file; DamagedFile if header or digests are damaged
  explicit PagedFile(const std::string& path);
  PagedFile(const PagedFile&) = delete;
  PagedFile& operator=(const PagedFile&) = delete;
  ~PagedFile();

  [[nodiscard]] bool sealed() const noexcept { return sealed_; }
  /// Number of bytes up to the end of the HDF5 contents, header included.
  [[nodiscard]] std::uint64_t end() const noexcept { return end_; }
  /// CRC-32 of the list of digests; 0 if not sealed.
  [[nodiscard]] std::uint32_t seal() const noexcept { return seal_; }
  /// Reads bytes [at, at + bytes). \throw DamagedFile if a page of them is not what was written
  void read(std::uint64_t at, std::size_t bytes, char* to);
  /// Checks all pages. \throw DamagedFile
  void check_all();

 private:
  void read_raw(std::uint64_t at, std::size_t bytes, char* to) const;
  void read_head(std::uint64_t size);
  void check_pages(std::uint64_t first, std::uint64_t count, const char* bytes);

  std::string path_;
  int id_;
  bool sealed_ = false;
  std::uint64_t end_ = 0;
  std::uint32_t seal_ = 0;
  std::vector<std::uint32_t> digests_;
  std::vector<bool> checked_;  // pages known to be right
};

}  // namespace voussoir::io
