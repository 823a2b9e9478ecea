// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_bodies.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/output/measures/capacity/capacity.h"
#include "io/output/measures/debris/bodies.h"
#include "io/output/replay/collapse_parts.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/report/report_facts.h"

namespace voussoir::io {

ReportBodies report_bodies(const Hdf5File& run, const FrameReader& frames) {
  const Building building = building_of(run);
  BodyFinder finder(run, building, first_poses(frames));
  if (const auto c = capacity_figures(run); c && has_peak(*c) && frames.frames() > 0) {
    CollapseParts parts = collapse_parts(run, frames, building.mass, c->multiplier_time);
    finder.take(std::move(parts.part), frames.times()[parts.from]);
  }
  nlohmann::json out{{"names", nlohmann::json::array()}, {"bodies", nlohmann::json::array()}, {"hinges", nlohmann::json::array()}};
  std::map<std::string, std::size_t> names;
  ReportBodies result;
  for (std::uint64_t f = 0; f < frames.frames(); ++f) {
    const BodiesInFrame found = finder.find(frames.times()[f], poses_of(frames, f));
    result.id.insert(result.id.end(), found.id.begin(), found.id.end());
    nlohmann::json &bodies = out["bodies"].emplace_back(nlohmann::json::array()),
                   &hinges = out["hinges"].emplace_back(nlohmann::json::array());
    for (const Body& b : found.bodies) {
      const auto [name, is_new] = names.emplace(body_name(b, building), names.size());
      if (is_new) out["names"].push_back(name->first);
      bodies.push_back({b.id, name->second});
    }
    for (const Hinge& h : found.hinges) {
      nlohmann::json& line = hinges.emplace_back(nlohmann::json::array());
      for (const Vec3& p : {h.from, h.to})
        for (const double x : {p.x, p.y, p.z}) line.push_back(std::round(1000 * x) / 1000);
      for (const auto& end : {h.at_from, h.at_to})
        for (const std::int32_t e : end) line.push_back(e);
      line.push_back(h.slides ? 1 : 0);
    }
  }
  result.json = safe_json(out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  return result;
}

}  // namespace voussoir::io
