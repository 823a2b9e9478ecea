// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/formats/csv_times.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "cases/names.h"
#include "io/input/files/errors.h"
#include "io/input/motion/formats/motion_text.h"

namespace voussoir::io {
namespace {

constexpr double kTolerance = 1e-6;  // of a step

/// Refuses a file in which a row's step differs from that of most rows: behind a gap, all times are wrong.
void refuse_gap(const std::string& path, const std::vector<CsvRow>& rows) {
  constexpr double kGap = 1e-3;  // of a step
  std::vector<double> steps;
  for (std::size_t i = 1; i < rows.size(); ++i) steps.push_back(rows[i].time - rows[i - 1].time);
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  const auto is_other = [step = *middle](double s) { return std::abs(s - step) > kGap * step; };
  const auto gap = std::ranges::find_if(steps, is_other);
  const auto others = static_cast<std::size_t>(std::ranges::count_if(steps, is_other));
  if (gap == steps.end() || 2 * others >= steps.size() || !(*middle > 0.0)) return;  // as for rounded times
  const CsvRow& row = rows[static_cast<std::size_t>(gap - steps.begin()) + 1];
  throw FileError(path, row.line,
                  "time " + cases::text(row.time) + " s is " + cases::text(*gap) + " s after the row before, and most steps are " +
                      cases::text(*middle) +
                      " s; allowed: equal steps, to a millionth; if times were rounded, write them with more decimals or state dt");
}

bool is_even(const std::vector<CsvRow>& rows, double dt, double span) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (std::abs(rows[i].time - rows[0].time - static_cast<double>(i) * dt) > kTolerance * dt + 1e-14 * span) return false;
  }
  return true;
}

/// Steps that agree with rounded times.
struct Steps {
  double least, most;
  [[nodiscard]] bool any() const { return least <= most; }
  [[nodiscard]] bool hold(double dt) const { return dt >= least && dt <= most; }
  [[nodiscard]] double width() const { return (most - least) / most; }
};

/// Steps for which the time of sample `first + i` is right to half a unit of its last decimal. With `first` 0, times count from the first
/// row.
Steps steps_that_fit(const std::vector<CsvRow>& rows, double first, double start, double half_unit) {
  Steps s{0.0, std::numeric_limits<double>::max()};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double count = first + static_cast<double>(i), time = rows[i].time - start;
    const double slack = half_unit * (1.0 + 1e-6) + 1e-14 * std::abs(rows[i].time);
    if (count == 0.0 && std::abs(time) > slack) return {1.0, 0.0};
    if (count == 0.0) continue;
    s.least = std::max(s.least, (time - std::copysign(slack, count)) / count);
    s.most = std::min(s.most, (time + std::copysign(slack, count)) / count);
  }
  return s;
}

/// Steps of which all times are multiples, whatever the first one; if there are none, steps counted from the first time as written.
std::vector<Steps> all_that_fit(const std::vector<CsvRow>& rows, double mean, double half_unit) {
  constexpr double kMost = 5.0;
  const double around = std::round(rows[0].time / mean);
  const double reach = rows[0].time == 0.0 ? 0.0 : std::min(kMost, std::ceil(half_unit / mean));
  std::vector<Steps> all;
  for (double first = around - reach; first <= around + reach; ++first) {
    const Steps s = steps_that_fit(rows, first, 0.0, half_unit);
    if (s.any() && s.least > 0.0) all.push_back(s);
  }
  if (!all.empty()) return all;
  const Steps s = steps_that_fit(rows, 0.0, rows[0].time, half_unit);
  if (s.any() && s.least > 0.0) all.push_back(s);
  return all;
}

/// The only multiple of `unit` from `least` to `most`, if there is exactly one.
std::optional<double> only_multiple(double least, double most) {
  const double first = std::ceil(least * (1.0 - 1e-9)), last = std::floor(most * (1.0 + 1e-9));
  return first == last && first > 0.0 ? std::optional(first) : std::nullopt;
}

/// A simple step among those that fit: a whole number of samples per second, or of milliseconds.
std::optional<double> plain_step(const Steps& s) {
  constexpr double kWidest = 5e-3;
  if (s.width() > kWidest) return std::nullopt;
  if (const auto rate = only_multiple(1.0 / s.most, 1.0 / s.least)) return 1.0 / *rate;
  if (const auto milliseconds = only_multiple(1e3 * s.least, 1e3 * s.most)) return *milliseconds / 1e3;
  return std::nullopt;
}

/// Whether at least three steps differ from the median one, and no two by more than one unit: fewer are gaps, not due to rounding.
bool steps_vary(const std::vector<CsvRow>& rows, double unit) {
  std::vector<long long> steps;
  for (std::size_t i = 1; i < rows.size(); ++i) steps.push_back(std::llround((rows[i].time - rows[i - 1].time) / unit));
  std::ranges::sort(steps);
  const auto others = std::ranges::count_if(steps, [middle = steps[steps.size() / 2]](auto s) { return s != middle; });
  return others >= 3 && steps.back() - steps.front() <= 1;
}

/// The step of rounded times; nothing if rounding does not explain them, or leaves the step open.
std::optional<double> step_of_rounded(const std::vector<CsvRow>& rows, double mean, std::optional<double> stated) {
  const int decimals = std::ranges::max_element(rows, {}, &CsvRow::decimals)->decimals;
  if (decimals < 1 || decimals > 9) return std::nullopt;
  const double unit = std::pow(10.0, -decimals);
  const std::vector<Steps> fitting = all_that_fit(rows, mean, 0.5 * unit);
  constexpr std::size_t kFewest = 10;  // rows: fewer fit by chance
  std::optional<double> step;
  for (const Steps& s : fitting) {
    if (stated && s.hold(*stated)) return stated;
    const auto plain = rows.size() < kFewest ? std::nullopt : plain_step(s);
    if (plain && step && *plain != *step) return std::nullopt;
    if (plain) step = plain;
  }
  constexpr double kNarrow = 1e-3;
  if (!step && fitting.size() == 1 && fitting[0].width() <= kNarrow && steps_vary(rows, unit))
    step = 0.5 * (fitting[0].least + fitting[0].most);
  return step;
}

[[noreturn]] void refuse_uneven(const std::string& path, const std::vector<CsvRow>& rows, double dt) {
  refuse_gap(path, rows);
  const auto off = [&](const CsvRow& row) {
    const auto i = static_cast<double>(&row - rows.data());
    return std::abs(row.time - rows[0].time - i * dt) > kTolerance * dt;
  };
  const CsvRow& row = *std::ranges::find_if(rows, off);
  throw FileError(path, row.line,
                  "time " + cases::text(row.time) + " s is not a multiple of the mean step, " + cases::text(dt) +
                      " s; allowed: equal steps, to a millionth or to half a unit of the last decimal; if times were rounded so far that "
                      "their step is open, write them with more decimals or state dt");
}

}  // namespace

int decimals_of(std::string_view number) {
  const std::size_t mark = number.find_first_of("eE"), point = number.find('.');
  int exponent = 0;
  if (mark != std::string_view::npos) {
    std::string_view rest = number.substr(mark + 1);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    std::from_chars(rest.data(), rest.data() + rest.size(), exponent);
  }
  const std::size_t end = std::min(mark, number.size());
  const int written = point < end ? static_cast<int>(end - point - 1) : 0;
  return std::clamp(written - std::clamp(exponent, -400, 400), 0, 400);
}

double csv_step(const std::string& path, const std::vector<CsvRow>& rows, std::optional<double> stated, bool must_be_stated) {
  if (rows.size() < 2) throw FileError(path, "holds " + std::to_string(rows.size()) + " rows of numbers; allowed: 2 or more");
  const double span = rows.back().time - rows.front().time, mean = span / static_cast<double>(rows.size() - 1);
  if (!(mean > 0.0) || !std::isfinite(mean)) throw FileError(path, rows.back().line, "time does not grow");
  if (mean < kShortestStep || mean > kLongestStep)
    throw FileError(path, rows.front().line, "times have steps of " + cases::text(mean) + " s; allowed: from 1e-6 to 10 s");
  std::optional<double> dt = mean;
  if (!is_even(rows, mean, span)) dt = step_of_rounded(rows, mean, stated);
  if (!dt) refuse_uneven(path, rows, mean);
  if (must_be_stated && std::abs(*dt - *stated) > kTolerance * *stated) {
    throw FileError(
        path, rows.front().line,
        "times have steps of " + cases::text(*dt) + " s, and the first row says " + cases::text(*stated) + " s; allowed: the same");
  }
  return *dt;
}

}  // namespace voussoir::io
