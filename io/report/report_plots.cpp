// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/report/report_plots.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace voussoir::io::page {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPlotPoints = 20000;  // of a curve at most: the rows of a hundred seconds; the page shows their peaks

/// JSON has no NaN: it becomes null when it is written.
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

}  // namespace

Values thinned(const Values& values, std::size_t first, std::size_t width, double factor) {
  Values out;
  const std::size_t rows = values.size() / width, stride = std::max<std::size_t>(1, (rows + kPlotPoints - 1) / kPlotPoints);
  for (std::size_t i = 0; i < rows; i += stride) {
    const double v = factor * values[first + i * width];
    const double digit = v == 0 || !std::isfinite(v) ? 1 : std::pow(10.0, std::floor(std::log10(std::abs(v))) - 5);
    out.push_back(std::round(v / digit) * digit);
  }
  return out;
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
