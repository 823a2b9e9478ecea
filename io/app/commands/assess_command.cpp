// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0

#include <CLI/CLI.hpp>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>

#include "cases/case.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/commands/words/number_range.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/process.h"
#include "io/app/session/session.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/messages/messages.h"
#include "io/output/assess/assess_words.h"
#include "io/output/assess/crack_map.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/measures/members/load_measures.h"
#include "io/output/measures/members/member_words.h"
#include "io/output/replay/run_file.h"
#include "io/output/replay/run_state.h"
#include "io/output/results/case_of_run.h"

namespace voussoir::io {
namespace {

struct AssessOptions {
  std::string folder;                 // of the run
  std::optional<double> time;         // s, of cracks and current values; none: the last frame
  std::vector<double> levels;         // m, of storeys, as Building::height_of; none: foot and top of the walls
  std::vector<double> damping{0.05};  // of the spectra
  std::string maps, spectra;          // folder for crack maps; CSV file for spectra; empty: none
  std::string demand;                 // spectrum to compare the capacity of a pushover with; empty: that of the case
  double demand_damping = 0.05;       // of critical
  std::optional<double> corner;       // s, T_C of a demand that does not state it
  std::optional<std::string> unit;    // of a file of the demand
  bool json = false, overwrite = false;
};

/// A wall's name for use in a file name: "front-wall". Letters of any alphabet are kept, as bytes beyond ASCII.
std::string file_stem(std::string wall) {
  const auto stays = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.' || c > 127; };
  for (char& c : wall)
    if (!stays(static_cast<unsigned char>(c))) c = '-';
  if (wall.starts_with('.')) wall.front() = '_';  // the file would be hidden, or the parent folder
  return wall;
}

/// File name of a map: "front-wall-2.000s.svg" \param taken  names used so far
std::string map_name(const std::string& wall, double time, std::set<std::string>& taken) {
  std::string stem = file_stem(wall);
  while (!taken.insert(stem).second) stem += '_';
  std::array<char, 32> at{};
  std::snprintf(at.data(), at.size(), "-%.3fs.svg", time);
  return stem + at.data();
}

void write_maps(const Hdf5File& run, const cases::Case& c, const Building& building, const Assessment& a, const AssessOptions& o) {
  std::error_code error;
  std::filesystem::create_directories(o.maps, error);
  if (error) throw FileError(o.maps, "cannot make the folder: " + error.message());
  std::set<std::string> taken;
  for (std::size_t w = 0; w < building.walls.size(); ++w) {
    const std::string file = o.maps + "/" + map_name(building.walls[w].name, a.time, taken);
    write_output({file, FileKind::drawing, "--maps", o.overwrite},
                 crack_map(run, c.title, building, static_cast<std::int32_t>(w), a.time, a.joints, a.fallen, a.cracks));
    say_info(file);
  }
}

/// The capacity of the run, if it is a quasi-static analysis, against the demand that is asked for, or that of its case. \throw
/// cases::InputError, FileError
std::optional<Capacity> capacity_asked(const Hdf5File& run, const AssessOptions& o) {
  if (o.demand.empty() && (o.corner || o.unit))
    throw cases::InputError("--demand", "is missing: --corner-period and --unit are of its file");
  if (o.demand.empty()) return capacity_of(run);
  return capacity_under(run, read_demand(o.demand, o.demand_damping, o.corner, o.unit, "--demand"), "--demand");
}

/// Prints engineering figures of a run (io/MEASURES.md), writes crack maps of its walls and floor response spectra. \throw
/// cases::InputError, FileError
int assess(const AssessOptions& o) {
  now_doing("reading the results");
  std::filesystem::is_directory(o.folder) ? note_run(o.folder) : note_input(o.folder);
  if (const std::string file = demand_file(o.demand); !file.empty()) note_input(file);
  const Hdf5File run = open_run(o.folder);
  note_state(run);
  const cases::Case c = case_of_run(run);
  const Building building = building_of(run);
  if (!o.maps.empty() && building.walls.empty()) throw cases::InputError("--maps", "a model of free blocks has no walls to draw");
  const Output spectra{o.spectra, FileKind::table, "--spectra", o.overwrite};
  check_output(spectra);
  const std::optional<Capacity> capacity = capacity_asked(run, o);
  const Assessment a = assess(run, c, building, o.time, o.levels);
  const cases::GroundMotion base = base_of_run(run, c);
  const std::vector<FloorAcceleration> points = floor_accelerations(run, history_names(c), base);
  const auto shaken = capacity ? std::vector<FloorAcceleration>() : points;  // an analysis leaves the motion out
  std::fputs((o.json ? assessment_json(a, points, base, capacity) : assessment_text(a, shaken, base)).c_str(), stdout);
  if (capacity && !o.json) std::fputs(("\ncapacity\n" + capacity_text(*capacity)).c_str(), stdout);
  if (!o.json) std::fputs(loads_text(load_measures(run)).c_str(), stdout);
  std::fflush(stdout);  // before names of maps, on standard error: both may go to one file
  if (!o.maps.empty()) write_maps(run, c, building, a, o);
  if (!o.spectra.empty()) write_output(spectra, spectra_csv(points, base, o.damping));
  return kDone;
}

}  // namespace

Command add_assess(CLI::App& program) {
  CLI::App* words =
      program.add_subcommand("assess",
                             "crack widths and crack maps, storey drift, forces through cuts, floor spectra of a run; demand over "
                             "capacity of a pushover");
  auto o = std::make_shared<AssessOptions>();
  words->add_option("DIR", o->folder, "folder of the run, finished or not")->required();
  words->add_option("--time", o->time, "s, of cracks: the frame nearest to it (default: the last)")->check(number_range(-1e9, 1e9));
  words
      ->add_option("--levels", o->levels,
                   "heights of storeys above the base (without one, z of the case), m: Z,Z,... (default: those of the house)")
      ->delimiter(',')
      ->check(number_range(-1e7, 1e7));
  words->add_option("--maps", o->maps, "write a crack map of every wall into this folder, as SVG");
  words->add_option("--spectra", o->spectra, "write response spectra of the followed points and of the base to this CSV file");
  words->add_option("--damping", o->damping, "damping ratios of the spectra (default 0.05)")
      ->delimiter(',')
      ->check(number_range(0.0, 0.99));
  words->add_option(
      "--demand", o->demand,
      "of a pushover: spectrum to compare its capacity with (default: analysis.demand): ec8:TYPE:GROUND:AG, record:FILE, or a "
      "file of periods and accelerations");
  words->add_option("--demand-damping", o->demand_damping, "of critical, of --demand (default 0.05)")->check(number_range(0.0, 0.5));
  words->add_option("--corner-period", o->corner, "s, end of the plateau of a --demand that is a file or record (T_C)")
      ->check(number_range(1e-3, 100.0));
  words->add_option("--unit", o->unit, "of acceleration in a file of --demand that does not state it: g, m/s2, cm/s2");
  add_format(*words, o->json);
  words->add_flag("--overwrite", o->overwrite, "replace existing files");
  words->footer("example: voussoir assess results/flat20n --time 2 --maps results/flat20n/cracks");
  return {.words = words, .work = [o] { return assess(*o); }};
}

}  // namespace voussoir::io
