// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_capacity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cases/case.h"
#include "geometry/message.h"
#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/report/report_plots.h"

namespace voussoir::io {
namespace {

using namespace page;
using cases::AnalysisKind;
using cases::LoadPattern;
using Json = nlohmann::ordered_json;

Axis over(const std::string& name, const std::string& unit, Values values) { return {name, unit, std::move(values)}; }

/// Adds a bilinear curve: elastic up to yield, then constant up to the ultimate displacement, or to the end of the capacity curve.
void add_bilinear(std::vector<Line>& lines, const std::string& name, const Bilinear& b, double end) {
  if (std::isnan(b.yield) || std::isnan(b.force)) return;
  const double until = std::max(b.yield, std::isnan(b.ultimate) ? end : b.ultimate);
  lines.push_back({name, {0.0, 1e3 * b.yield, 1e3 * until}, {0.0, 1e-3 * b.force, 1e-3 * b.force}});
}

void add_point(std::vector<Point>& points, const std::string& name, double x, double y) {
  if (!std::isnan(x) && !std::isnan(y)) points.push_back({name, x, y});
}

Plot base_shear_plot(const Capacity& c, double left) {
  const CapacityCurve& r = c.curve;
  const std::vector<std::size_t> rows = shown_rows(r.base_shear);
  Plot p{"Base shear over displacement", "kN", picked(r.time, rows), {{"capacity curve", picked(r.base_shear, rows, 1e-3)}}};
  p.x = over("control point", "mm", picked(r.displacement, rows, 1e3));
  add_bilinear(p.lines, "bilinear, EC 8", c.ec8, c.peak_displacement);
  add_bilinear(p.lines, "bilinear, NTC 2018", c.ntc, c.peak_displacement);
  add_point(p.points, "peak", 1e3 * c.peak_displacement, 1e-3 * c.peak_shear);
  add_point(p.points, "ultimate", 1e3 * c.ultimate_displacement, 1e-3 * left * c.peak_shear);
  return p;
}

/// Capacity and demand of the equivalent system in one diagram: acceleration over displacement.
Plot demand_plot(const Capacity& c) {
  const CapacityCurve& r = c.curve;
  const Performance& p = *c.performance;
  const double gamma = p.system.participation, per_mass = 1.0 / (gamma * p.system.mass);
  const std::vector<std::size_t> rows = shown_rows(r.base_shear);
  Plot plot{"Capacity and demand", "m/s2", picked(r.time, rows), {{"capacity curve", picked(r.base_shear, rows, per_mass)}}};
  plot.x = over("displacement of the equivalent system", "mm", picked(r.displacement, rows, 1e3 / gamma));
  Line spectrum{"demand, " + p.spectrum, {}, {}};
  for (std::size_t i = 0; i < p.curve.displacement.size(); ++i) {
    spectrum.x.push_back(1e3 * p.curve.displacement[i]);
    spectrum.y.push_back(p.curve.acceleration[i]);
  }
  plot.lines.push_back(std::move(spectrum));
  const auto add = [&](const std::string& name, const Bilinear& b, const PerformancePoint& point) {
    if (std::isnan(b.yield) || std::isnan(b.force)) return;
    const double until = std::max({b.yield, std::isnan(b.ultimate) ? p.end : b.ultimate, std::isnan(point.target) ? 0.0 : point.target});
    const double top = b.force * per_mass;
    plot.lines.push_back({name, {0.0, 1e3 * b.yield / gamma, 1e3 * until / gamma}, {0.0, top, top}});
    add_point(plot.points, "", 1e3 * point.target_star, std::min(top, top * point.target / b.yield));
  };
  add("bilinear, EC 8", c.ec8, p.points[0]);
  add("bilinear, NTC 2018", c.ntc, p.points[1]);
  add_point(plot.points, "", 1e3 * p.points[2].target_star, p.points[2].force / p.system.mass);
  const auto farthest = std::ranges::max_element(plot.points, {}, &Point::x);  // one name: the others lie near it
  if (farthest != plot.points.end()) farthest->name = plot.points.size() > 1 ? "targets" : "target";
  return plot;
}

Plot factor_plot(const Capacity& c) {
  const CapacityCurve& r = c.curve;
  const std::vector<std::size_t> rows = shown_rows(r.factor);
  Plot p{"Load factor over drift", "", picked(r.time, rows), {{"load factor", picked(r.factor, rows)}}};
  p.x = over("drift of the control point", "%", picked(r.drift, rows, 100));
  const auto at = static_cast<std::size_t>(std::ranges::lower_bound(r.time, c.multiplier_time) - r.time.begin());
  if (at < r.drift.size()) add_point(p.points, "at rest", 100 * r.drift[at], c.multiplier_at_rest);
  return p;
}

Plot loop_plot(const Capacity& c) {
  const CapacityCurve& r = c.curve;
  const std::vector<std::size_t> rows = shown_rows(r.factor);
  Plot p{"Load factor over displacement", "", picked(r.time, rows), {{"loops", picked(r.factor, rows)}}};
  p.x = over("displacement of the forces", "mm", picked(r.moved, rows, 1e3));
  return p;
}

constexpr double kSameDirection = 1e-6;
constexpr std::size_t kLargest = 256U << 20U;  // bytes of limit.json

/// What the page shows of limit.json.
struct LimitAnalysis {
  std::string title;
  std::array<double, 3> direction{};
  std::uint64_t mortar_joints = 0;
  double cone_error = 0.0;
  bool converged = false;
  bool has_ties = false;  // false: of a program that left them out, or there are none
  Json associated, coulomb;  // multipliers; null: none, or none that is finite
};

/// The multiplier of a collapse state: a number, or null. \throw Json::exception
Json multiplier_of(const Json& state) {
  if (state.is_null() || state.at("multiplier").is_null()) return {};
  return state.at("multiplier").get_ref<const double&>();  // as the program writes it, with a point
}

/// \throw Json::exception where a member is missing or of another type
LimitAnalysis read(const std::string& text) {
  const Json all = Json::parse(text);
  LimitAnalysis out;
  out.title = all.at("title").get_ref<const std::string&>();
  for (std::size_t i = 0; i < out.direction.size(); ++i) out.direction[i] = all.at("direction").at(i).get<double>();
  out.mortar_joints = all.at("mortar_joints").get_ref<const std::uint64_t&>();
  out.cone_error = all.at("cone_error").get<double>();
  out.converged = all.at("converged").get<bool>();
  out.has_ties = all.at("associated").is_object() && all.at("associated").contains("ties");
  out.associated = multiplier_of(all.at("associated")), out.coulomb = multiplier_of(all.at("coulomb"));
  return out;
}

bool same_direction(const LimitAnalysis& limit, const cases::Analysis& a) {
  const double length = std::hypot(a.direction[0], a.direction[1]);
  return std::hypot(limit.direction[0] - a.direction[0] / length, limit.direction[1] - a.direction[1] / length) < kSameDirection;
}

std::string per_cent(double share) { return geometry::printed("%.2g %%", 100.0 * share); }

/// Differences between the two analyses, the probably most important first.
Json reasons(const LimitAnalysis& limit, const cases::Case& c, const Capacity& run) {
  Json all = Json::array();
  if (limit.mortar_joints > 0)
    all.push_back("Mortar: the run counts the strength of " + std::to_string(limit.mortar_joints) +
                  " joints, limit analysis takes them as dry.");
  if (!c.ties.empty() && !limit.has_ties) all.push_back("Ties: the run has them, this limit analysis, of an earlier program, left them out.");
  if (!c.ties.empty() && limit.has_ties) all.push_back("Ties: in limit analysis they yield at once, in the run they stretch first, and harden.");
  if (cases::has_push_shape(c.analysis) || (run.kind == AnalysisKind::pushover && c.analysis.pattern != LoadPattern::mass))
    all.push_back("Pattern: the run's forces are not spread as the weights, those of limit analysis are.");
  if (run.kind == AnalysisKind::pushover && !c.loads.empty() && c.analysis.pattern == LoadPattern::given)
    all.push_back("Loads: limit analysis takes loads that grow as dead ones.");
  if (run.ended != "drop" && run.ended != "collapse") all.push_back("The run ended before its peak was sure: " + run.ended + ".");
  if (run.motion_share > 0.01 || run.kinetic_share > 0.01)
    all.push_back("Rate: inertia bore a part of the run's load; repeat it with twice the analysis.pace.");
  all.push_back("Slip: in associated flow it opens joints, in the run it does not. Coulomb's multiplier is the one to compare.");
  all.push_back("Stiffness: the run's joints yield, so blocks lean before they turn, which shortens their lever arms.");
  if (limit.cone_error > 0.0) all.push_back("Facets: friction of limit analysis is off by up to " + per_cent(limit.cone_error) + ".");
  return all;
}

/// Limit analysis for comparison: the output of `voussoir limit CASE --format json` in limit.json beside the run, as {"associated",
/// "coulomb" (null: not computed, or not converged), "reasons" (sentences)}. Null without such a file, or if the run is no pushover or
/// tilt. \throw FileError if the file is invalid, or of another case or direction
Json second_opinion(const std::string& folder, const cases::Case& c, const Capacity& run) {
  const std::string path = folder + "/limit.json";
  std::error_code none;
  if (!has_peak(run) || !std::filesystem::exists(path, none)) return {};
  const std::string text = read_text_file(path, kLargest);
  try {
    const LimitAnalysis limit = read(text);
    if (limit.title != c.title) throw FileError(path, "is of another case, \"" + limit.title + "\"");
    if (!same_direction(limit, c.analysis)) throw FileError(path, "is of another direction than the run");
    return {{"associated", limit.associated}, {"coulomb", limit.converged ? limit.coulomb : Json()}, {"reasons", reasons(limit, c, run)}};
  } catch (const Json::exception&) {
    throw FileError(path, "is not what `voussoir limit CASE --format json` writes");
  }
}

}  // namespace

std::optional<std::string> report_capacity(const Hdf5File& file, const cases::Case* of_run, std::vector<Plot>& plots) {
  const std::optional<Capacity> c = capacity_of(file);
  if (!c) return {};
  const CapacityCurve& r = c->curve;
  Json facts{{"capacity", Json::parse(capacity_json(*c, false))}, {"limit", nullptr}};
  const std::string folder = std::filesystem::path(file.path()).parent_path().string();
  if (of_run != nullptr) facts["limit"] = second_opinion(folder, *of_run, *c);
  if (c->kind == AnalysisKind::cyclic) plots.push_back(loop_plot(*c));
  if (has_peak(*c)) {
    plots.push_back(base_shear_plot(*c, 1.0 - c->drop));
    if (c->performance && !std::isnan(c->performance->system.participation)) plots.push_back(demand_plot(*c));
    plots.push_back(factor_plot(*c));
  }
  const Values time = thinned(r.time);
  if (c->kind != AnalysisKind::settlement) plots.push_back({"Load factor", "", time, columns(r.factor, {"load factor"})});
  plots.push_back({"Base shear along the push", "kN", time, columns(r.base_shear, {"base shear"}, 1e-3)});
  plots.push_back({"Control point, along the push", "mm", time, columns(r.displacement, {"displacement"}, 1000)});
  return facts.dump();
}

}  // namespace voussoir::io
