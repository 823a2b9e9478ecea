// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/input/files/text_file.h"

/// Shared by the readers of ground motion: reading line by line, words of headers, numbers in Fortran columns.
namespace voussoir::io {

/// A line of a file, for messages.
struct Place {
  std::string path;
  long line = 0;
  /// Always throws. \throw FileError
  [[noreturn]] void fail(const std::string& what) const;
};

/// A file of ground motion, read line by line. Every fault names the file and the last returned line.
class MotionText {
 public:
  /// \throw FileError as read_foreign_text.
  explicit MotionText(const std::string& path);
  MotionText(const MotionText&) = delete;
  MotionText& operator=(const MotionText&) = delete;

  /// The next line, or nothing after the last one.
  std::optional<std::string_view> next() { return lines_.next(); }
  /// The next line that is not blank, or nothing.
  std::optional<std::string_view> next_filled();
  /// The next line. \throw FileError "the file ends before ..."
  std::string_view need(const std::string& what);
  /// Skips `count` lines. \throw FileError if the file ends before
  void skip(std::uint64_t count, const std::string& what);
  /// Whether the file ends with the last returned line, without a line end.
  [[nodiscard]] bool ends_within_line() const noexcept { return lines_.ended_within(); }
  /// \throw FileError if anything but blank lines follows.
  void expect_end(const std::string& what);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] Place here() const { return {path_, lines_.line()}; }
  [[noreturn]] void fail(const std::string& what) const { here().fail(what); }

 private:
  std::string path_, text_;
  LineReader lines_;
};

/// The number after `key` (in any case) and blanks, '=' or ':'; nothing if there is none.
std::optional<double> number_after(std::string_view line, std::string_view key);

/// Whether the text contains (begins with) the word, ignoring case. \pre the word is in capitals
bool holds(std::string_view text, std::string_view word);
bool begins(std::string_view text, std::string_view word);

/// "m/s2" from a column title "a [m/s2]" or "a (m/s2)"; empty without brackets.
std::string_view bracketed(std::string_view column);

/// A number of values stated by a header; not to be used for allocation. \throw FileError unless it is a whole number from 2 to 10^15.
std::uint64_t stated_count(const Place& at, const std::string& key, std::optional<double> value);
/// A step, s. \throw FileError unless it is from 1e-6 to 10.
inline constexpr double kShortestStep = 1e-6, kLongestStep = 10.0;  // s, of samples
double stated_step(const Place& at, const std::string& key, std::optional<double> value);
/// The unit of acceleration in m/s2. \throw FileError if the name is not known or empty.
double stated_unit(const Place& at, std::string_view name);

/// Column layout of Fortran's "(8F10.5)": numbers per line, characters per number.
struct Columns {
  int per_line = 1, width = 1;
};
/// The first Fortran format in the text (F, E, G, D or I), up to 1,000 columns; nothing if there is none.
std::optional<Columns> columns_in(std::string_view text);

/// Reads `count` numbers times `factor` by their columns, so that numbers without blanks between are separated; every line but the last is
/// full.
/// \throw FileError for a number that is missing, damaged or not finite, and for missing or overlong lines.
std::vector<double> read_columns(MotionText& text, std::uint64_t count, Columns columns, double factor = 1.0);
/// Skips the lines of `count` numbers. \throw FileError if the file ends before
void skip_columns(MotionText& text, std::uint64_t count, Columns columns, const std::string& what);

/// A header of keys and values.
class HeaderFields {
 public:
  struct Field {
    std::string value;
    Place at;
    /// The number at the beginning of the value, if there is one.
    [[nodiscard]] std::optional<double> number() const { return number_after(value, ""); }
  };
  void add(std::string_view key, std::string_view value, const Place& at);
  /// The value of a key; empty if the key is absent.
  [[nodiscard]] std::string value(const std::string& key) const;
  /// The field of a key. \throw FileError at `end_of_header` if the key is absent.
  [[nodiscard]] const Field& need(const Place& end_of_header, const std::string& key) const;

 private:
  std::map<std::string, Field> fields_;
};

}  // namespace voussoir::io
