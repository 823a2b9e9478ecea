// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

#include "io/input/files/errors.h"
#include "io/input/files/foreign_text.h"
#include "io/input/files/text_file.h"
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

// The header has four lines in every form of the format: database, event, quantity and unit, number of values and step. The forms differ in
// line 4, which is read here token by token:
//   NPTS=   2676, DT=   .0200 SEC           NGA-West2, also with filter corners after it, cut anywhere
//   NPTS=   5600, dt=  .00500               before NGA
//   4164    0.0100    NPTS, DT              NGA-West1
namespace voussoir::io {
namespace {

constexpr std::size_t kColumn = 15;  // width of a column in all forms of the format
constexpr std::string_view kSeparators = " \t,=";
constexpr const char* kCountForms = "wanted 'NPTS= n, DT= s SEC' or 'n s NPTS, DT'";

struct Header {
  std::string name;
  double unit = 0.0;        // m/s2
  std::uint64_t count = 0;  // stated by the header; not to be used for allocation
  double dt = 0.0;          // s
};

std::string_view next_token(std::string_view& text, std::string_view separators) {
  const std::size_t first = std::min(text.find_first_not_of(separators), text.size());
  const std::size_t end = std::min(text.find_first_of(separators, first), text.size());
  const std::string_view token = text.substr(first, end - first);
  text.remove_prefix(end);
  return token;
}

/// The unit from line 3: "ACCELERATION TIME SERIES IN UNITS OF G", possibly followed by more text.
double unit_of(const std::string& path, std::string_view line) {
  constexpr std::string_view kMark = "UNITS OF";
  const std::string text = upper(line);
  for (const char* other : {"VELOCITY", "DISPLACEMENT"}) {
    if (text.find(other) < text.find("ACCELERATION")) {
      throw FileError(path, 3,
                      "the file holds " + std::string(other == std::string("VELOCITY") ? "velocity" : "displacement") +
                          ", wanted acceleration (the .AT2 file of the same component)");
    }
  }
  const std::size_t mark = text.find(kMark);
  if (mark == std::string::npos) throw FileError(path, 3, shown(line) + ": wanted 'ACCELERATION ... IN UNITS OF G'");
  std::string_view rest = std::string_view(text).substr(mark + kMark.size());
  std::string_view token = next_token(rest, " \t,;");
  if (!token.empty() && token.back() == '.') token.remove_suffix(1);
  const auto unit = acceleration_unit(token);
  if (!unit) throw FileError(path, 3, "unit " + shown(token) + " is not known; allowed: G, M/S2, CM/S2");
  return *unit;
}

/// The token after `key`; empty in the form with numbers first.
std::string_view value_after(std::string_view line, std::string_view key) {
  while (!line.empty()) {
    if (upper(next_token(line, kSeparators)) == key) return next_token(line, kSeparators);
  }
  return {};
}

void read_count_and_step(const std::string& path, std::string_view line, Header& h) {
  std::string_view rest = line;
  std::string_view count = next_token(rest, kSeparators), step = next_token(rest, kSeparators);
  if (upper(count) == "NPTS") {
    count = step;
    step = value_after(line, "DT");
  } else if (upper(next_token(rest, kSeparators)) != "NPTS") {
    throw FileError(path, 4, shown(line) + ": " + kCountForms);
  }
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), h.count);
  if (error != std::errc{} || end != count.data() + count.size() || h.count < 2) {
    throw FileError(path, 4, "NPTS = " + shown(count) + " is no count of values; allowed: an integer, at least 2 (" + kCountForms + ")");
  }
  const auto dt = finite_number(step);
  if (!dt || *dt < kShortestStep || *dt > kLongestStep)
    throw FileError(path, 4, "DT = " + shown(step) + " is no time step; allowed: from 1e-6 to 10 s");
  h.dt = *dt;
}

Header read_header(const std::string& path, LineReader& lines) {
  Header h;
  for (int number = 1; number <= 4; ++number) {
    const auto line = lines.next();
    if (!line) throw FileError(path, number, "the file ends within the header; a PEER file has four lines of it");
    if (number == 2) h.name = trimmed(*line);
    if (number == 3) h.unit = unit_of(path, *line);
    if (number == 4) read_count_and_step(path, *line, h);
  }
  if (h.name.empty()) h.name = std::filesystem::path(path).stem().string();
  return h;
}

}  // namespace

cases::Accelerogram read_at2(const std::string& path) {
  const std::string text = read_foreign_text(path, kLargestMotionFile);
  LineReader lines(text);
  const Header h = read_header(path, lines);
  const std::string stated = "NPTS = " + std::to_string(h.count);
  cases::Accelerogram a{h.name, h.dt, {}};
  std::size_t end_before = 0, end = 0;  // ends of the text in the line before and in this line
  while (const auto line = lines.next()) {
    std::string_view rest = *line;
    if (!trimmed(*line).empty()) end_before = end, end = line->find_last_not_of(" \t\r") + 1;
    for (std::string_view token = next_token(rest, " \t"); !token.empty(); token = next_token(rest, " \t")) {
      const auto value = finite_number(token);
      if (!value || !std::isfinite(*value * h.unit)) {
        throw FileError(path, lines.line(), shown(token) + " is not one finite number (damaged, or two numbers glued together)");
      }
      if (a.acceleration.size() == h.count) throw FileError(path, lines.line(), "more values than " + stated + " of the header");
      a.acceleration.push_back(*value * h.unit);
    }
  }
  // Numbers are in columns, so a truncated number ends before its column does.
  if (lines.ended_within() && end % kColumn != 0 && end_before > 0 && end_before % kColumn == 0) {
    throw FileError(path, lines.line(), "the file ends within its last value, or without the end of a line; wanted: a newline behind it");
  }
  if (a.acceleration.size() != h.count) {
    throw FileError(path, lines.line(),
                    "the file ends after " + std::to_string(a.acceleration.size()) + " values, the header says " + stated);
  }
  return a;
}

}  // namespace voussoir::io
