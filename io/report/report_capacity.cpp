// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/report/report_capacity.h"

#include <cmath>
#include <optional>
#include <string>

#include "io/files/hdf5_file.h"
#include "io/measures/capacity_file.h"
#include "io/report/report_plots.h"

namespace voussoir::io {
namespace {

using namespace page;
using cases::AnalysisKind;

Json over(const std::string& name, const std::string& unit, Json values) {
  return {{"name", name}, {"unit", unit}, {"values", std::move(values)}};
}

/// Elastic up to yield, level up to the ultimate displacement, or as far as the curve goes.
void add_bilinear(Json& lines, const std::string& name, const Bilinear& b, double end) {
  if (std::isnan(b.yield) || std::isnan(b.force)) return;
  const double until = std::max(b.yield, std::isnan(b.ultimate) ? end : b.ultimate);
  lines.push_back({{"name", name}, {"x", {0.0, 1e3 * b.yield, 1e3 * until}}, {"y", {0.0, 1e-3 * b.force, 1e-3 * b.force}}});
}

void add_point(Json& points, const std::string& name, double x, double y) {
  if (!std::isnan(x) && !std::isnan(y)) points.push_back({{"name", name}, {"x", x}, {"y", y}});
}

Json base_shear_plot(const Capacity& c, double left) {
  const CapacityCurve& r = c.curve;
  Json p = plot("Base shear over displacement", "kN", thinned(r.time), columns(r.base_shear, {"capacity curve"}, 1e-3));
  p["x"] = over("control point", "mm", thinned(r.displacement, 0, 1, 1e3));
  p["lines"] = p["points"] = Json::array();
  add_bilinear(p["lines"], "bilinear, EC 8", c.ec8, c.peak_displacement);
  add_bilinear(p["lines"], "bilinear, NTC 2018", c.ntc, c.peak_displacement);
  add_point(p["points"], "peak", 1e3 * c.peak_displacement, 1e-3 * c.peak_shear);
  add_point(p["points"], "ultimate", 1e3 * c.ultimate_displacement, 1e-3 * left * c.peak_shear);
  return p;
}

Json factor_plot(const Capacity& c) {
  const CapacityCurve& r = c.curve;
  Json p = plot("Load factor over drift", "", thinned(r.time), columns(r.factor, {"load factor"}));
  p["x"] = over("drift of the control point", "%", thinned(r.drift, 0, 1, 100));
  const auto at = static_cast<std::size_t>(std::ranges::lower_bound(r.time, c.multiplier_time) - r.time.begin());
  p["points"] = Json::array();
  if (at < r.drift.size()) add_point(p["points"], "at rest", 100 * r.drift[at], c.multiplier_at_rest);
  return p;
}

Json loop_plot(const Capacity& c) {
  const CapacityCurve& r = c.curve;
  Json p = plot("Load factor over displacement", "", thinned(r.time), columns(r.factor, {"loops"}));
  p["x"] = over("displacement of the forces", "mm", thinned(r.moved, 0, 1, 1e3));
  return p;
}

}  // namespace

void add_capacity(const Hdf5File& file, Json& facts) {
  const std::optional<Capacity> c = capacity_of(file);
  if (!c) return;
  const CapacityCurve& r = c->curve;
  facts["capacity"] = Json::parse(capacity_json(*c, false));
  Json& plots = facts["plots"];
  if (c->kind == AnalysisKind::cyclic) plots.push_back(loop_plot(*c));
  if (c->kind == AnalysisKind::pushover || c->kind == AnalysisKind::tilt) {
    plots.push_back(base_shear_plot(*c, 1.0 - c->drop));
    plots.push_back(factor_plot(*c));
  }
  const Json time = thinned(r.time);
  if (c->kind != AnalysisKind::settlement) plots.push_back(plot("Load factor", "", time, columns(r.factor, {"load factor"})));
  plots.push_back(plot("Base shear along the push", "kN", time, columns(r.base_shear, {"base shear"}, 1e-3)));
  plots.push_back(plot("Control point, along the push", "mm", time, columns(r.displacement, {"displacement"}, 1000)));
}

}  // namespace voussoir::io
