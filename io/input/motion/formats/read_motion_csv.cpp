// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cases/names.h"
#include "io/input/files/errors.h"
#include "io/input/files/foreign_text.h"
#include "io/input/files/text_file.h"
#include "io/input/motion/formats/csv_times.h"
#include "io/input/motion/formats/motion_text.h"
#include "io/input/motion/formats/read_motion.h"

namespace voussoir::io {
namespace {

constexpr const char* kWantedColumns = "wanted two columns: time [s], acceleration";

using Fields = std::vector<std::string_view>;

/// Fields separated by commas or semicolons if present, else by blanks. At most three: a third shows that there are too many.
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

/// The unit in a header line, if any. One column has a header without a comma, "a [m/s2]".
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

/// Meaning of the columns, determined by the first row of numbers.
enum class Layout { time_and_value, value };

Layout layout_of(const std::string& path, long line, const Fields& fields, const Unstated& unstated) {
  if (fields.size() != 1) return Layout::time_and_value;
  if (unstated.dt) return Layout::value;
  throw FileError(path, line,
                  std::string("one column, and its step is not stated; ") + kWantedColumns +
                      ", or dt beside it, in s (motion.dt in a case, dt in record.toml, --dt of voussoir motion)");
}

/// A remark for a message: between semicolons, commas are decimal signs.
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

/// A first row with the number of values and their step, as in SHAKE: the next row has one column, or a time before that number.
struct CountRow {
  double count, dt;
  long line;
};

std::optional<CountRow> count_row_of(const Fields& fields, long line) {
  if (fields.size() != 2) return std::nullopt;
  const auto count = finite_number(fields[0]), dt = finite_number(fields[1]);
  const bool good = count && dt && *count >= 2.0 && *count == std::floor(*count) && *dt >= kShortestStep && *dt <= kLongestStep;
  return good ? std::optional(CountRow{*count, *dt, line}) : std::nullopt;
}

bool stands_behind(const CountRow& first, const Fields& next) {
  if (next.size() == 1) return true;
  const auto time = finite_number(next[0]);
  return next.size() == 2 && time && *time < first.count && *time <= 2.0 * first.dt;
}

void check_count(const std::string& path, const CountRow& first, std::size_t rows) {
  if (static_cast<double>(rows) == first.count) return;
  throw FileError(path, first.line,
                  "the first row says " + cases::text(first.count) + " values at steps of " + cases::text(first.dt) + " s, and " +
                      std::to_string(rows) + " rows follow; allowed: as many, or no such row");
}

/// Refuses one column that begins with the number of its remaining rows, which is no acceleration.
void refuse_count(const std::string& path, const std::vector<CsvRow>& rows) {
  if (rows.size() < 3 || rows.front().value != static_cast<double>(rows.size() - 1)) return;
  throw FileError(path, rows.front().line,
                  "the first number, " + cases::text(rows.front().value) +
                      ", is the number of rows behind it, no acceleration; remove it, or write the step beside it");
}

/// Reads the rows of a file, one by one.
class CsvReader {
 public:
  CsvReader(const std::string& path, const Unstated& unstated) : path_(path), unstated_(unstated) {}

  void line(long number, std::string_view content) {
    const Fields fields = fields_of(content);
    if (header_allowed_ && !finite_number(fields[0])) {
      factor_ = unit_of_header(path_, number, content);
    } else if (!maybe_count_ && !layout_ && (maybe_count_ = count_row_of(fields, number))) {
      first_ = std::string(content);
    } else {
      if (maybe_count_ && !layout_) choose(fields);
      row(number, fields);
    }
    header_allowed_ = false;
  }

  cases::Accelerogram finished() {
    if (maybe_count_ && !layout_) row(maybe_count_->line, fields_of(first_));
    if (count_) check_count(path_, *count_, rows_.size());
    const double dt = step();
    if (!factor_ && unstated_.unit) factor_ = acceleration_unit(*unstated_.unit);
    if (!factor_) {
      throw FileError(path_, std::string("the unit of acceleration is not stated; give the file a header line '") +
                                 (layout_ == Layout::value ? "a [m/s2]" : "t [s], a [m/s2]") + "', or set unit to " +
                                 std::string(kUnitNames));
    }
    cases::Accelerogram a{std::filesystem::path(path_).stem().string(), dt, {}};
    a.acceleration.reserve(rows_.size());
    for (const CsvRow& row : rows_) {
      a.acceleration.push_back(row.value * *factor_);
      if (!std::isfinite(a.acceleration.back())) throw FileError(path_, row.line, "acceleration is too large for a number in m/s2");
    }
    return a;
  }

 private:
  /// Decides by the second row whether the first has count and step.
  void choose(const Fields& second) {
    if (stands_behind(*maybe_count_, second)) {
      count_ = maybe_count_;
      if (second.size() == 1) layout_ = Layout::value;
    } else {
      row(maybe_count_->line, fields_of(first_));
    }
  }

  void row(long number, const Fields& fields) {
    if (!layout_) layout_ = layout_of(path_, number, fields, unstated_);
    if (*layout_ == Layout::value) {
      rows_.push_back({0.0, value_of(path_, number, fields), number, 0});
    } else {
      const auto [time, value] = numbers_of(path_, number, fields);
      rows_.push_back({time, value, number, decimals_of(fields[0])});
    }
  }

  double step() const {
    if (layout_ != Layout::value) return csv_step(path_, rows_, count_ ? std::optional(count_->dt) : unstated_.dt, count_.has_value());
    if (rows_.size() < 2) throw FileError(path_, "holds one number; allowed: 2 or more");
    if (count_) return count_->dt;
    refuse_count(path_, rows_);
    return *unstated_.dt;
  }

  const std::string& path_;
  const Unstated& unstated_;
  std::optional<double> factor_;
  std::optional<Layout> layout_;
  std::optional<CountRow> maybe_count_, count_;
  std::string first_;  // the row of maybe_count_
  std::vector<CsvRow> rows_;
  bool header_allowed_ = true;
};

}  // namespace

cases::Accelerogram read_motion_csv(const std::string& path, const Unstated& unstated) {
  const std::string text = read_foreign_text(path, kLargestMotionFile);
  LineReader lines(text);
  CsvReader reader(path, unstated);
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (!content.empty() && content.front() != '#') reader.line(lines.line(), content);
  }
  return reader.finished();
}

}  // namespace voussoir::io
