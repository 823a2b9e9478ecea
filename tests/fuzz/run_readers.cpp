// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/run_readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "cases/case.h"
#include "io/input/files/errors.h"
#include "io/output/assess/assess_words.h"
#include "io/output/assess/crack_map.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/measures/compared_measures.h"
#include "io/output/measures/measures_file.h"
#include "io/output/measures/members/load_measures.h"
#include "io/output/measures/members/member_words.h"
#include "io/output/measures/place_in_run.h"
#include "io/output/replay/run_file.h"
#include "io/output/replay/run_state.h"
#include "io/output/report/pictures/plain/plain_scene.h"
#include "io/output/report/report_data.h"
#include "io/output/results/case_of_run.h"
#include "io/output/results/comparison.h"
#include "io/output/results/results_parts.h"
#include "solver/analysis/modes.h"
#include "tests/fuzz/run_image.h"

namespace voussoir::fuzz {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Of EN 1998-1, weak and strong; tables without T_C, of which one covers few periods, the other those of no building.
const std::vector<io::DemandSpectrum>& demands() {
  static const std::vector<io::DemandSpectrum> all = [] {
    const auto table = [](std::vector<double> periods, std::vector<double> accelerations) {
      io::DemandSpectrum d;
      d.target.period = std::move(periods), d.target.acceleration = std::move(accelerations);
      d.corner = std::nan(""), d.name = "table";
      return d;
    };
    const auto eurocode = [](const char* words) { return io::read_demand(words, 0.05, {}, {}, "--demand"); };
    return std::vector{eurocode("ec8:1:B:0.25g"), eurocode("ec8:2:D:0.9g"), table({0.0, 0.05, 0.3}, {10.0, 20.0, 5.0}),
                       table({9.0, 10.0}, {1.0, 1.0})};
  }();
  return all;
}

/// What `voussoir limit CASE --format json` would have written beside the run, with edits.
std::string limit_text(const io::Hdf5File& run, std::span<const std::uint8_t> edits) {
  const cases::Case c = io::case_of_run(run);
  const double length = std::hypot(c.analysis.direction[0], c.analysis.direction[1]);
  std::string text = dumped({{"title", c.title},
                             {"direction", {c.analysis.direction[0] / length, c.analysis.direction[1] / length, 0.0}},
                             {"cone_error", 0.076},
                             {"mortar_joints", 7U},
                             {"converged", true},
                             {"associated", {{"multiplier", 0.21}}},
                             {"coulomb", {{"multiplier", 0.19}}}});
  for (; edits.size() >= kEdit; edits = edits.subspan(kEdit)) {
    const std::size_t at = (edits[3] + 256U * edits[4]) % (text.size() + 1);
    const std::span value = edits.subspan(6, 8);
    const std::string put(value.begin(), std::ranges::find(value, 0));
    text.replace(at, std::min<std::size_t>(edits[0] % 32U, text.size() - at), put);
  }
  return text;
}

/// Which rows a run has, by what is in its file.
io::RowSchema schema_of(const io::Hdf5File& run) {
  const auto names = [&](const std::string& group) {
    std::vector<std::string> groups;
    if (!run.exists(group)) return groups;
    for (const std::string& name : run.children(group))
      if (run.is_group(group + "/" + name)) groups.push_back(name);
    return groups;
  };
  const auto columns = [&](const char* dataset) { return run.exists(dataset) ? run.shape(dataset).at(1) : 0; };
  return io::row_schema(names("/history"), run.shape("/model/element/mass").at(0), names("/cuts"), columns("/ties/force"),
                        columns("/meshes/force"), columns("/loaded/force"));
}

}  // namespace

std::string summary(const io::Hdf5File& run) {
  Json out{{"state", io::name_of(io::run_state(run).end)}};
  if (const std::vector<std::string> missing = io::missing_parts(run); !missing.empty()) {
    out["elements"] = run.shape("/model/element/mass").at(0);
    for (const char* name : {"rows_history", "rows_energy", "rows_frames"}) out[name] = run.attribute_int("/", name);
    out["time_last"] = run.attribute_double("/", "time_last");
    out["missing_parts"] = missing;
    return dumped(out);
  }
  const io::Measures m = io::measure(run);
  const auto capacity = io::capacity_of(run);
  out.update(Json::parse(io::measures_json(m)));
  if (capacity) out["capacity"] = Json::parse(io::capacity_json(*capacity, true)), io::capacity_text(*capacity);
  out["tables"] = io::storeys_text(m) + io::ties_text(m) + io::loads_text(m.loads);
  if (!m.series.time.empty()) {
    const cases::Case c = io::case_of_run(run);
    out["stage"] = io::stage_at(c, m.series.time.back()), out["place"] = io::place_in_run(c, m.series.time.back());
  }
  return dumped(out);
}

void assess(const io::Hdf5File& run) {
  io::note_state(run);
  const cases::Case c = io::case_of_run(run);
  const io::Building building = io::building_of(run);
  const io::Assessment a = io::assess(run, c, building, std::nullopt, {});
  const cases::GroundMotion base = io::base_of_run(run, c);
  std::vector<std::string> names;
  for (const cases::HistoryPoint& h : c.output.history) names.push_back(h.name);
  const auto points = io::floor_accelerations(run, names, base);
  if (Json::parse(io::assessment_json(a, points, base)).empty()) std::abort();
  io::assessment_text(a, points, base);
  io::loads_text(io::load_measures(run));
  for (std::size_t w = 0; w < building.walls.size(); ++w)
    io::crack_map(run, c.title, building, static_cast<std::int32_t>(w), a.time, a.joints, a.fallen, a.cracks);
  constexpr std::size_t kMostRows = 1000;  // spectra take long
  if (!points.empty() && points.front().axis[0].acceleration.size() <= kMostRows) io::spectra_csv({points.front()}, base, {0.05});
  if (a.time > 0.0) io::assess(run, c, building, 0.5 * a.time, {0.1, 0.2});
}

void assess_demand(const io::Hdf5File& run, std::size_t which) {
  for (std::size_t i = 0; i < demands().size(); ++i) {
    if (which != 0 && which % demands().size() != i) continue;
    const auto capacity = io::capacity_under(run, demands()[i], "--demand");
    io::capacity_text(*capacity), io::capacity_json(*capacity, true);
  }
}

void report(const std::string& run, std::size_t modes) {
  const solver::Mode mode{1.0, {0.5, 0.5, 0.0}, std::vector<Vec3>(modes, {1.0, 0.0, 0.0}), std::vector<Vec3>(modes)};
  io::report_html({run}, {mode});
  const io::Hdf5File file = io::open_run(run);
  io::PlainScene(file).picture("corner", 0.1, 16, 10);
}

void report_with_limit(const std::string& run, std::span<const std::uint8_t> edits) {
  const std::filesystem::path limit = std::filesystem::path(run).parent_path() / "limit.json";
  {
    std::ofstream out(limit, std::ios::binary);
    out << limit_text(io::open_run(run), edits);
  }
  const struct Away {
    const std::filesystem::path& path;
    ~Away() {
      std::error_code ignored;
      std::filesystem::remove(path, ignored);
    }
  } away{limit};
  io::live_html(run, 5.0);
}

void compare(const std::string& run, const std::string& good, const std::string& summary_of_good) {
  io::compare_files(run, good);
  const std::string found = summary(io::open_run(run));
  io::measures_beside(found, summary_of_good), io::measures_beside_json(found, summary_of_good);
}

void go_on(const std::filesystem::path& folder, const std::string& good, std::size_t when) {
  const std::filesystem::path copy = folder.string() + "-gone-on";
  const struct Away {
    const std::filesystem::path& path;
    ~Away() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  } away{copy};
  std::filesystem::copy(folder, copy, std::filesystem::copy_options::recursive);
  const io::Hdf5File run = io::open_run(good);
  const io::RowSchema schema = schema_of(run);
  constexpr std::array kUntil{1e9, 0.5, 0.0};  // s
  io::EarlierRows earlier{kUntil.at(when % kUntil.size()), std::nullopt};
  const std::vector<io::Part> parts = io::keep_parts(copy, schema, earlier);
  io::remove_parts(copy, parts);
  earlier.rows = io::rows_of(parts);
  try {  // as after a kill before anything else was written
    if (io::keep_parts(copy, schema, earlier).size() != parts.size()) std::abort();
  } catch (const io::FileError&) {
    std::abort();
  }
}

}  // namespace voussoir::fuzz
