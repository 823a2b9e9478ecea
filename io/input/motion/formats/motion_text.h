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

/// What the readers of ground motion share: a file walked line by line, words of headers, numbers in Fortran's columns.
namespace voussoir::io {

/// A line of a file, for messages.
struct Place {
  std::string path;
  long line = 0;
  /// \throw FileError, always.
  [[noreturn]] void fail(const std::string& what) const;
};

/// A file of ground motion. Every fault names the file, and the line last given.
class MotionText {
 public:
  /// \throw FileError as read_foreign_text.
  explicit MotionText(const std::string& path);
  MotionText(const MotionText&) = delete;
  MotionText& operator=(const MotionText&) = delete;

  /// The next line, or nothing after the last one.
  std::optional<std::string_view> next() { return lines_.next(); }
  /// The next line that is not blank.
  std::optional<std::string_view> next_filled();
  /// The next line. \throw FileError "the file ends before ..."
  std::string_view need(const std::string& what);
  /// Passes over `count` lines that must be there.
  void skip(std::uint64_t count, const std::string& what);
  /// Whether the file ends with the line last given, and that without a newline.
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

/// The number that follows `key` (in any case), blanks, '=' or ':'; nothing if there is none.
std::optional<double> number_after(std::string_view line, std::string_view key);

/// Does the text hold (begin with) the word, in any case? The word in capitals.
bool holds(std::string_view text, std::string_view word);
bool begins(std::string_view text, std::string_view word);

/// "m/s2" of a column "a [m/s2]" or "a (m/s2)"; empty without brackets.
std::string_view bracketed(std::string_view column);

/// A number of values stated by a header; not to be trusted with memory. \throw FileError unless it is a whole number from 2 to 10^15.
std::uint64_t stated_count(const Place& at, const std::string& key, std::optional<double> value);
/// A step, s. \throw FileError unless it is from 1e-6 to 10.
inline constexpr double kShortestStep = 1e-6, kLongestStep = 10.0;  // s, of samples
double stated_step(const Place& at, const std::string& key, std::optional<double> value);
/// The unit of acceleration in m/s2. \throw FileError if the name is not known or empty.
double stated_unit(const Place& at, std::string_view name);

/// Fortran's "(8F10.5)": numbers on a line, columns of each.
struct Columns {
  int per_line = 1, width = 1;
};
/// Of the first such format in the text (F, E, G, D or I), up to 1,000 columns; nothing if there is none.
std::optional<Columns> columns_in(std::string_view text);

/// `count` numbers times `factor`, read by their columns, so that glued ones part; every line but the last is full.
/// \throw FileError for a number that is missing, damaged or not finite, and for lines that hold too much or are missing.
std::vector<double> read_columns(MotionText& text, std::uint64_t count, Columns columns, double factor = 1.0);
/// Passes over as many lines.
void skip_columns(MotionText& text, std::uint64_t count, Columns columns, const std::string& what);

/// A header of keys and values.
class HeaderFields {
 public:
  struct Field {
    std::string value;
    Place at;
    /// The number at the value's beginning, if there is one.
    [[nodiscard]] std::optional<double> number() const { return number_after(value, ""); }
  };
  void add(std::string_view key, std::string_view value, const Place& at);
  /// Empty if the key is absent.
  [[nodiscard]] std::string value(const std::string& key) const;
  /// \throw FileError at the place if the key is absent.
  [[nodiscard]] const Field& need(const Place& end_of_header, const std::string& key) const;

 private:
  std::map<std::string, Field> fields_;
};

}  // namespace voussoir::io
