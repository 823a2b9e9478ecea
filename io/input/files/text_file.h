// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Helpers for readers of text files from other programs, possibly damaged.
namespace voussoir::io {

/// The bytes of a regular file, which is noted as an input (output_path.h); memory use is bounded by its size.
/// \throw FileError if it is missing, a folder, not a regular file, larger than `largest` bytes, or unreadable.
std::string read_text_file(const std::string& path, std::size_t largest);

/// Reads a text line by line; LF, CRLF and a single CR end a line, a UTF-8 byte order mark is skipped.
class LineReader {
 public:
  explicit LineReader(std::string_view text);
  /// The next line without its end, or nothing after the last one.
  std::optional<std::string_view> next();
  /// Number of the last returned line, from 1.
  [[nodiscard]] long line() const noexcept { return line_; }
  /// Whether the last returned line is the last of the text and has no line end: the file may have been truncated within it.
  [[nodiscard]] bool ended_within() const noexcept { return rest_.empty() && !line_ended_; }

 private:
  std::string_view rest_;
  long line_ = 0;
  bool line_ended_ = true;
};

/// The text without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// The text with letters a to z in capitals; other bytes are unchanged.
std::string upper(std::string_view text);

/// The number that the whole text represents (a plus sign and "-.5E-02" are allowed), or nothing if it is none or not finite.
std::optional<double> finite_number(std::string_view text);

/// `text` in quotes for a message: at most 40 bytes, unprintable ones as '?'.
std::string shown(std::string_view text);

}  // namespace voussoir::io
