// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// Files that are whole and on disk under their name, or not there at all.
namespace voussoir::io {

/// The name of a temporary file for `path`, PATH.PROCESS.tmp, where several processes may write `path` at once. Files of such names that
/// have not been written to for an hour are of killed processes, and are removed.
std::string own_temporary(const std::string& path);
/// Makes `temporary` (closed, complete) take the place of `path`: its bytes reach the disk first, so after a crash `path` is the old
/// file or the new one, never a part. \throw FileError; then `temporary` is gone
void replace_file(const std::string& temporary, const std::string& path);
/// Writes these bytes under `path` as replace_file does: whatever happens, `path` is the old file or the whole new one. \throw FileError
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);
/// The same of a text. \throw FileError
void write_text_file(const std::string& path, const std::string& text);

/// Reserves so many bytes of the disk for a file, whose size stays as it is. Does nothing on file systems that cannot reserve.
/// \throw FileError if there are not as many
void claim_room(const std::string& path, std::uint64_t bytes);
/// Frees what is reserved beyond the end of the file. \throw FileError
void give_back_room(const std::string& path);

}  // namespace voussoir::io
