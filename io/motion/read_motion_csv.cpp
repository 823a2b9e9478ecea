// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cases/names.h"
#include "io/files/errors.h"
#include "io/files/text_file.h"
#include "io/motion/motion_text.h"
#include "io/motion/read_motion.h"

namespace voussoir::io {
namespace {

constexpr const char* kWantedColumns = "wanted two columns: time [s], acceleration";

using Fields = std::vector<std::string_view>;

/// Divided by commas or semicolons if there is one, else by blanks. Never more than three: the third only shows that there are too many.
Fields fields_of(std::string_view line) {
  const std::size_t mark = line.find_first_of(",;");
  const std::string_view divider = mark == std::string_view::npos ? std::string_view(" \t") : line.substr(mark, 1);
  Fields fields;
  line = trimmed(line);
  while (fields.size() < 3) {
    const std::size_t end = line.find_first_of(divider);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
    if (divider.size() > 1) line = trimmed(line);
  }
  return fields;
}

/// The header line: the unit it states, if any. One column has a header without a comma, "a [m/s2]".
std::optional<double> unit_of_header(const std::string& path, long line, std::string_view text) {
  const std::size_t mark = text.find_first_of(",;");
  const bool one = mark == std::string_view::npos && !bracketed(text).empty();
  if (!one && (mark == std::string_view::npos || text.find_first_of(",;", mark + 1) != std::string_view::npos)) {
    throw FileError(path, line, "header " + shown(text) + ": " + kWantedColumns + ", as in 't [s], a [m/s2]'");
  }
  const std::string_view time = one ? std::string_view() : bracketed(text.substr(0, mark));
  const std::string_view acceleration = bracketed(one ? text : text.substr(mark + 1));
  if (!time.empty() && time != "s") throw FileError(path, line, "unit of time is " + shown(time) + "; allowed: s");
  if (acceleration.empty()) return std::nullopt;
  const auto unit = acceleration_unit(acceleration);
  if (!unit) throw FileError(path, line, "unit of acceleration is " + shown(acceleration) + "; allowed: g, m/s2, cm/s2");
  return unit;
}

struct Row {
  double time, value;
  long line;
};

/// What the columns are, told by the first row of numbers.
enum class Layout { time_and_value, value };

Layout layout_of(const std::string& path, long line, const Fields& fields, const Unstated& unstated) {
  if (fields.size() != 1) return Layout::time_and_value;
  if (unstated.dt) return Layout::value;
  throw FileError(path, line,
                  std::string("one column, and its step is not stated; ") + kWantedColumns +
                      ", or dt beside it, in s (motion.dt in a case, dt in record.toml, --dt of voussoir motion)");
}

/// Commas part columns; between semicolons they are decimal ones.
std::string hint(const Fields& fields) {
  const bool both = std::ranges::any_of(fields, [](const auto& f) { return f.find(';') != f.npos; });
  return both ? "; decimals need a point, not a comma" : "";
}

std::array<double, 2> numbers_of(const std::string& path, long line, const Fields& fields) {
  if (fields.size() != 2) {
    throw FileError(path, line,
                    (fields.size() < 2 ? "one column" : "more than two columns") + std::string("; ") + kWantedColumns + hint(fields));
  }
  std::array<double, 2> numbers{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto number = finite_number(fields[i]);
    if (!number) {
      throw FileError(path, line,
                      std::string(i == 0 ? "time " : "acceleration ") + shown(fields[i]) + " is no finite number" + hint(fields));
    }
    numbers[i] = *number;
  }
  return numbers;
}

double value_of(const std::string& path, long line, const Fields& fields) {
  if (fields.size() != 1) throw FileError(path, line, "more than one column, and the rows before have one");
  const auto number = finite_number(fields[0]);
  if (!number) throw FileError(path, line, "acceleration " + shown(fields[0]) + " is no finite number");
  return *number;
}

/// The first row whose step is not that of most rows is told: behind a gap, all times are off.
void refuse_gap(const std::string& path, const std::vector<Row>& rows) {
  constexpr double kGap = 1e-3;  // of a step
  std::vector<double> steps;
  for (std::size_t i = 1; i < rows.size(); ++i) steps.push_back(rows[i].time - rows[i - 1].time);
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  const auto is_other = [step = *middle](double s) { return std::abs(s - step) > kGap * step; };
  const auto gap = std::ranges::find_if(steps, is_other);
  const auto others = static_cast<std::size_t>(std::ranges::count_if(steps, is_other));
  if (gap == steps.end() || 2 * others >= steps.size() || !(*middle > 0.0)) return;  // as of times that are rounded
  const Row& row = rows[static_cast<std::size_t>(gap - steps.begin()) + 1];
  throw FileError(path, row.line,
                  "time " + cases::text(row.time) + " s is " + cases::text(*gap) + " s after the row before, and most steps are " +
                      cases::text(*middle) + " s; allowed: equal steps, to a millionth");
}

/// The step of the rows, checked to be the same everywhere.
double step_of(const std::string& path, const std::vector<Row>& rows) {
  constexpr double kTolerance = 1e-6;  // of a step
  if (rows.size() < 2) throw FileError(path, "holds " + std::to_string(rows.size()) + " rows of numbers; allowed: 2 or more");
  const double span = rows.back().time - rows.front().time, dt = span / static_cast<double>(rows.size() - 1);
  if (!(dt > 0.0) || !std::isfinite(dt)) throw FileError(path, rows.back().line, "time does not grow");
  if (dt < kShortestStep || dt > kLongestStep)
    throw FileError(path, rows.front().line, "times have steps of " + cases::text(dt) + " s; allowed: from 1e-6 to 10 s");
  if (std::abs(rows.front().time) > kTolerance * dt) {
    throw FileError(path, rows.front().line, "the first time is " + cases::text(rows.front().time) + " s; allowed: 0");
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (std::abs(rows[i].time - static_cast<double>(i) * dt) > kTolerance * dt + 1e-14 * span) {
      refuse_gap(path, rows);
      throw FileError(path, rows[i].line,
                      "time " + cases::text(rows[i].time) + " s is not a multiple of the mean step, " + cases::text(dt) +
                          " s; allowed: equal steps, to a millionth");
    }
  }
  return dt;
}

}  // namespace

cases::Accelerogram read_motion_csv(const std::string& path, const Unstated& unstated) {
  const std::string text = read_text_file(path, kLargestMotionFile);
  LineReader lines(text);
  std::optional<double> factor;
  std::optional<Layout> layout;
  std::vector<Row> rows;
  bool header_allowed = true;
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (content.empty() || content.front() == '#') continue;
    const Fields fields = fields_of(content);
    if (header_allowed && !finite_number(fields[0])) {
      factor = unit_of_header(path, lines.line(), content);
    } else {
      if (!layout) layout = layout_of(path, lines.line(), fields, unstated);
      if (*layout == Layout::value) {
        rows.push_back({0.0, value_of(path, lines.line(), fields), lines.line()});
      } else {
        const auto [time, value] = numbers_of(path, lines.line(), fields);
        rows.push_back({time, value, lines.line()});
      }
    }
    header_allowed = false;
  }
  const bool stated = layout != Layout::value;
  if (!stated && rows.size() < 2) throw FileError(path, "holds one number; allowed: 2 or more");
  const double dt = stated ? step_of(path, rows) : *unstated.dt;
  if (!factor && unstated.unit) factor = acceleration_unit(*unstated.unit);
  if (!factor) {
    throw FileError(path, std::string("the unit of acceleration is not stated; give the file a header line '") +
                              (stated ? "t [s], a [m/s2]" : "a [m/s2]") + "', or set unit to " + std::string(kUnitNames));
  }
  cases::Accelerogram a{std::filesystem::path(path).stem().string(), dt, {}};
  a.acceleration.reserve(rows.size());
  for (const Row& row : rows) {
    a.acceleration.push_back(row.value * *factor);
    if (!std::isfinite(a.acceleration.back())) throw FileError(path, row.line, "acceleration is too large for a number in m/s2");
  }
  return a;
}

}  // namespace voussoir::io
