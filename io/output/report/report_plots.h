// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

/// Diagrams of the report page.
namespace voussoir::io::page {

using Values = std::vector<double>;  // the page leaves out what is not finite

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
/// What stands below, in place of the time.
struct Axis {
  std::string name, unit;
  Values values;
};

struct Plot {
  std::string title, unit;
  Values t;  // s
  std::vector<Curve> curves;
  std::optional<Axis> x{};
  std::vector<Line> lines{};     // straight from point to point; with `x` alone
  std::vector<Point> points{};   // by name; with `x` alone
  bool stack = false;            // curves stand on one another
  std::optional<double> clip{};  // no value beyond it is shown
};

/// Rows of a curve that a page shows: all, or of each stretch of a long one the two with its least and its largest value, so that no peak
/// is lost. Of times these are the first and the last of the same stretches.
std::vector<std::size_t> shown_rows(const Values& values);
/// These rows times a factor, to six digits.
Values picked(const Values& values, const std::vector<std::size_t>& rows, double factor = 1);
/// Component `first` of rows of `width` times a factor, thinned to what a page shows (shown_rows), to six digits.
Values thinned(const Values& values, std::size_t first = 0, std::size_t width = 1, double factor = 1);
/// Rows with a column a name, as curves.
std::vector<Curve> columns(const Values& values, const std::vector<std::string>& names, double factor = 1);
/// All of them as one JSON array.
std::string plots_json(const std::vector<Plot>& plots);

}  // namespace voussoir::io::page
