// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text that other programs wrote, in whatever encoding they did.
namespace voussoir::io {

/// The text in UTF-8, without a byte order mark: from UTF-16, see utf16_of, and from Windows-1252 (Latin-1 is within it) if its bytes are
/// no UTF-8. `path` is for messages. \throw FileError for UTF-16 that ends within a character or holds half of one
std::string as_utf8(const std::string& path, std::string bytes);

/// Whether the bytes are UTF-8 throughout.
bool is_all_utf8(std::string_view text);
enum class Utf16 { no, little_endian, big_endian };
/// Whether the bytes are UTF-16, by its byte order mark. Without one: if the first of them are characters of which at least a quarter, the
/// first among them, are ASCII, so that every second byte may be zero and no other is.
Utf16 utf16_of(std::string_view bytes);
/// The bytes without the byte order mark of UTF-8, if they begin with it.
std::string_view without_utf8_mark(std::string_view bytes);

/// As read_text_file, as_utf8.
std::string read_foreign_text(const std::string& path, std::size_t largest);

}  // namespace voussoir::io
