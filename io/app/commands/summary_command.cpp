// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/summary_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cases/case.h"
#include "geometry/message.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/process.h"
#include "io/input/files/hdf5_file.h"
#include "io/input/messages/messages.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/measures/chance.h"
#include "io/output/measures/measures_file.h"
#include "io/output/measures/members/cracked_units.h"
#include "io/output/measures/members/member_words.h"
#include "io/output/measures/members/peak_base_shear.h"
#include "io/output/measures/place_in_run.h"
#include "io/output/replay/run_file.h"
#include "io/output/replay/run_state.h"
#include "io/output/results/case_of_run.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

/// Contents of /summary; empty for a run that has not written it yet.
Json told(const Hdf5File& run) {
  Json out = Json::object();
  const auto has = [&](const char* name) { return run.has_attribute("/summary", name); };
  for (const char* name : {"finished", "collapsed", "settled", "tension", "shear", "compression", "slipped", "first_tension", "first_shear",
                           "first_compression", "settling_tension", "settling_shear", "settling_compression", "settling_slipped"})
    if (has(name)) out[name] = run.attribute_int("/summary", name);
  for (const char* name : {"fallen_mass_fraction", "first_crack_time", "peak_base_shear", "peak_speed", "worst_residual", "end_time"})
    if (has(name)) out[name] = run.attribute_double("/summary", name);
  for (const char* name : {"state_hash", "failure"})
    if (has(name)) out[name] = run.attribute_text("/summary", name);
  out["state"] = name_of(run_state(run).end);
  return out;
}

Json summary_of(const Hdf5File& run, const Measures& m, const std::optional<Capacity>& capacity) {
  Json out = told(run);
  if (!out.contains("collapsed")) {
    out["collapsed"] = std::int64_t{m.collapsed};
    out["fallen_mass_fraction"] = m.fallen_mass_fraction;
    out["first_crack_time"] = m.first_crack_time;
    out["peak_base_shear"] = peak_base_shear(run).value;
    if (!m.series.time.empty()) out["end_time"] = m.series.time.back();
  }
  if (out.contains("peak_base_shear")) {
    const PeakBaseShear peak{out["peak_base_shear"].get<double>()};
    const double share = peak.over(weight_of(run, norm(case_of_run(run).gravity.acceleration)));
    if (std::isfinite(share)) out["base_shear_over_weight"] = share;
  }
  if (const CrackedUnits u = cracked_units(run); u.units > 0)
    out["units_in_cells"] = {{"units", u.units}, {"cells", u.cells}, {"cracked", u.cracked}, {"through", u.through}};
  if (out.value("finished", 0) == 0 && out.contains("end_time")) {
    const cases::Case c = case_of_run(run);
    const double end = out["end_time"];
    out["stage"] = stage_at(c, end), out["place"] = place_in_run(c, end), out["planned_end"] = c.end();
    if (const RunState state = run_state(run); !state.words.empty()) out["rows"] = state.words;
  }
  out.update(Json::parse(measures_json(m)));
  if (capacity) out["capacity"] = Json::parse(capacity_json(*capacity, false));
  return out;
}

/// A figure with its unit, or `none` if undefined.
std::string text(const char* format, double value, const char* none = "-") {
  if (std::isnan(value)) return none;
  return geometry::printed(format, value);
}
std::string percent(double value) { return text("%.1f %%", 100 * value); }
/// A drift in hundredths of a per cent, of which codes have limits of some tens; without the sign of a zero.
std::string drift(double value) {
  const std::string shown = text("%.2f %%", 100 * value);
  return shown == "-0.00 %" ? shown.substr(1) : shown;
}
std::string seconds(double time) { return time < 0 ? "never" : text("%.3f s", time); }

void line(const char* name, const std::string& value) { std::printf("%-21s%s\n", name, value.c_str()); }

/// A line of figures that are left to chance (chance.h) where the run has any.
void line_of_chance(const Measures& m, const char* name, const std::string& value) { line(name, has_chance(m) ? value + "  *" : value); }

void print_grade(const Measures& m) {
  if (m.damage_grade < 0) return line("damage grade", "-");
  std::string value = "G" + std::to_string(m.damage_grade);
  for (std::size_t g = 0; g < static_cast<std::size_t>(m.damage_grade); ++g) {
    const bool settled = static_cast<std::int64_t>(g) < m.settling_damage_grade;
    value += (g == 0 ? "  (G" : ", G") + std::to_string(g + 1) + " from " + (settled ? "settling" : seconds(m.grade_time[g]));
  }
  line("damage grade", value + (m.damage_grade > 0 ? ")" : ""));
}

std::string millimetres(double x) { return text("%.3f mm", 1e3 * x); }

/// Segment sides by mode: "3 in tension, ...". \param prefix  of the names
std::string counts(const Json& s, const std::string& prefix) {
  std::string value;
  for (const char* mode : {"tension", "shear", "compression"})
    value += (value.empty() ? "" : ", ") + std::to_string(s[prefix + mode].get<std::int64_t>()) + (value.empty() ? " points in " : " in ") +
             mode;
  return value;
}

/// Prints the slip of beams and rafters on the walls that bear them.
void print_seats(const Measures& m) {
  if (std::isnan(m.peak_seat_slip)) return;
  const std::string where = m.peak_seat_slip_place.empty() ? "" : ": " + m.peak_seat_slip_place + ", at " + seconds(m.peak_seat_slip_time);
  line_of_chance(m, "slip of beams",
                 millimetres(m.peak_seat_slip) + " at most" + where + "; " + text("%.3f mm", 1e3 * m.seat_slip) + " at the end" +
                     (m.lost_seats > 0 ? "; " + std::to_string(m.lost_seats) + " lost their seat" : ""));
}

/// Prints the overlap of bodies.
void print_penetration(const Measures& m) {
  line_of_chance(m, "deepest in another",
                 millimetres(m.penetration) + " at the end, at most " + millimetres(m.peak_penetration) +
                     (m.peak_penetration_time < 0 ? "" : " at " + seconds(m.peak_penetration_time)));
  if (!m.peak_penetration_pair.empty()) line("", m.peak_penetration_pair);
  line_of_chance(m, "deepest in the base",
                 millimetres(m.base_penetration) + " at the end, at most " + millimetres(m.peak_base_penetration));
  line_of_chance(m, "over half a segment",
                 m.most_deep_pairs < 0 ? "-"
                                       : std::to_string(m.deep_pairs) + " pairs at the end, at most " + std::to_string(m.most_deep_pairs) +
                                             (m.most_deep_pairs > 0 ? " at " + seconds(m.most_deep_pairs_time) : ""));
  line_of_chance(m, "touching", std::to_string(m.touching_pairs) + " pairs at the end");
}

/// Prints the worst drift along a wall and the worst out of its plane, of walls and gables.
void print_drifts(const Measures& m) {
  const std::string along = m.peak_storey_drift_wall.empty() ? "" : ", along the " + m.peak_storey_drift_wall;
  line_of_chance(m, "storey drift", drift(m.peak_storey_drift) + " at most" + along);
  line_of_chance(m, "in-plane drift", drift(m.peak_in_plane_drift) + " at most, of any metre of a wall's top");
  const bool gable = m.peak_gable_drift > m.peak_drift || (std::isnan(m.peak_drift) && !m.peak_gable.empty());
  const std::string& part = gable ? m.peak_gable : m.peak_drift_wall;
  const std::string of = part.empty() ? "" : ", of the " + part, walls = gable ? "; of walls " + drift(m.peak_drift) : "";
  line_of_chance(m, "out-of-plane drift",
                 drift(gable ? m.peak_gable_drift : m.peak_drift) + " at most" + of + walls + "; at the end " + drift(m.residual_drift) +
                     (gable ? " of walls" : ""));
}

/// Prints breaks due to the building's own weight, and breaks due to what came after.
/// \param begin  s, of settling; its times are below zero, and zero comes when it ends
void print_origin(const Json& s, const Measures& m, double begin) {
  if (m.settling_cracks == 0) return line("broken by settling", "nothing; afterwards " + std::to_string(m.shaking_cracks) + " segments");
  line("broken by settling", std::to_string(m.settling_cracks) + " segments, the first " +
                                 text("%.3f s", m.settling_first_crack_time - begin) + " after it began; afterwards " +
                                 std::to_string(m.shaking_cracks) + " (one of both faces counts once)");
  if (s.contains("settling_tension"))
    line("points of settling", counts(s, "settling_") + "; " + std::to_string(s["settling_slipped"].get<std::int64_t>()) + " slipped");
}

void print_walls(const Measures& m) {
  if (m.walls.empty()) return;
  std::size_t width = 20;
  for (const WallMeasures& w : m.walls) width = std::max(width, w.name.size());
  const int indent = static_cast<int>(width);
  std::printf("\n%-*s %8s %12s %11s %10s %9s %12s %12s %12s\n", indent, "", "fallen", "first fallen", "peak drift", "at end", "in plane",
              "cracks 1 mm", "of 5 mm", "of settling");
  for (const WallMeasures& w : m.walls)
    std::printf("%-*s %8s %12s %11s %10s %9s %12s %12s %12s\n", indent, w.name.c_str(), percent(w.fallen_mass_fraction).c_str(),
                seconds(w.first_fallen_time).c_str(), drift(w.peak_drift).c_str(), drift(w.residual_drift).c_str(),
                drift(std::abs(w.peak_in_plane_drift)).c_str(), text("%.2f", w.crack_extent).c_str(),
                text("%.2f", w.large_crack_extent).c_str(), text("%.2f", w.settling_crack_extent).c_str());
  if (!std::isnan(m.roof_fallen_mass_fraction))
    std::printf("%-*s %8s %12s\n", indent, "roof", percent(m.roof_fallen_mass_fraction).c_str(), seconds(m.roof_first_fallen_time).c_str());
}

/// Prints segment sides by the limit that they reached first and by the mode that opened them; a run of an earlier version has only the
/// latter.
void print_modes(const Json& s) {
  if (s.contains("first_tension")) line("joints failed first", counts(s, "first_"));
  if (!s.contains("tension")) return;
  line("joints opened", counts(s, "") + "; " + std::to_string(s["slipped"].get<std::int64_t>()) + " have slipped and hold");
}

/// Prints how many units in cells have cracked.
void print_units(const Json& s) {
  if (!s.contains("units_in_cells")) return;
  const auto of = [&](const char* name) { return std::to_string(s["units_in_cells"][name].get<std::int64_t>()); };
  line("units cracked", of("cracked") + " of the " + of("units") + " that are divided into cells; " + of("through") +
                            " of them right through a joint between cells");
}

/// Prints the progress of the run, and why it ended early.
void print_end(const Json& s) {
  if (!s.contains("place")) return line("run", "finished at " + text("%.3f s", s.value("end_time", 0.0)));
  const std::string place = s["place"];
  if (s.contains("failure")) {
    line("run", "lost " + place);
    line("", s["failure"]);
    return line("", "figures are those up to there");
  }
  line("run", "not finished: " + place);
  line("", s["rows"].get<std::string>());
}

void print_accelerations(const Measures& m) {
  for (const PointAcceleration& p : m.accelerations.points)
    line_of_chance(m, "peak acceleration", text("%.2f m/s2", p.peak_horizontal) + " at " + p.name + ", horizontal, below 50 Hz");
}

/// \param begin  s, time of the first row \param moves  false: an analysis by states of rest, whose speeds are those of the search
void print_table(const Json& s, const Measures& m, double begin, bool moves) {
  print_end(s);
  print_grade(m);
  line("collapsed", m.collapse_time >= 0 ? "at " + seconds(m.collapse_time) : s["collapsed"] != 0 ? "yes" : "no");
  line("first crack",
       m.settling_cracks == 0 ? seconds(s["first_crack_time"]) : "while settling; afterwards " + seconds(s["first_crack_time"]));
  print_origin(s, m, begin);
  line("first fallen", seconds(m.first_fallen_time) + (m.first_fallen_wall.empty() ? "" : "; of the walls: " + m.first_fallen_wall));
  line_of_chance(m, "fallen mass", percent(s["fallen_mass_fraction"]));
  line_of_chance(m, "debris",
                 text("%.2f m2", m.debris.area) + ", to " + text("%.2f m", m.debris.reach) + " beyond the walls, 95 % to " +
                     text("%.2f m", m.debris.reach_95));
  line_of_chance(m, "free volume",
                 percent(m.free_volume) + " of " + text("%.2f m3", m.initial_free_volume) + ", least " + percent(m.least_free_volume));
  print_drifts(m);
  print_seats(m);
  print_penetration(m);
  print_modes(s);
  print_units(s);
  if (s.contains("peak_base_shear")) {
    const std::string share = s.contains("base_shear_over_weight") ? text(", %.3f of the weight", s["base_shear_over_weight"]) : "";
    line_of_chance(m, "peak base shear", text("%.1f kN", 1e-3 * s["peak_base_shear"].get<double>()) + share);
  }
  if (moves && s.contains("peak_speed")) line_of_chance(m, "peak speed", text("%.2f m/s", s["peak_speed"]));
  if (moves) print_accelerations(m);
  if (s.contains("state_hash")) line("state hash", s["state_hash"]);
  print_walls(m);
  std::fputs((storeys_text(m) + ties_text(m) + loads_text(m.loads)).c_str(), stdout);
  if (has_chance(m)) std::printf("\n* %s\n", words_of_chance(m).c_str());
}

}  // namespace

std::string summary_json(const Hdf5File& run) {
  return summary_of(run, measure(run), capacity_of(run)).dump(-1, ' ', false, Json::error_handler_t::replace);
}

namespace {

/// What stands in a copy without its parts: facts of the model and of the run so far, but no measures, which are of all rows.
Json rest_of(const Hdf5File& run, const std::vector<std::string>& missing) {
  Json out = told(run);
  out["elements"] = run.shape("/model/element/mass").at(0);
  for (const char* table : {"history", "energy", "forces", "damage", "cracks", "frames", "cuts", "assessment"})
    out["rows_of"][table] = run.attribute_int("/", std::string("rows_") + table);
  out["time_first"] = run.attribute_double("/", "time_first"), out["time_last"] = run.attribute_double("/", "time_last");
  out["parts"] = run.named_parts().size();
  out["missing_parts"] = missing;
  return out;
}

int print_rest(const Hdf5File& run, const std::vector<std::string>& missing, bool json) {
  const Json s = rest_of(run, missing);
  const std::string parts = std::to_string(missing.size()) + " of " + std::to_string(s["parts"].get<std::size_t>()) + " parts";
  if (json) {
    std::printf("%s\n", s.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
  } else {
    line("run", s["state"]);
    line("elements", std::to_string(s["elements"].get<std::uint64_t>()));
    std::string rows;
    for (const auto& [table, n] : s["rows_of"].items())
      rows += (rows.empty() ? "" : ", ") + std::to_string(n.get<std::int64_t>()) + " of " + table;
    line("rows", rows + ", from " + text("%.3f", s["time_first"]) + " to " + text("%.3f s", s["time_last"]));
    line("missing", parts + ", with their rows");
  }
  say_error(kFileFault, {.text = run.path() + ": " + parts + " are missing beside it, the first is " + missing.front() +
                                 ": no measures without their rows",
                         .file = run.path()});
  return kFileFault;
}

struct SummaryOptions {
  std::string folder;  // of the run, or its run.h5
  bool json = false;   // one JSON object instead of a table
};

/// Prints the results of a run, with all measures (measures.h), computed anew from its frames; thus also for an unfinished run, a killed
/// one, or one of an earlier version of the program. \throw FileError
int print_summary(const SummaryOptions& o) {
  now_doing("reading the results");
  const Hdf5File run = open_run(o.folder);
  if (const std::vector<std::string> missing = missing_parts(run); !missing.empty()) return print_rest(run, missing, o.json);
  const Measures m = measure(run);
  const std::optional<Capacity> capacity = capacity_of(run);
  const Json summary = summary_of(run, m, capacity);
  if (o.json) {
    std::printf("%s\n", summary.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
  } else {
    const std::vector<double> rows = run.read<double>("/energy/time");
    print_table(summary, m, rows.empty() ? 0.0 : rows.front(), !(capacity && capacity->by_rest()));
    if (capacity) std::printf("\n%s", capacity_text(*capacity).c_str());
  }
  return kDone;
}

}  // namespace

Command add_summary(CLI::App& program) {
  CLI::App* words = program.add_subcommand(
      "summary", "what came out of a run: damage grade, fallen walls, debris, drift, ties and loads; the capacity of a pushover");
  auto o = std::make_shared<SummaryOptions>();
  words->add_option("DIR", o->folder, "folder of the run, finished or not")->required();
  add_format(*words, o->json);
  words->footer("example: voussoir summary results/flat20n");
  return {.words = words, .work = [o] { return print_summary(*o); }};
}

}  // namespace voussoir::io
