// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/values/run_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "geometry/message.h"
#include "io/input/files/sealed_file.h"
#include "io/output/replay/values/value_rules.h"

namespace voussoir::io {
namespace {

constexpr double kLatest = 1e8;  // s; a record of the most samples with the longest step between them ends at half of it
constexpr double kUnit = 1e-4;   // of the square of a quaternion's length; the program keeps 1e-6

/// A number, or the number of rows of a dataset; none if the file, of an earlier version, has no such dataset.
std::optional<std::uint64_t> count_of(const Hdf5File& run, std::string_view what) {
  std::uint64_t number = 0;
  if (std::from_chars(what.data(), what.data() + what.size(), number).ec == std::errc()) return number;
  const std::string dataset(what);
  if (!run.exists(dataset)) return std::nullopt;
  const Shape shape = run.shape(dataset);
  if (shape.empty()) throw DamagedFile(run.path(), dataset + " has no rows");
  return shape[0];
}

std::string words_of(const Shape& shape) {
  std::string text;
  for (const std::uint64_t n : shape) text += (text.empty() ? "" : " x ") + std::to_string(n);
  return text.empty() ? "one value" : text;
}

void check_shape(const Hdf5File& run, const std::string& dataset, const ValueRule& rule) {
  const Shape shape = run.shape(dataset);
  bool fits = shape.size() == rule.shape.size();
  std::string wanted;
  for (std::size_t i = 0; fits && i < rule.shape.size(); ++i) {
    const std::optional<std::uint64_t> n = count_of(run, rule.shape[i]);
    fits = !n || shape[i] == *n;
    if (!fits) wanted = ", and not " + std::to_string(*n) + " as " + std::string(rule.shape[i]);
  }
  if (!fits) throw DamagedFile(run.path(), dataset + " is of " + words_of(shape) + wanted + ": it does not fit the rest of the file");
}

void check_counts(const Hdf5File& run) {
  for (const std::string table : {"history", "energy", "forces", "damage", "cracks", "frames", "cuts", "assessment"}) {
    const std::string rows = "rows_" + table;
    if (!run.has_attribute("/", rows)) continue;
    const std::int64_t said = run.attribute_int("/", rows);
    const std::optional<std::uint64_t> there = count_of(run, "/" + table + "/time");
    if (said < 0 || (there && static_cast<std::uint64_t>(said) != *there))
      throw DamagedFile(run.path(), "/" + table + "/time has " + std::to_string(there.value_or(0)) + " rows, and attribute " + rows +
                                        " says " + std::to_string(said));
  }
}

/// Rows of one dataset while they are checked.
class Rows {
 public:
  Rows(const Hdf5File& run, const std::string& dataset, const ValueRule& rule, std::uint64_t first)
      : run_(run), dataset_(dataset), rule_(rule), first_(first) {}

  template <class T>
  void check(const T* values, std::uint64_t rows, std::uint64_t width) {
    using enum Values;
    const std::uint64_t n = rows * width;
    const auto fault = [&](std::uint64_t i, const std::string& allowed) { refuse(i / width, static_cast<double>(values[i]), allowed); };
    if (rule_.values == index || rule_.values == start) {
      const std::optional<std::uint64_t> items = count_of(run_, rule_.items);
      const std::int64_t last = !items ? INT64_MAX : static_cast<std::int64_t>(*items) - (rule_.values == index ? 1 : 0);
      for (std::uint64_t i = 0; i < n; ++i) {
        const bool whole = values[i] >= static_cast<T>(0) || rule_.least < 0;
        const auto number = static_cast<double>(values[i]);
        if (!whole || !(number >= static_cast<double>(rule_.least) && number <= static_cast<double>(last)))
          fault(i, std::to_string(rule_.least) + " to " + std::to_string(last));
        if (rule_.values == start && i > 0 && values[i] < values[i - 1]) fault(i, "no less than in the row before");
      }
      return;
    }
    for (std::uint64_t i = 0; i < n; ++i) {
      const auto number = static_cast<double>(values[i]);
      if (!std::isfinite(number)) fault(i, "a finite number");
      if ((rule_.values == time || rule_.values == late_time) && std::abs(number) > kLatest) fault(i, "-1e8 to 1e8 s");
      if (rule_.values == positive && number <= 0.0) fault(i, "above 0");
      if (rule_.values == time && i > 0 && values[i] <= values[i - 1]) fault(i, "a time after that of the row before");
      if (rule_.values == late_time && i > 0 && values[i] < values[i - 1]) fault(i, "no time before that of the row before");
    }
    if (rule_.values == unit) check_quaternions(values, n, width);
  }

 private:
  template <class T>
  void check_quaternions(const T* values, std::uint64_t n, std::uint64_t width) {
    for (std::uint64_t i = 0; i + 4 <= n; i += 4) {
      double square = 0.0;
      for (std::uint64_t k = i; k < i + 4; ++k) square += static_cast<double>(values[k]) * static_cast<double>(values[k]);
      if (std::abs(square - 1.0) > kUnit) refuse(i / width, std::sqrt(square), "1, the length of a unit quaternion");
    }
  }

  [[noreturn]] void refuse(std::uint64_t row, double value, const std::string& allowed) const {
    throw DamagedFile(run_.path(), dataset_ + ": row " + std::to_string(first_ + row) + " holds " + geometry::printed("%.17g", value) +
                                       "; allowed: " + allowed);
  }

  const Hdf5File& run_;
  const std::string& dataset_;
  const ValueRule& rule_;
  std::uint64_t first_;
};

}  // namespace

void check_shapes(const Hdf5File& run) {
  for (const std::string& dataset : run.datasets())
    if (const ValueRule* rule = rule_of(dataset)) check_shape(run, dataset, *rule);
  check_counts(run);
}

void check_values(const Hdf5File& run, const std::string& dataset, Hdf5Type type, std::uint64_t first, std::uint64_t rows,
                  const void* data) {
  const ValueRule* rule = rule_of(dataset);
  if (rule == nullptr || rule->values == Values::any) return;
  if (rule->values == Values::row && run.has_attribute("/summary", "failure")) return;
  std::uint64_t width = 1;
  const Shape shape = run.shape(dataset);
  for (std::size_t i = 1; i < shape.size(); ++i) width *= shape[i];
  Rows check(run, dataset, *rule, first);
  switch (type) {
    case Hdf5Type::f64:
      return check.check(static_cast<const double*>(data), rows, width);
    case Hdf5Type::f32:
      return check.check(static_cast<const float*>(data), rows, width);
    case Hdf5Type::u8:
      return check.check(static_cast<const std::uint8_t*>(data), rows, width);
    case Hdf5Type::i32:
      return check.check(static_cast<const std::int32_t*>(data), rows, width);
    case Hdf5Type::i64:
      return check.check(static_cast<const std::int64_t*>(data), rows, width);
  }
}

}  // namespace voussoir::io
