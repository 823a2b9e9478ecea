// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/capacity_file.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "io/input/files/hdf5_file.h"
#include "io/output/measures/capacity/performance_file.h"
#include "solver/run/run.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;
using cases::AnalysisKind;

constexpr double kSlow = 0.01;  // share of the work in motion above which a result is marked as dependent on the rate

bool is_slow(const Capacity& c) { return std::abs(c.motion_share) <= kSlow && c.kinetic_share <= kSlow; }

void add_bilinear(std::vector<Figure>& to, const std::array<const char*, 4>& names, const Bilinear& b) {
  to.push_back({names[0], b.stiffness, "N/m (NaN: none)"});
  to.push_back({names[1], b.force, "N (NaN: none)"});
  to.push_back({names[2], b.yield, "m (NaN: none)"});
  to.push_back({names[3], b.ductility, "1 (NaN: none)"});
}

__attribute__((format(printf, 2, 3))) std::string line(const char* name, const char* format, ...) {
  std::array<char, 300> value{}, all{};
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(value.data(), value.size(), format, arguments);
  va_end(arguments);
  std::snprintf(all.data(), all.size(), "%-21s%.270s\n", name, value.data());
  return all.data();
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& n : names) text += (text.empty() ? "" : "; ") + n;
  return text.empty() ? "none" : text;
}

Json loops_json(const std::vector<Loop>& loops) {
  Json out = Json::array();
  for (const Loop& l : loops) {
    out.push_back({{"begin", l.begin},
                   {"end", l.end},
                   {"most", l.most},
                   {"least", l.least},
                   {"most_factor", l.most_factor},
                   {"least_factor", l.least_factor},
                   {"first_factor", l.first_factor},
                   {"last_factor", l.last_factor},
                   {"area", l.area},
                   {"dissipated", l.dissipated},
                   {"stored", l.stored},
                   {"other_work", l.other_work},
                   {"viscous_damping", l.viscous_damping}});
  }
  return out;
}

/// Why the analysis ended, in words.
std::string end_words(const Capacity& c) {
  if (c.ended != "history") return c.ended;
  return c.kind == AnalysisKind::cyclic ? "end of its amplitudes" : "end of the movement of the supports";
}

/// The parts that move, in words; of those that stay in place only how many there are.
std::string moving(const std::vector<std::string>& parts) {
  std::vector<std::string> words;
  for (const std::string& part : parts)
    if (part.find("stays in place") == std::string::npos) words.push_back(part);
  const std::size_t still = parts.size() - words.size();
  if (words.empty()) return still == 0 ? "none" : "none: no part with 1 % of the building's mass or more has moved by 5 mm on average";
  if (still > 0) words.push_back(std::to_string(still) + (still == 1 ? " part stays in place" : " parts stay in place"));
  return list(words);
}

std::string mechanisms(const Capacity& c) {
  return "mechanism            " + moving(c.mechanism) + "\nmechanism at the end " + moving(c.mechanism_at_end) + "\n";
}

double hanging_length(const Capacity& c) {
  double sum = 0.0;
  for (const HangingWall& h : c.hanging) sum += h.length;
  return sum;
}

/// Of the loads that grow and of the movements of supports, at the last state of rest; 1 where all is on, also of weights alone. What has
/// collapsed may rest, too, on the ground: that row does not count.
double share_at_rest(const Capacity& c) {
  if (c.ended == "all is on") return 1.0;
  const auto& factor = c.curve.factor;
  if (c.ended != "collapse") return factor.back();
  return factor.size() > 1 ? factor[factor.size() - 2] : 0.0;
}

Json hanging_json(const std::vector<HangingWall>& walls) {
  Json out = Json::array();
  for (const HangingWall& h : walls)
    out.push_back({{"wall", h.wall}, {"length", h.length}, {"from", h.from}, {"to", h.to}, {"gap", h.gap}, {"height", h.height}});
  return out;
}

std::string hanging_text(const std::vector<HangingWall>& walls) {
  std::string text;
  for (const HangingWall& h : walls)
    text += line(text.empty() ? "hangs" : "",
                 "the ground has left the %s over %.2f m (%.2f to %.2f m from its left end): a gap of up to %.1f mm, at %.2f m%s",
                 h.wall.c_str(), h.length, h.from, h.to, 1e3 * h.gap, h.height,
                 &h == &walls.back() ? "; what is above hangs by the bond of its mortar" : "");
  return text;
}

std::string loops_text(const std::vector<Loop>& loops) {
  std::string text;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const Loop& l = loops[k];
    text += line(std::string("loop ").append(std::to_string(k + 1)).c_str(),
                 "%.3f to %.3f mm, factor %.4f to %.4f; area %.4g J, lost %.4g J, stored %.3g J, other loads %.3g J; damping %.1f %%",
                 1e3 * l.least, 1e3 * l.most, l.least_factor, l.most_factor, l.area, l.dissipated, l.stored, l.other_work,
                 100.0 * l.viscous_damping);
  }
  return text;
}

std::string bilinear_text(const char* name, const Bilinear& b) {
  if (std::isnan(b.yield)) return line(name, "none");
  std::string ductility = std::isnan(b.ultimate) ? "not reached" : "none, the curve turns back";
  if (!std::isnan(b.ductility)) ductility = std::to_string(b.ductility).substr(0, 5);
  return line(name, "%.1f kN from %.3f mm on (%.4g kN/mm), ductility %s", 1e-3 * b.force, 1e3 * b.yield, 1e-6 * b.stiffness,
              ductility.c_str());
}

void write_loops(Hdf5File& file, const std::string& name, const std::vector<Loop>& loops) {
  constexpr std::uint64_t kColumns = 13;
  std::vector<double> rows;
  for (const Loop& l : loops) {
    rows.insert(rows.end(), {l.begin, l.end, l.most, l.least, l.most_factor, l.least_factor, l.first_factor, l.last_factor, l.area,
                             l.dissipated, l.stored, l.other_work, l.viscous_damping});
  }
  file.write_dataset(name, Hdf5Type::f64, {loops.size(), kColumns}, rows.data(), {},
                     {"s, s, m, m, 1, 1, 1, 1, J, J, J, J, 1",
                      "whole cycles: begin, end, most, least, most_factor, least_factor, first_factor, last_factor, area, dissipated, "
                      "stored, other_work, viscous_damping"});
}

}  // namespace

const char* name_of(AnalysisKind kind) {
  switch (kind) {  // the compiler misses one that is new
    case AnalysisKind::time_history:
      return "time-history";
    case AnalysisKind::pushover:
      return "pushover";
    case AnalysisKind::tilt:
      return "tilt";
    case AnalysisKind::settlement:
      return "settlement";
    case AnalysisKind::cyclic:
      return "cyclic";
    case AnalysisKind::rest:
      return "rest";
  }
  return "";
}

std::vector<std::string> not_proven(const Capacity& c) {
  std::vector<std::string> doubts;
  if (c.lost_residual > solver::kResidualLimit) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "contacts jumped from iteration to iteration (energy error %.2g): a state of rest may have been missed", c.lost_residual);
    doubts.emplace_back(text);
  }
  if (c.kind != AnalysisKind::cyclic && c.ultimate_displacement < c.peak_displacement)
    doubts.emplace_back(
        "the control point moves back after the peak: ultimate displacement, near collapse and ductility do not describe the part "
        "that fails; set analysis.control to a part named in the mechanism");
  return doubts;
}

std::vector<Figure> figures_of(const Capacity& c) {
  std::vector<Figure> f{{"kind", name_of(c.kind), "analysis.kind"}, {"ended", c.ended, "why"}};
  f.push_back({"lost_residual", c.lost_residual, "1, residual of the ledger where no further state of rest was found (NaN: another end)"});
  if (c.kind == AnalysisKind::rest) {
    f.push_back({"share", share_at_rest(c), "1, of the loads that grow and of the supports' movements, at the last state of rest"});
    f.push_back({"unbalanced", c.unbalanced, "1, largest unbalanced force over the mean weight of an element"});
  }
  if (follows_supports(c.kind)) {
    f.push_back({"collapse_movement", c.collapse_movement, "m of a support (NaN: never)"});
    f.push_back({"collapse_time", c.collapse_time, "s (NaN: never)"});
    f.push_back({"hanging_length", hanging_length(c), "m of walls that the ground has left, at the end"});
    return f;
  }
  f.push_back({"multiplier", c.multiplier, "1"});
  if (c.kind != AnalysisKind::cyclic) {  // not for cycles, which reverse within the window of the mean
    f.push_back({"multiplier_at_rest", c.multiplier_at_rest, "1"});
    f.push_back({"multiplier_displacement", c.multiplier_displacement, "m"});
    f.push_back({"multiplier_time", c.multiplier_time, "s"});
  }
  f.push_back({"fallen_before", c.fallen_before, "1, of the mass, while gravity was put on"});
  f.push_back({"motion_share", c.motion_share, "1"});
  f.push_back({"kinetic_share", c.kinetic_share, "1"});
  f.push_back({"unbalanced", c.unbalanced, "1 (NaN: dynamics), largest unbalanced force over the mean weight of an element"});
  f.push_back({"slow", std::int64_t{is_slow(c)}, "0: the result depends on the rate"});
  f.push_back({"loop_area", c.loop_area, "J"});
  f.push_back({"dissipated", c.dissipated, "J"});
  f.push_back({"stored", c.stored, "J"});
  if (c.kind == AnalysisKind::cyclic) {
    f.push_back({"least_factor", c.least_factor, "1"});
    return f;
  }
  f.push_back({"peak_shear", c.peak_shear, "N"});
  f.push_back({"peak_displacement", c.peak_displacement, "m"});
  f.push_back({"peak_time", c.peak_time, "s"});
  f.push_back({"first_stiffness", c.first_stiffness, "N/m (NaN: none)"});
  f.push_back({"ultimate_displacement", c.ultimate_displacement, "m (NaN: not reached)"});
  f.push_back({"ultimate_drift", c.ultimate_drift, "1 (NaN: not reached)"});
  f.push_back({"near_collapse", c.near_collapse, "m (NaN: not reached)"});
  add_bilinear(f, {"ec8_stiffness", "ec8_force", "ec8_yield", "ec8_ductility"}, c.ec8);
  add_bilinear(f, {"ntc_stiffness", "ntc_force", "ntc_yield", "ntc_ductility"}, c.ntc);
  if (!c.performance) return f;
  const std::vector<Figure> more = figures_of(*c.performance);
  f.insert(f.end(), more.begin(), more.end());
  return f;
}

std::string capacity_json(const Capacity& c, bool with_curve) {
  Json out;
  for (const Figure& f : figures_of(c)) std::visit([&](const auto& value) { out[f.name] = value; }, f.value);
  if (follows_supports(c.kind)) out["hanging"] = hanging_json(c.hanging);
  if (c.kind == AnalysisKind::cyclic) out["loops"] = loops_json(c.loops);
  if (c.performance) out["performance"] = Json::parse(performance_json(*c.performance));
  if (c.control) {
    const Vec3 p = c.control->position;
    out["control"] = {{"element", c.control->element}, {"part", c.control->part}, {"position", {p.x, p.y, p.z}}};
  }
  out["not_proven"] = not_proven(c);
  out["mechanism"] = c.mechanism;
  out["mechanism_time"] = c.mechanism_time;
  out["mechanism_at_end"] = c.mechanism_at_end;
  if (with_curve) {
    const CapacityCurve& r = c.curve;
    out["curve"] = {{"time", r.time},   {"factor", r.factor},         {"displacement", r.displacement},  {"drift", r.drift},
                    {"moved", r.moved}, {"base_shear", r.base_shear}, {"support_moved", r.support_moved}};
  }
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string capacity_text(const Capacity& c) {
  const bool failed = c.ended == "numerical failure", on = failed || c.ended == "not yet";  // figures so far
  std::string text = failed ? line("analysis", "%s, ended by: %s; figures up to there", name_of(c.kind), c.ended.c_str())
                     : on   ? line("analysis", "%s, not at its end: figures so far", name_of(c.kind))
                            : line("analysis", "%s, ended by: %s", name_of(c.kind), end_words(c).c_str());
  if (c.by_rest()) text += line("times", "are iterations of the search for equilibrium: they give the order of events, not seconds");
  for (const std::string& doubt : not_proven(c)) text += line("not proven", "%s", doubt.c_str());
  if (c.control) {
    const Vec3 p = c.control->position;
    text += line("control point", "%s (element %lld), at (%.3f, %.3f, %.3f) m", c.control->part.c_str(),
                 static_cast<long long>(c.control->element), p.x, p.y, p.z);
    if (c.control->timber)
      text += line("", "which may slip on its walls: analysis.control names a wall, as \"rear wall\", or a point in its place");
  }
  if (c.kind == AnalysisKind::rest) {
    const double share = share_at_rest(c);
    text += c.ended == "all is on"
                ? line("at rest", "under all of it; unbalanced by at most %.1e of an element's mean weight", c.unbalanced)
                : line("at rest", "up to %.4f of the loads that grow and of the supports' movements%s", share,
                       on ? ", so far" : "; no state of rest was found beyond");
    return text + line("supports moved", "by %.4f m", c.curve.support_moved.back()) + hanging_text(c.hanging) + "mechanism at the end " +
           moving(c.mechanism_at_end) + "\n";
  }
  if (c.kind == AnalysisKind::settlement) {
    text += std::isnan(c.collapse_movement)
                ? line("fell", "%s; supports moved by %.4f m", on ? "not so far" : "never", c.curve.support_moved.back())
                : line("fell", "after a movement of %.4f m, at %.2f s", c.collapse_movement, c.collapse_time);
    return text + hanging_text(c.hanging) + "mechanism at the end " + moving(c.mechanism_at_end) + "\n";
  }
  if (c.fallen_before > 0.0)
    text += line("before the load", "%.1f %% of the mass fell while gravity was put on: these figures are of the state after the fall",
                 1e2 * c.fallen_before);
  const char* name = c.kind == AnalysisKind::tilt ? "multiplier" : "largest load factor";
  text += c.kind == AnalysisKind::cyclic ? line(name, "%.4f", c.multiplier)
                                         : line(name, "%.4f; %.4f of it static, at %.3f mm of the control point", c.multiplier,
                                                c.multiplier_at_rest, 1e3 * c.multiplier_displacement);
  text += !std::isnan(c.unbalanced)
              ? line("equilibrium", "%zu states of rest, unbalanced by at most %.1e of an element's mean weight", c.curve.time.size(),
                     c.unbalanced)
              : line("rate", "%.2g of that was borne by inertia and damping, kinetic energy at most %.2g of the work: %s", c.motion_share,
                     c.kinetic_share, is_slow(c) ? "slow enough" : "the result depends on the rate; try a larger analysis.pace");
  if (c.kind == AnalysisKind::cyclic) {
    text += line("the other way", "%.4f", c.least_factor);
    text += line("loops", "%.4g J put in, %.4g J lost, %.4g J stored", c.loop_area, c.dissipated, c.stored);
    text += loops_text(c.loops);
  } else {
    if (std::isnan(c.first_stiffness)) return text + line("base shear", "none along the push: no capacity curve") + mechanisms(c);
    text += line("largest base shear", "%.2f kN at %.3f mm; first stiffness %.4g kN/mm", 1e-3 * c.peak_shear, 1e3 * c.peak_displacement,
                 1e-6 * c.first_stiffness);
    text += std::isnan(c.ultimate_displacement)
                ? line("ultimate", on ? "not reached so far" : "not reached")
                : line("ultimate", "%.3f mm, drift %.3f %%", 1e3 * c.ultimate_displacement, 1e2 * c.ultimate_drift);
    text += std::isnan(c.near_collapse) ? line("near collapse", on ? "not reached so far" : "not reached")
                                        : line("near collapse", "%.3f mm, 80 %% of the base shear left; significant damage (3/4) %.3f mm",
                                               1e3 * c.near_collapse, 0.75e3 * c.near_collapse);
    text += bilinear_text("bilinear, EC 8", c.ec8);
    text += bilinear_text("bilinear, NTC 2018", c.ntc);
    if (c.performance) text += performance_text(*c.performance);
  }
  return text + mechanisms(c);
}

void write_capacity(Hdf5File& file, const Capacity& c) {
  const std::string at = "/capacity";
  file.make_group(at);
  std::string units;
  for (const Figure& f : figures_of(c)) {
    std::visit([&](const auto& value) { file.set_attribute(at, f.name, value); }, f.value);
    units.append(units.empty() ? "" : "; ").append(f.name).append(": ").append(f.unit);
  }
  file.set_attribute(at, "mechanism_time", c.mechanism_time);
  if (c.control) {
    file.set_attribute(at, "control_element", c.control->element);
    file.set_attribute(at, "control_part", c.control->part);
    file.set_attribute(at, "control_x", c.control->position.x);
    file.set_attribute(at, "control_y", c.control->position.y);
    file.set_attribute(at, "control_z", c.control->position.z);
    units += "; control_x, control_y, control_z: m, in the axes of the case file";
  }
  file.set_attribute(at, "units", units + "; mechanism_time: s");
  if (!c.loops.empty()) write_loops(file, at + "/loops", c.loops);
  file.write_strings(at + "/mechanism", c.mechanism, {"1", "parts that move as one from the largest load factor on, and what they do"});
  file.write_strings(at + "/mechanism_at_end", c.mechanism_at_end, {"1", "the same at the end"});
}

}  // namespace voussoir::io
