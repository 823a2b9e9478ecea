// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// Files that are complete and on disk under their name, or do not exist.
namespace voussoir::io {

/// The name of a temporary file for `path`, PATH.PROCESS.tmp, for use where several processes may write `path` at once. Removes files with
/// such names that have not been written to for an hour, as their processes were killed.
std::string own_temporary(const std::string& path);
/// Replaces `path` by `temporary` (closed, complete): its bytes reach the disk first, so after a crash `path` is the old file or the new
/// one, never a part. \throw FileError after removing `temporary`
void replace_file(const std::string& temporary, const std::string& path);
/// Writes bytes to `path` by replace_file: in any event `path` is the old file or the complete new one. \throw FileError
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);
/// Writes a text to `path` by replace_file. \throw FileError
void write_text_file(const std::string& path, const std::string& text);

/// Reserves `bytes` of disk space for a file without changing its size. Has no effect on file systems without reservation.
/// \throw FileError if the disk has not enough space
void claim_room(const std::string& path, std::uint64_t bytes);
/// Frees disk space reserved beyond the end of the file. \throw FileError
void give_back_room(const std::string& path);

}  // namespace voussoir::io
