// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text written by other programs, in an unknown encoding.
namespace voussoir::io {

/// Converts text to UTF-8 without a byte order mark: from UTF-16 (see utf16_of), and, if the bytes are not valid UTF-8, from Windows-1252
/// (which includes Latin-1). `path` is for messages. \throw FileError for UTF-16 that ends within a character or contains an unpaired
/// surrogate
std::string as_utf8(const std::string& path, std::string bytes);

/// Whether all bytes are valid UTF-8.
bool is_all_utf8(std::string_view text);
enum class Utf16 { no, little_endian, big_endian };
/// Whether the bytes are UTF-16, by the byte order mark. Without a mark: if the first character and at least a quarter of the leading
/// characters are ASCII, so that zeros are found in every second byte and in no other.
Utf16 utf16_of(std::string_view bytes);
/// The bytes without a leading UTF-8 byte order mark.
std::string_view without_utf8_mark(std::string_view bytes);

/// Reads a file by read_text_file and converts it by as_utf8. \throw FileError as these
std::string read_foreign_text(const std::string& path, std::size_t largest);

}  // namespace voussoir::io
