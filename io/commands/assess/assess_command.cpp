// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/assess/assess_command.h"

#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>

#include "io/assess/assess_words.h"
#include "io/assess/crack_map.h"
#include "io/files/errors.h"
#include "io/files/output_path.h"
#include "io/files/text_file.h"
#include "io/results/case_of_run.h"
#include "io/session/exit_code.h"
#include "io/session/session.h"

namespace voussoir::io {
namespace {

/// The name of a wall as that of a file: "front-wall". Letters of any alphabet stay, being bytes beyond ASCII.
std::string file_stem(std::string wall) {
  const auto stays = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.' || c > 127; };
  for (char& c : wall)
    if (!stays(static_cast<unsigned char>(c))) c = '-';
  if (wall.starts_with('.')) wall.front() = '_';  // else hidden, or the folder above
  return wall;
}

/// "front-wall-2.000s.svg" \param taken  stems of the maps so far
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
    write_text_file(file, crack_map(run, c.title, building, static_cast<std::int32_t>(w), a.time, a.joints, a.fallen), o.overwrite);
    std::fprintf(stderr, "voussoir: %s\n", file.c_str());
  }
}

}  // namespace

int assess_command(const AssessOptions& o) {
  const Hdf5File run = Hdf5File::open(std::filesystem::is_directory(o.folder) ? o.folder + "/run.h5" : o.folder);
  const cases::Case c = case_of_run(run);
  const Building building = building_of(run);
  if (!o.maps.empty() && building.walls.empty()) throw cases::InputError("--maps", "a model of free blocks has no walls to draw");
  check_output(o.spectra, o.overwrite);
  const Assessment a = assess(run, c, building, o.time, o.levels);
  const cases::GroundMotion base = base_of_run(run, c);
  const std::vector<FloorAcceleration> points = floor_accelerations(run, history_names(c), base);
  std::fputs((o.json ? assessment_json(a, points, base) : assessment_text(a, points, base)).c_str(), stdout);
  if (!o.maps.empty()) write_maps(run, c, building, a, o);
  if (!o.spectra.empty()) write_text_file(o.spectra, spectra_csv(points, base, o.damping), o.overwrite);
  return kDone;
}

}  // namespace voussoir::io
