// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/formats/motion_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "cases/names.h"
#include "io/input/files/errors.h"
#include "io/input/files/foreign_text.h"
#include "io/input/motion/formats/read_motion.h"

namespace voussoir::io {

void Place::fail(const std::string& what) const { throw FileError(path, line, what); }

namespace {

/// The text without trailing Ctrl-Z characters, with which DOS ended a text and filled its last block; files of the 1980s still have them.
std::string_view without_dos_end(std::string_view text) { return text.substr(0, text.find_last_not_of('\x1A') + 1); }

}  // namespace

MotionText::MotionText(const std::string& path)
    : path_(path), text_(read_foreign_text(path, kLargestMotionFile)), lines_(without_dos_end(text_)) {}

std::optional<std::string_view> MotionText::next_filled() {
  auto line = next();
  while (line && trimmed(*line).empty()) line = next();
  return line;
}

std::string_view MotionText::need(const std::string& what) {
  const auto line = next();
  if (!line) fail("the file ends before " + what);
  return *line;
}

void MotionText::skip(std::uint64_t count, const std::string& what) {
  for (std::uint64_t i = 0; i < count; ++i) need(what);
}

void MotionText::expect_end(const std::string& what) {
  if (const auto line = next_filled()) fail(shown(*line) + " after " + what);
}

std::optional<double> number_after(std::string_view line, std::string_view key) {
  const std::size_t found = upper(line).find(upper(key));
  if (found == std::string::npos) return std::nullopt;
  std::string_view rest = line.substr(found + key.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t=:"), rest.size()));
  return finite_number(rest.substr(0, rest.find_first_of(" \t,;")));
}

bool holds(std::string_view text, std::string_view word) { return upper(text).find(word) != std::string::npos; }

bool begins(std::string_view text, std::string_view word) { return upper(text.substr(0, word.size())) == word; }

std::string_view bracketed(std::string_view column) {
  const std::size_t open = column.find_first_of("[("), close = column.find_first_of("])");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
  return trimmed(column.substr(open + 1, close - open - 1));
}

std::uint64_t stated_count(const Place& at, const std::string& key, std::optional<double> value) {
  constexpr double kMost = 1e15;
  if (!value || *value < 2.0 || *value > kMost || *value != std::floor(*value)) {
    at.fail(key + (value ? " is " + cases::text(*value) : " is missing or no number") + "; allowed: a whole number of values, at least 2");
  }
  return static_cast<std::uint64_t>(*value);
}

double stated_step(const Place& at, const std::string& key, std::optional<double> value) {
  if (!value || *value < kShortestStep || *value > kLongestStep) {
    at.fail(key + (value ? " is " + cases::text(*value) : " is missing or no number") + "; allowed: from 1e-6 to 10 s");
  }
  return *value;
}

double stated_unit(const Place& at, std::string_view name) {
  const auto unit = acceleration_unit(name);
  if (!unit) at.fail("unit of acceleration " + shown(trimmed(name)) + " is not known; allowed: g, m/s2, cm/s2 (gal), mm/s2");
  return *unit;
}

std::optional<Columns> columns_in(std::string_view text) {
  constexpr int kWidest = 1000;
  for (std::size_t open = text.find('('); open != std::string_view::npos; open = text.find('(', open + 1)) {
    const char* const end = text.data() + text.size();
    Columns c;
    const auto [letter, bad_number] = std::from_chars(text.data() + open + 1, end, c.per_line);
    if (bad_number != std::errc{} || letter == end || std::string_view("FEGDIfegdi").find(*letter) == std::string_view::npos) continue;
    const auto [after, bad_width] = std::from_chars(letter + 1, end, c.width);
    if (bad_width != std::errc{} || c.per_line < 1 || c.width < 1 || c.per_line > kWidest || c.width > kWidest) continue;
    return c;
  }
  return std::nullopt;
}

namespace {

/// Reads the numbers of one line, `wanted` of them.
void read_line(const MotionText& text, std::string_view line, std::uint64_t wanted, std::size_t width, double factor,
               std::vector<double>& out) {
  line = line.substr(0, line.find_last_not_of(" \t") + 1);
  if (line.size() > wanted * width) text.fail("more than the " + std::to_string(wanted) + " values wanted on this line");
  for (std::uint64_t i = 0; i < wanted; ++i) {
    const std::size_t first = std::min(static_cast<std::size_t>(i) * width, line.size());
    const std::string_view slice = trimmed(line.substr(first, width));
    if (slice.empty()) {
      text.fail("value " + std::to_string(i + 1) + " of " + std::to_string(wanted) + " is missing; wanted in columns " +
                std::to_string(i * width + 1) + " to " + std::to_string((i + 1) * width));
    }
    const double value = finite_number(slice).value_or(std::numeric_limits<double>::quiet_NaN()) * factor;
    if (!std::isfinite(value)) text.fail(shown(slice) + " is not one finite number");
    out.push_back(value);
  }
}

}  // namespace

std::vector<double> read_columns(MotionText& text, std::uint64_t count, Columns columns, double factor) {
  const auto width = static_cast<std::size_t>(columns.width);
  std::vector<double> values;
  while (values.size() < count) {
    const auto line = text.next();
    if (!line) text.fail("the file ends after " + std::to_string(values.size()) + " values, the header says " + std::to_string(count));
    const std::uint64_t wanted = std::min<std::uint64_t>(count - values.size(), static_cast<std::uint64_t>(columns.per_line));
    read_line(text, *line, wanted, width, factor, values);
    if (text.ends_within_line() && line->size() < wanted * width)
      text.fail("the file ends within its last value, or without the end of a line; wanted: a newline behind it");
  }
  return values;
}

void skip_columns(MotionText& text, std::uint64_t count, Columns columns, const std::string& what) {
  const auto per_line = static_cast<std::uint64_t>(columns.per_line);
  text.skip((count + per_line - 1) / per_line, what);
}

void HeaderFields::add(std::string_view key, std::string_view value, const Place& at) {
  fields_[std::string(trimmed(key))] = {std::string(trimmed(value)), at};
}

std::string HeaderFields::value(const std::string& key) const {
  const auto found = fields_.find(key);
  return found == fields_.end() ? std::string() : found->second.value;
}

const HeaderFields::Field& HeaderFields::need(const Place& end_of_header, const std::string& key) const {
  const auto found = fields_.find(key);
  if (found == fields_.end()) end_of_header.fail("the header does not state '" + key + "'");
  return found->second;
}

}  // namespace voussoir::io
