// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/damage/report_cracks.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "cases/case.h"
#include "geometry/nth.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/assess/assessment.h"
#include "io/output/assess/crack_map.h"
#include "io/output/replay/frame_reader.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kListed = 15;  // cracks in the table
constexpr std::size_t kMaps = 12;    // crack maps in the page

double rounded_mm(double metres) { return std::round(1e5 * metres) / 100; }

}  // namespace

std::string report_cracks(const Hdf5File& run, const cases::Case& c, const FrameReader& frames) {
  if (frames.frames() == 0) return {};
  const Building building = building_of(run);
  if (building.walls.empty()) return {};
  const Assessment a = assess(run, c, building, {}, {});
  const std::vector<Crack> listed(a.cracks.begin(), a.cracks.begin() + static_cast<std::ptrdiff_t>(std::min(kListed, a.cracks.size())));
  const std::vector<std::vector<double>> widths = widths_over_time(run, frames, listed);
  Json out{{"time", a.time}, {"more", a.cracks.size() - listed.size()}, {"cracks", Json::array()}, {"maps", Json::array()}};
  std::set<std::int32_t> mapped;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const Crack& crack = listed[i];
    Json of_frames = Json::array();
    for (const std::vector<double>& row : widths) of_frames.push_back(rounded_mm(row[i]));
    out["cracks"].push_back({{"wall", nth(building.walls, crack.wall).name},
                             {"length", crack.length},
                             {"extent", crack.extent()},
                             {"peak", crack.peak},
                             {"peak_time", crack.peak_time},
                             {"at_end", crack.at_end},
                             {"along", crack.along},
                             {"z", crack.z},
                             {"widths", std::move(of_frames)}});
    if (mapped.size() >= kMaps || !mapped.insert(crack.wall).second) continue;
    out["maps"].push_back({{"wall", nth(building.walls, crack.wall).name},
                           {"svg", crack_map(run, c.title, building, crack.wall, a.time, a.joints, a.fallen, a.cracks)}});
  }
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace voussoir::io
