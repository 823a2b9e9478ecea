// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/report/report_data.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "io/case_file/case_file.h"
#include "io/files/errors.h"
#include "io/files/hdf5_file.h"
#include "io/files/packed_text.h"
#include "io/measures/measures_file.h"
#include "io/motion/motion_files.h"
#include "io/replay/covered_faces.h"
#include "io/replay/frame_reader.h"
#include "io/replay/opened_faces.h"
#include "io/report/report_frames.h"
#include "io/report/report_page.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPlotPoints = 20000;  // of a curve at most: the rows of a hundred seconds; the page shows their peaks

/// Every so many rows are shown of `rows`.
std::size_t stride_of(std::size_t rows) { return std::max<std::size_t>(1, (rows + kPlotPoints - 1) / kPlotPoints); }

/// Component `first` of rows of `width`, thinned, to six digits.
Json thinned(const std::vector<double>& values, std::size_t first = 0, std::size_t width = 1) {
  Json out = Json::array();
  const std::size_t rows = values.size() / width, stride = stride_of(rows);
  for (std::size_t i = 0; i < rows; i += stride) {
    const double v = values[first + i * width];
    const double digit = v == 0 || !std::isfinite(v) ? 1 : std::pow(10.0, std::floor(std::log10(std::abs(v))) - 5);
    out.push_back(std::round(v / digit) * digit);  // JSON has no NaN: it becomes null
  }
  return out;
}

Json curve(const std::string& name, Json values) { return {{"name", name}, {"y", std::move(values)}}; }

/// One diagram: what stands on it, and its curves over one time.
Json plot(const std::string& title, const std::string& unit, Json time, Json curves) {
  return {{"title", title}, {"unit", unit}, {"t", std::move(time)}, {"curves", std::move(curves)}};
}

/// Rows with a column a name, as curves.
Json columns(const std::vector<double>& values, const std::vector<std::string>& names) {
  Json curves = Json::array();
  for (std::size_t k = 0; k < names.size(); ++k) curves.push_back(curve(names[k], thinned(values, k, names.size())));
  return curves;
}

const std::vector<std::string> kAxes{"x", "y", "z"};

/// Ground acceleration at its own samples, so that its peaks are there.
Json ground_plot(const cases::GroundMotion& motion, double from, double until) {
  double step = std::max(until - from, 1e-3);
  for (const cases::Accelerogram& a : motion.axis)
    if (a.dt > 0.0) step = std::min(step, a.dt);
  const auto intervals = static_cast<std::size_t>((until - from) / step + 1e-6);
  std::vector<double> time, value;
  for (std::size_t i = 0; i <= intervals; ++i) {
    time.push_back(from + static_cast<double>(i) * step);
    const Vec3 a = cases::acceleration_at(motion, time.back());
    value.insert(value.end(), {a.x, a.y, a.z});
  }
  return plot("Ground acceleration", "m/s²", thinned(time), columns(value, kAxes));
}

void add_histories(const Hdf5File& file, Json& plots) {
  const Json time = thinned(file.read<double>("/history/time"));
  for (const std::string& name : file.children("/history")) {
    const std::string group = "/history/" + name;
    if (!file.is_group(group)) continue;
    plots.push_back(plot("Displacement of " + name, "m", time, columns(file.read<double>(group + "/displacement"), kAxes)));
  }
}

/// Some columns of one table.
Json table_plot(const Hdf5File& file, const std::string& title, const std::string& unit, const std::string& table,
                const std::vector<std::string>& columns) {
  Json curves = Json::array();
  for (const std::string& c : columns) curves.push_back(curve(c, thinned(file.read<double>(table + "/" + c))));
  return plot(title, unit, thinned(file.read<double>(table + "/time")), std::move(curves));
}

/// Attributes that are there, as numbers.
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

void warn(const char* what, const std::exception& e) { std::fprintf(stderr, "warning: the page has no %s: %s\n", what, e.what()); }

/// The curves of the ground's motion. Its records may be gone: then the page has all but these.
void add_ground(const LoadedCase& c, const Hdf5File& file, Json& facts) {
  const auto times = file.read<double>("/history/time");
  if (!c.value.motion || times.empty()) return;
  try {
    facts["plots"].push_back(ground_plot(load_motion(*c.value.motion, c.value.folder), 0.0, times.back()));
  } catch (const std::exception& e) {
    warn("ground motion", e);
  }
}

/// How the building fell.
void add_measures(const Hdf5File& file, Json& facts) {
  try {
    const Measures m = measure(file);
    facts["measures"] = Json::parse(measures_json(m));
    const Json time = thinned(m.series.time);
    std::vector<std::string> walls;
    for (const WallMeasures& w : m.walls) walls.push_back(w.name);
    if (!walls.empty()) facts["plots"].push_back(plot("Out-of-plane drift", "", time, columns(m.series.drift, walls)));
    if (m.initial_free_volume > 0)
      facts["plots"].push_back(plot("Volume left under the roof", "of " + std::to_string(std::lround(m.initial_free_volume)) + " m³", time,
                                    columns(m.series.free_volume, {"free volume"})));
  } catch (const FileError& e) {
    warn("measures of the collapse", e);
  }
}

/// The case of the run, unless another version of the program wrote one that this does not know.
std::optional<LoadedCase> case_of(const Hdf5File& file) {
  try {
    return read_case({file.path(), file.attribute_text("/case", "toml")});
  } catch (const std::exception& e) {
    warn("ground motion", e);
    return {};
  }
}

/// "roof beam 11" is of the part "roof beam".
std::string part_of(const std::string& tag) {
  const std::size_t end = tag.find_last_not_of("0123456789 ");
  return end == std::string::npos ? tag : tag.substr(0, end + 1);
}

/// Parts of the building by number, in order of their first element.
std::vector<std::int32_t> number_parts(const Hdf5File& file, Json& facts) {
  std::map<std::string, std::int32_t> numbers;
  std::vector<std::int32_t> part;
  facts["parts"] = Json::array();
  for (const std::string& tag : file.read_strings("/model/element/tag")) {
    const auto [at, is_new] = numbers.emplace(part_of(tag), static_cast<std::int32_t>(numbers.size()));
    if (is_new) facts["parts"].push_back(at->first);
    part.push_back(at->second);
  }
  return part;
}

std::string script(const char* type, const std::string& id, const std::string& text) {
  return "<script type=\"" + std::string(type) + "\" id=\"" + id + "\">" + text + "</script>\n";
}

template <class T>
std::string packed_script(const std::string& id, const std::vector<T>& values) {
  return script("text/plain", id, packed(std::span<const T>(values)));
}

/// JSON that may stand inside a script element: nothing in it can end the element.
std::string safe_json(const Json& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

}  // namespace

std::string report_data(const std::string& run) {
  const Hdf5File file = Hdf5File::open(run);
  const FrameReader reader(file);
  const std::optional<LoadedCase> c = case_of(file);
  Json facts;
  facts["title"] = c ? c->value.title : std::filesystem::path(run).parent_path().filename().string();
  facts["plots"] = Json::array();
  if (c) add_ground(*c, file, facts);
  add_histories(file, facts["plots"]);
  facts["plots"].push_back(table_plot(file, "Segment sides by what opened them; those that have slipped and hold", "", "/damage",
                                      {"tension", "shear", "compression", "slipped"}));
  if (file.exists("/damage/first_shear"))
    facts["plots"].push_back(table_plot(file, "Segment sides by the limit they reached first", "", "/damage",
                                        {"first_tension", "first_shear", "first_compression"}));
  facts["plots"].push_back(table_plot(file, "Energy", "J", "/energy",
                                      {"input", "kinetic", "strain", "contact", "gravity", "dashpot", "friction", "fracture", "damping"}));
  facts["summary"] =
      numbers(file, "/summary",
              {"finished", "collapsed", "first_crack_time", "fallen_mass_fraction", "end_time", "tension", "shear", "compression",
               "slipped", "first_tension", "first_shear", "first_compression", "peak_base_shear", "peak_speed", "worst_residual"});
  add_measures(file, facts);
  facts["provenance"] = texts(file, "/provenance", {"version", "compiler", "cpu", "started", "ended"});
  facts["provenance"].update(numbers(file, "/provenance", {"threads", "wall_clock"}));
  facts["times"] = reader.times();
  facts["base"] = c && !c->value.base ? Json(nullptr) : Json(c ? c->value.base->z : 0.0);
  const std::vector<std::int32_t> part = number_parts(file, facts);
  const PackedFrames frames = pack_frames(reader);
  const CoveredFaces covered = covered_faces(file);
  const OpenedFaces opened = opened_faces(file);
  facts["quantum"] = frames.quantum;
  return script("application/json", "facts", safe_json(facts)) + packed_script("vertices", file.read<float>("/model/vertex")) +
         packed_script("cells", file.read<std::int32_t>("/model/cells")) +
         packed_script("cell-types", file.read<std::uint8_t>("/model/cell_type")) +
         packed_script("cell-elements", file.read<std::int32_t>("/model/cell_element")) +
         packed_script("centroids", file.read<float>("/model/element/position0")) + packed_script("parts", part) +
         packed_script("covered-elements", covered.element) + packed_script("covered-normals", covered.normal) +
         packed_script("opened-elements", opened.element) + packed_script("opened-normals", opened.normal) +
         packed_script("opened-times", opened.time) + script("text/plain", "frames", frames.text);
}

std::string report_html(const std::string& run) {
  const ReportPage page = report_page();
  return std::string(page.head) + report_data(run) + std::string(page.tail);
}

}  // namespace voussoir::io
