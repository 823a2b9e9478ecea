// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

/// Plots of the report page.
namespace voussoir::io::page {

using Values = std::vector<double>;  // the page omits values that are not finite

struct Curve {
  std::string name;
  Values y;
};
struct Line {
  std::string name;
  Values x, y;
};
struct Point {
  std::string name;
  double x = 0.0, y = 0.0;
};
/// The horizontal axis, if it is not time.
struct Axis {
  std::string name, unit;
  Values values;
};

struct Plot {
  std::string title, unit;
  Values t;  // s
  std::vector<Curve> curves;
  std::optional<Axis> x{};
  std::vector<Line> lines{};     // straight from point to point; only with `x`
  std::vector<Point> points{};   // with names; only with `x`
  bool stack = false;            // curves are stacked
  std::optional<double> clip{};  // magnitude beyond which no value is shown
};

/// Rows of a curve for the page: all, or, for a long curve, the two rows with the least and the largest value of each stretch, so that no
/// peak is lost. For times, the first and the last of the same stretches.
std::vector<std::size_t> shown_rows(const Values& values);
/// The values of given rows times a factor, to six digits.
Values picked(const Values& values, const std::vector<std::size_t>& rows, double factor = 1);
/// Component `first` of rows of `width` times a factor, reduced to shown_rows, to six digits.
Values thinned(const Values& values, std::size_t first = 0, std::size_t width = 1, double factor = 1);
/// Columns of rows as named curves.
std::vector<Curve> columns(const Values& values, const std::vector<std::string>& names, double factor = 1);
/// All plots as one JSON array.
std::string plots_json(const std::vector<Plot>& plots);

}  // namespace voussoir::io::page
