// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace voussoir::io::page {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPlotPoints = 20000;  // greatest number in a curve: twenty seconds at the default history_interval

/// A plot as JSON; NaN becomes null in the output.
Json json_of(const Plot& p) {
  Json out{{"title", p.title}, {"unit", p.unit}, {"t", p.t}, {"curves", Json::array()}};
  for (const Curve& c : p.curves) out["curves"].push_back({{"name", c.name}, {"y", c.y}});
  if (p.x) {
    out["x"] = {{"name", p.x->name}, {"unit", p.x->unit}, {"values", p.x->values}};
    out["lines"] = out["points"] = Json::array();
    for (const Line& l : p.lines) out["lines"].push_back({{"name", l.name}, {"x", l.x}, {"y", l.y}});
    for (const Point& q : p.points) out["points"].push_back({{"name", q.name}, {"x", q.x}, {"y", q.y}});
  }
  if (p.stack) out["stack"] = true;
  if (p.clip) out["clip"] = *p.clip;
  return out;
}

double six_digits(double v) {
  const double digit = v == 0 || !std::isfinite(v) ? 1 : std::pow(10.0, std::floor(std::log10(std::abs(v))) - 5);
  return std::round(v / digit) * digit;
}

/// Rows of the least and the largest value of [from, to), in ascending order; always two rows, even for equal values or NaN.
std::array<std::size_t, 2> extremes(const Values& values, std::size_t from, std::size_t to) {
  std::size_t low = from, high = from;
  for (std::size_t i = from; i < to; ++i) {
    if (values[i] < values[low] || std::isnan(values[low])) low = i;
    if (values[i] > values[high] || std::isnan(values[high])) high = i;
  }
  if (low == high) high = low == from ? to - 1 : from;
  return {std::min(low, high), std::max(low, high)};
}

}  // namespace

std::vector<std::size_t> shown_rows(const Values& values) {
  std::vector<std::size_t> rows;
  const std::size_t count = values.size(), stretch = count > kPlotPoints ? (2 * count + kPlotPoints - 1) / kPlotPoints : 1;
  for (std::size_t from = 0; from < count; from += stretch) {
    const std::size_t to = std::min(from + stretch, count);
    if (to - from == 1) {
      rows.push_back(from);
    } else {
      for (const std::size_t row : extremes(values, from, to)) rows.push_back(row);
    }
  }
  return rows;
}

Values picked(const Values& values, const std::vector<std::size_t>& rows, double factor) {
  Values out;
  for (const std::size_t row : rows) out.push_back(six_digits(factor * values[row]));
  return out;
}

Values thinned(const Values& values, std::size_t first, std::size_t width, double factor) {
  Values column;
  for (std::size_t i = 0; i < values.size() / width; ++i) column.push_back(values[first + i * width]);
  return picked(column, shown_rows(column), factor);
}

std::vector<Curve> columns(const Values& values, const std::vector<std::string>& names, double factor) {
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < names.size(); ++k) curves.push_back({names[k], thinned(values, k, names.size(), factor)});
  return curves;
}

std::string plots_json(const std::vector<Plot>& plots) {
  Json all = Json::array();
  for (const Plot& p : plots) all.push_back(json_of(p));
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace voussoir::io::page
