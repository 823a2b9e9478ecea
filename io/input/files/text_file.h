// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Small helpers of the readers of text files that others wrote, possibly damaged.
namespace voussoir::io {

/// The bytes of a regular file, memory bounded by its size.
/// \throw FileError if it is missing, a folder, no regular file, larger than `largest` bytes or cannot be read.
std::string read_text_file(const std::string& path, std::size_t largest);

/// \throw FileError if the file exists and `overwrite` does not allow to replace it, or if it cannot be written.
void write_text_file(const std::string& path, std::string_view text, bool overwrite);

/// Walks through a text line by line; LF, CRLF and a CR alone end a line, a UTF-8 byte order mark is skipped.
class LineReader {
 public:
  explicit LineReader(std::string_view text);
  /// The next line without its end, or nothing after the last one.
  std::optional<std::string_view> next();
  /// Number of the line last given, from 1.
  [[nodiscard]] long line() const noexcept { return line_; }
  /// Whether the line last given is the last one and has no end: the file may have been cut within it.
  [[nodiscard]] bool ended_within() const noexcept { return rest_.empty() && !line_ended_; }

 private:
  std::string_view rest_;
  long line_ = 0;
  bool line_ended_ = true;
};

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Letters A to Z for a to z; other bytes stay.
std::string upper(std::string_view text);

/// The number that the whole of `text` is (a plus sign and "-.5E-02" are fine), or nothing if it is none or not finite.
std::optional<double> finite_number(std::string_view text);

/// `text` in quotes for a message: at most 40 bytes of it, unprintable ones as '?'.
std::string shown(std::string_view text);

}  // namespace voussoir::io
