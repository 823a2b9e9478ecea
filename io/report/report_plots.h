// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

/// Diagrams of the report page, as JSON.
namespace voussoir::io::page {

using Json = nlohmann::ordered_json;

inline constexpr std::size_t kPlotPoints = 20000;  // of a curve at most: the rows of a hundred seconds; the page shows their peaks

/// Every so many rows are shown of `rows`.
inline std::size_t stride_of(std::size_t rows) { return std::max<std::size_t>(1, (rows + kPlotPoints - 1) / kPlotPoints); }

/// Component `first` of rows of `width` times a factor, thinned, to six digits.
inline Json thinned(const std::vector<double>& values, std::size_t first = 0, std::size_t width = 1, double factor = 1) {
  Json out = Json::array();
  const std::size_t rows = values.size() / width, stride = stride_of(rows);
  for (std::size_t i = 0; i < rows; i += stride) {
    const double v = factor * values[first + i * width];
    const double digit = v == 0 || !std::isfinite(v) ? 1 : std::pow(10.0, std::floor(std::log10(std::abs(v))) - 5);
    out.push_back(std::round(v / digit) * digit);  // JSON has no NaN: it becomes null
  }
  return out;
}

inline Json curve(const std::string& name, Json values) { return {{"name", name}, {"y", std::move(values)}}; }

/// One diagram: what stands on it, and its curves over one time.
inline Json plot(const std::string& title, const std::string& unit, Json time, Json curves) {
  return {{"title", title}, {"unit", unit}, {"t", std::move(time)}, {"curves", std::move(curves)}};
}

/// Rows with a column a name, as curves.
inline Json columns(const std::vector<double>& values, const std::vector<std::string>& names, double factor = 1) {
  Json curves = Json::array();
  for (std::size_t k = 0; k < names.size(); ++k) curves.push_back(curve(names[k], thinned(values, k, names.size(), factor)));
  return curves;
}

}  // namespace voussoir::io::page
