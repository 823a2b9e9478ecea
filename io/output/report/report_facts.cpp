// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_facts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "cases/tables/motion.h"
#include "geometry/message.h"
#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/input/files/sealed_file.h"
#include "io/input/messages/messages.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/intensity.h"
#include "io/output/measures/building/building.h"
#include "io/output/measures/capacity/capacity.h"
#include "io/output/measures/measures_file.h"
#include "io/output/measures/place_in_run.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/run_state.h"
#include "io/output/report/damage/worst_moment.h"
#include "io/output/report/report_capacity.h"
#include "io/output/report/report_members.h"
#include "io/output/report/report_plots.h"
#include "io/output/results/case_of_run.h"

namespace voussoir::io {
namespace {

using namespace page;
using Json = nlohmann::ordered_json;

const std::vector<std::string> kAxes{"x", "y", "z"};

constexpr double kMostSamples = 5e6;  // of a curve, before it is thinned: as many as /motion can have rows

/// The step [s] between samples over a span of time [s].
double few_enough(double step, double span) { return std::max(step, span / kMostSamples); }

/// Plot of the ground acceleration at its own samples, so that its peaks are included.
Plot ground_plot(const cases::GroundMotion& motion, double from, double until) {
  double step = std::max(until - from, 1e-3);
  for (const cases::Accelerogram& a : motion.axis)
    if (a.dt > 0.0) step = std::min(step, a.dt);
  step = few_enough(step, until - from);
  const auto intervals = static_cast<std::size_t>((until - from) / step + 1e-6);
  std::vector<double> time, value;
  for (std::size_t i = 0; i <= intervals; ++i) {
    time.push_back(from + static_cast<double>(i) * step);
    const Vec3 a = cases::acceleration_at(motion, time.back());
    value.insert(value.end(), {a.x, a.y, a.z});
  }
  return {"Ground acceleration", "m/s²", thinned(time), columns(value, kAxes)};
}

/// Position of the ground [m] at each of these times [s]: from rest, with linear acceleration between samples.
Json ground_track(const cases::GroundMotion& motion, const std::vector<double>& times) {
  double step = 0.01;
  for (const cases::Accelerogram& a : motion.axis)
    if (a.dt > 0.0) step = std::min(step, a.dt);
  if (!times.empty()) step = few_enough(step, times.back());
  Json track = Json::array();
  Vec3 at, speed, last = cases::acceleration_at(motion, 0.0);
  double t = 0.0;
  const auto go = [&](double until) {
    const double h = until - t;
    const Vec3 a = cases::acceleration_at(motion, until);
    at = at + h * speed + (h * h / 6) * (2.0 * last + a), speed = speed + (0.5 * h) * (last + a);
    last = a, t = until;
  };
  for (const double frame : times) {
    while (t + step < frame) go(t + step);
    if (frame > t) go(frame);
    Json point = Json::array();
    for (const double x : {at.x, at.y, at.z}) point.push_back(std::round(1e4 * x) / 1e4);
    track.push_back(std::move(point));
  }
  return track;
}

void add_histories(const Hdf5File& file, std::vector<Plot>& plots) {
  const Values time = thinned(file.read<double>("/history/time"));
  for (const std::string& name : file.children("/history")) {
    const std::string group = "/history/" + name;
    if (!file.is_group(group)) continue;
    plots.push_back({"Displacement of " + name, "mm", time, columns(file.read<double>(group + "/displacement"), kAxes, 1000)});
  }
}

void add_base_shear(const Hdf5File& file, std::vector<Plot>& plots) {
  const auto time = file.read<double>("/forces/time"), force = file.read<double>("/forces/base_shear");
  if (time.empty() || force.size() != 3 * time.size()) return;
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < 2; ++k) curves.push_back({kAxes[k], thinned(force, k, 3, 1e-3)});
  plots.push_back({"Base shear", "kN", thinned(time), std::move(curves)});
}

/// Adds a plot of numbers of sides. \param prefix  of the datasets' names in /damage
void add_sides(const Hdf5File& file, const char* title, const std::string& prefix, std::initializer_list<const char*> names,
               std::vector<Plot>& plots) {
  std::vector<Curve> sides;
  for (const char* name : names) sides.push_back({name, thinned(file.read<double>("/damage/" + prefix + name))});
  plots.push_back({title, "", thinned(file.read<double>("/damage/time")), std::move(sides)});
}

/// Adds plots of broken sides and of energy: input of ground and gravity against stored and lost energy.
void add_tables(const Hdf5File& file, std::vector<Plot>& plots) {
  add_sides(file, "Contact points of joints by what opened them; those that have slipped and hold", "",
            {"tension", "shear", "compression", "slipped"}, plots);
  if (file.exists("/damage/first_shear"))
    add_sides(file, "Contact points of joints by how they failed first", "first_", {"tension", "shear", "compression"}, plots);
  std::vector<Curve> energy;
  const auto time = file.read<double>("/energy/time");
  std::vector<double> given = file.read<double>("/energy/input"), gravity = file.read<double>("/energy/gravity");
  if (given.size() != time.size() || gravity.size() != time.size()) throw FileError(file.path(), "/energy does not fit together");
  for (std::size_t i = 0; i < given.size(); ++i) given[i] -= gravity[i];
  const std::vector<std::pair<const char*, const char*>> kinds{
      {"kinetic", "kinetic"},
      {"strain", file.exists("/ties/force") ? "strain of joints and ties" : "strain of joints"},
      {"contact", "strain of contacts"},
      {"dashpot", "lost in impact"},
      {"friction", "friction"},
      {"fracture", "fracture"},
      {"damping", "mass damping"}};
  for (const auto& [column, name] : kinds)
    energy.push_back({name, thinned(file.read<double>(std::string("/energy/") + column), 0, 1, 1e-3)});
  energy.push_back({"from ground and gravity", thinned(given, 0, 1, 1e-3)});
  plots.push_back({"Energy", "kJ", thinned(time), std::move(energy)});
  plots.back().stack = true;
}

/// Existing attributes as numbers.
Json numbers(const Hdf5File& file, const std::string& object, const std::vector<std::string>& names) {
  Json out = Json::object();
  for (const std::string& name : names)
    if (file.has_attribute(object, name)) out[name] = file.attribute_double(object, name);
  return out;
}

Json texts(const Hdf5File& file, const std::string& object, const std::vector<std::string>& names) {
  Json out = Json::object();
  for (const std::string& name : names)
    if (file.has_attribute(object, name)) out[name] = file.attribute_text(object, name);
  return out;
}

void warn(const char* what, const std::exception& e) { say_warning(std::string("the page has no ") + what + ": " + e.what(), ""); }

/// The name of a record without folders, which could identify the user.
std::string record_name(const cases::Motion& m) {
  if (m.record) return std::filesystem::path(*m.record).filename().string();
  std::string names;
  for (const auto& files : {m.xyz, m.ltv})
    for (const auto& file : files)
      if (file) names += (names.empty() ? "" : ", ") + std::filesystem::path(*file).filename().string();
  return names;
}

/// Whether this motion was applied in the run: rows of /motion have its values, up to the last digits.
bool shook(const cases::GroundMotion& motion, const Hdf5File& file) {
  const auto time = file.read<double>("/motion/time"), a = file.read<double>("/motion/acceleration");
  if (a.size() != 3 * time.size()) throw FileError(file.path(), "/motion does not fit together");
  double most = 0, off = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const Vec3 now = cases::acceleration_at(motion, time[i]);
    most = std::max({most, std::abs(now.x), std::abs(now.y), std::abs(now.z)});
    off = std::max({off, std::abs(now.x - a[3 * i]), std::abs(now.y - a[3 * i + 1]), std::abs(now.z - a[3 * i + 2])});
  }
  return off <= 1e-9 * most;
}

/// The motion applied in the run: from the samples of its records, or, if these have changed or are missing, from the run.
cases::GroundMotion motion_of(const LoadedCase& c, const Hdf5File& file) {
  const cases::Motion& m = *c.value.motion;
  if (!file.exists("/motion/acceleration") || file.shape("/motion/time").at(0) < 2) return load_motion(m, c.value.folder);
  cases::GroundMotion applied = base_of_run(file, c.value);
  try {
    cases::GroundMotion records = load_motion(m, c.value.folder);
    if (shook(records, file)) return records;
    say_warning("the records of the motion have changed since the run; the page shows the motion that the run holds", "");
  } catch (const DamagedFile&) {
    throw;
  } catch (const std::exception& e) {
    say_warning(std::string(e.what()) + "; the page shows the motion that the run holds", "");
  }
  return applied;
}

/// Total factors of the components of the record.
std::array<double, 3> scale_of(const cases::Motion& m, const Hdf5File& file) {
  std::array<double, 3> scale = m.scale;
  if (m.intensity && file.exists("/motion/factors")) {
    const std::vector<double> factors = file.read<double>("/motion/factors");
    for (std::size_t i = 0; i < scale.size(); ++i) scale[i] *= factors.at(i);
  } else if (m.intensity && file.exists("/motion/factor")) {  // of a run before motion.intensity.components
    for (double& s : scale) s *= file.read<double>("/motion/factor").at(0);
  }
  return scale;
}

/// The samples of a motion up to a time [s], at least one.
cases::Accelerogram up_to(cases::Accelerogram a, double end) {
  const double samples = a.dt > 0.0 ? std::floor(std::max(0.0, end) / a.dt + 1e-6) + 1.0 : 1e300;
  if (samples < static_cast<double>(a.acceleration.size())) a.acceleration.resize(static_cast<std::size_t>(samples));
  return a;
}

/// Adds the ground motion, with the peaks of what was shaken: a run may end before its record. Without motion in the run, and without the
/// records, the page has neither peaks nor curves.
void add_ground(const LoadedCase& c, const Hdf5File& file, const FrameReader& frames, Json& facts, std::vector<Plot>& plots) {
  const auto times = file.read<double>("/history/time");
  if (!c.value.motion || is_assessment(c.value.analysis)) return;
  const cases::Motion& m = *c.value.motion;
  const bool turned = m.record || std::ranges::any_of(m.ltv, [](const auto& f) { return f.has_value(); });
  const std::string level = m.intensity ? ", " + described(*m.intensity) : "";
  facts["motion"] = {{"record", record_name(m) + level}, {"direction", turned ? m.direction : ""}, {"scale", scale_of(m, file)}};
  try {
    const cases::GroundMotion motion = motion_of(c, file);
    Json peak = Json::array();
    for (const cases::Accelerogram& a : motion.axis) {
      const cases::Accelerogram shaken = times.empty() ? a : up_to(a, times.back());
      peak.push_back(figures(shaken).peak_acceleration);
      if (shaken.acceleration.size() < a.acceleration.size()) facts["motion"]["until"] = times.back();
    }
    facts["motion"]["peak"] = peak;
    if (!times.empty()) plots.push_back(ground_plot(motion, 0.0, times.back()));
    facts["ground"] = ground_track(motion, frames.times());
  } catch (const DamagedFile&) {
    throw;
  } catch (const std::exception& e) {
    warn("ground motion", e);
  }
}

/// The moment at which the page opens, and what happens then.
void add_worst(const Hdf5File& file, const Measures& m, const FrameReader& frames, Json& facts) {
  const std::optional<Capacity> capacity = capacity_of(file);
  if (const auto worst = worst_moment(m, capacity ? &*capacity : nullptr, frames))
    facts["worst"] = {{"time", worst->time}, {"name", worst->name}, {"what", worst->what}};
}

/// Adds plots and facts of the collapse.
void add_measures(const Hdf5File& file, const FrameReader& frames, Json& facts, std::vector<Plot>& plots) {
  try {
    const Measures m = measure(file);
    facts["measures"] = Json::parse(measures_json(m));
    facts["measures"].update(
        {{"fallen_mass_fraction", m.fallen_mass_fraction}, {"first_crack_time", m.first_crack_time}, {"collapsed", m.collapsed}});
    const Values time = thinned(m.series.time);
    std::vector<std::string> walls;
    for (const WallMeasures& w : m.walls) walls.push_back(w.name);
    if (!walls.empty()) {
      plots.push_back({"Out-of-plane drift, outward positive", "%", time, columns(m.series.drift, walls, 100)});
      plots.back().clip = 100 * kWildDrift;
    }
    add_worst(file, m, frames, facts);
    add_members(file, m, walls, plots);
    std::vector<Curve> fallen = columns(m.series.fallen_mass_fraction, {"fallen mass"}, 100);
    if (m.initial_free_volume > 0) fallen.push_back({"free volume under the roof", thinned(m.series.free_volume, 0, 1, 100)});
    plots.push_back({m.initial_free_volume > 0 ? "Fallen mass, volume left under the roof" : "Fallen mass", "%", time, std::move(fallen)});
  } catch (const DamagedFile&) {
    throw;
  } catch (const FileError& e) {
    warn("measures of the collapse", e);
  }
}

/// Adds walls and rooms, for names and for the free space in the scene.
void add_building(const Hdf5File& file, Json& facts) {
  facts["walls"] = facts["rooms"] = Json::array();
  try {
    const Building b = building_of(file);
    for (const Wall& w : b.walls)
      facts["walls"].push_back({{"name", w.name},
                                {"low", w.box.low},
                                {"high", w.box.high},
                                {"across", w.across},
                                {"outward", w.outward},
                                {"axes", {w.axes.cosine, w.axes.sine}}});
    for (const Room& r : b.rooms)
      facts["rooms"].push_back({{"low", {r.low[0], r.low[1], r.floor}}, {"high", {r.high[0], r.high[1], r.ceiling}}});
  } catch (const DamagedFile&) {
    throw;
  } catch (const FileError& e) {
    warn("names of walls", e);
  }
}

/// The case of the run; nothing if it is unreadable, as from another version of the program.
std::optional<LoadedCase> case_of(const Hdf5File& file) {
  try {
    return read_case({file.path(), file.attribute_text("/case", "toml")});
  } catch (const DamagedFile&) {
    throw;
  } catch (const std::exception& e) {
    warn("ground motion", e);
    return {};
  }
}

/// Where a run stands that is not at its end, and why it was lost if it was, in the words of `voussoir summary`.
void add_place(const Hdf5File& file, const std::optional<LoadedCase>& c, double last_frame, Json& summary) {
  if (summary.value("finished", 0.0) != 0.0) return;
  const double end = summary.value("end_time", last_frame);
  summary["place"] = c ? place_in_run(c->value, end) : geometry::printed("at %.3f s", end);
  if (const RunState state = run_state(file); !state.words.empty()) summary["place"] = std::string(summary["place"]) + "; " + state.words;
  if (file.has_attribute("/summary", "failure")) summary["failure"] = file.attribute_text("/summary", "failure");
}

/// Numbers the parts of the building in order of their first element.
std::vector<std::int32_t> number_parts(const Hdf5File& file, Json& facts) {
  std::map<std::string, std::int32_t> numbers;
  std::vector<std::int32_t> part;
  facts["parts"] = Json::array();
  for (const std::string& tag : file.read_strings("/model/element/tag")) {
    const auto [at, is_new] = numbers.emplace(part_of(tag), static_cast<std::int32_t>(numbers.size()));
    if (is_new) facts["parts"].push_back(at->first);
    part.push_back(at->second);
  }
  constexpr std::size_t kMostParts = 40;  // more names do not fit a legend
  if (facts["parts"].size() > kMostParts) {
    facts["parts"] = Json::array({"all elements"});
    part.assign(part.size(), 0);
  }
  return part;
}

}  // namespace

std::string safe_json(const std::string& json) {
  std::string out;
  for (const char c : json) out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

ReportFacts report_facts(const Hdf5File& file, const FrameReader& frames, double quantum) {
  const std::optional<LoadedCase> c = case_of(file);
  ReportFacts out;
  Json facts;
  facts["title"] = c ? c->value.title : std::filesystem::path(file.path()).parent_path().filename().string();
  std::vector<Plot> plots;
  if (c) add_ground(*c, file, frames, facts, plots);
  if (const auto found = report_capacity(file, c ? &c->value : nullptr, plots)) facts.update(Json::parse(*found));
  add_measures(file, frames, facts, plots);
  add_histories(file, plots);
  add_base_shear(file, plots);
  add_ties(file, plots);
  add_loads(file, plots);
  add_tables(file, plots);
  add_building(file, facts);
  facts["summary"] =
      numbers(file, "/summary",
              {"finished", "collapsed", "first_crack_time", "fallen_mass_fraction", "end_time", "tension", "shear", "compression",
               "slipped", "first_tension", "first_shear", "first_compression", "settling_tension", "settling_shear", "settling_compression",
               "settling_slipped", "peak_base_shear", "peak_speed", "worst_residual"});
  add_place(file, c, frames.times().empty() ? 0.0 : frames.times().back(), facts["summary"]);
  facts["provenance"] = texts(file, "/provenance", {"version", "compiler", "cpu", "started", "ended"});
  facts["provenance"].update(numbers(file, "/provenance", {"threads", "wall_clock"}));
  facts["times"] = frames.times();
  facts["every"] = frames.every();
  const Vec3 origin = origin_of_run(file);
  facts["base"] = c && !c->value.base ? Json(nullptr) : Json(c ? c->value.base->z - origin.z : 0.0);
  if (!(origin == Vec3{})) facts["origin"] = {origin.x, origin.y, origin.z};
  facts["materials"] = file.read_strings("/model/material/name");
  facts["quantum"] = quantum;
  out.part = number_parts(file, facts);
  out.material = file.read<std::int32_t>("/model/element/material");
  out.plots = plots_json(plots);
  out.json = safe_json(facts.dump(-1, ' ', false, Json::error_handler_t::replace));
  return out;
}

}  // namespace voussoir::io
