// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/assess_words.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/message.h"
#include "geometry/nth.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/measures/point_accelerations.h"

namespace voussoir::io {
namespace {

using Json = nlohmann::ordered_json;

using geometry::printed;

constexpr std::size_t kShownCracks = 20;

/// Two decimals, without the sign of a zero.
std::string hundredths(double x) {
  const std::string text = printed("%.2f", x);
  return text == "-0.00" ? "0.00" : text;
}
std::string percent(double x) { return std::isnan(x) ? "-" : hundredths(100.0 * x) + " %"; }
std::string mm(double x) { return hundredths(1e3 * x); }

double peak(const cases::Accelerogram& a) {
  double most = 0;
  for (const double x : a.acceleration) most = std::max(most, std::abs(x));
  return most;
}

void put_cracks(std::string& out, const std::string& name, const CrackFigures& f, std::size_t width) {
  out += printed("%-*s %7zu %10s %10s %10s %10s\n", static_cast<int>(width), name.c_str(), f.joints, mm(f.largest).c_str(),
                 mm(f.mean).c_str(), mm(f.largest_opening).c_str(), mm(f.largest_sliding).c_str());
}

void put_seats(std::string& out, const Assessment& a) {
  if (std::ranges::none_of(a.walls, [](const WallAssessment& w) { return w.seats.joints > 0; })) return;
  out += printed("\n%-44s %7s %10s %10s %10s %10s\n", "slip of timber on walls [mm]", "joints", "largest", "mean", "opening", "sliding");
  for (const WallAssessment& w : a.walls)
    if (w.seats.joints > 0) put_cracks(out, w.name, w.seats, 44);
}

void put_walls(std::string& out, const Assessment& a) {
  if (a.walls.empty()) return;
  out += printed("\n%-44s %7s %10s %10s %10s %10s\n", "cracks [mm]", "joints", "largest", "mean", "opening", "sliding");
  for (const WallAssessment& w : a.walls) put_cracks(out, w.name, w.cracks, 44);
  for (const auto& [corner, figures] : a.corners)
    if (figures.joints > 0) put_cracks(out, "  " + nth(a.walls, corner.wall).name + ", " + corner.name, figures, 44);
  for (const WallAssessment& w : a.walls)
    if (w.parted > 0)
      out += printed("%-44s %7zu joints have parted by more than %.0f mm: no cracks any more\n", w.name.c_str(), w.parted,
                     1e3 * JointWidth::kWidestCrack);
  put_seats(out, a);
  out += printed("\n%-44s %10s %10s %10s %10s\n", "out of plane, over the thickness", "thickness", "now", "peak", "at");
  for (const WallAssessment& w : a.walls)
    out += printed("%-44s %8.2f m %10s %10s %8.2f s\n", w.name.c_str(), w.thickness, percent(w.out_of_plane_now).c_str(),
                   percent(w.out_of_plane.value).c_str(), w.out_of_plane.time);
}

/// Cracks of the walls, the widest first, each with its number on the maps.
void put_crack_list(std::string& out, const Assessment& a) {
  if (a.cracks.empty()) return;
  std::size_t width = 20;
  for (const WallAssessment& w : a.walls) width = std::max(width, w.name.size());
  const int wide = static_cast<int>(width);
  out += printed("\n%3s  %-*s %9s %9s %9s %9s %9s %9s  %s\n", "no.", wide, "cracks, widest first", "extent", "branches", "now [mm]", "most",
                 "at", "at end", "from the left, up");
  for (std::size_t i = 0; i < std::min(a.cracks.size(), kShownCracks); ++i) {
    const Crack& c = a.cracks[i];
    const std::string place =
        hundredths(c.along[0]) + "-" + hundredths(c.along[1]) + " m, " + hundredths(c.z[0]) + "-" + hundredths(c.z[1]) + " m";
    out += printed("%3zu  %-*s %7.2f m %7.2f m %9s %9s %7.2f s %9s  %s\n", i + 1, wide, nth(a.walls, c.wall).name.c_str(), c.extent(),
                   c.length, mm(c.width).c_str(), mm(c.peak).c_str(), c.peak_time, mm(c.at_end).c_str(), place.c_str());
  }
  if (a.cracks.size() > kShownCracks) out += printed("     and %zu more, all in --format json\n", a.cracks.size() - kShownCracks);
  out += "     a crack is a net of open joints that hang together: extent, from end to end; branches, the sum of their lengths\n";
}

void put_storeys(std::string& out, const Assessment& a) {
  if (a.storeys.empty()) return;
  const bool several = a.storeys.front().house != a.storeys.back().house;
  out += printed("\n%-44s %10s %10s %10s %10s\n", "storey drift, all walls together", "x, now", "y, now", "x, peak", "y, peak");
  for (const StoreyDrift& s : a.storeys) {
    const std::string name = (several ? printed("house %d, ", s.house) : "") + printed("%.2f to %.2f m", s.low, s.high);
    out += printed("%-44s %10s %10s %10s %10s\n", name.c_str(), percent(s.now[0]).c_str(), percent(s.now[1]).c_str(),
                   percent(s.peak[0].value).c_str(), percent(s.peak[1].value).c_str());
  }
}

void put_cuts(std::string& out, const Assessment& a) {
  if (a.cuts.empty()) return;
  out += printed("\n%-24s %13s %13s %13s %13s %13s\n", "cuts: most", "axial [kN]", "pressure", "shear", "moment [kNm]", "torsion");
  for (const CutAssessment& c : a.cuts)
    out += printed("%-24s %13.3f %13.3f %13.3f %13.3f %13.3f\n", c.name.c_str(), 1e-3 * c.axial.value, 1e-3 * c.compression.value,
                   1e-3 * c.shear.value, 1e-3 * c.bending.value, 1e-3 * c.torsion.value);
}

Json json_of(const Peak& p) { return {{"value", p.value}, {"time", p.time}}; }
Json json_of(const CrackFigures& f) {
  return {{"joints", f.joints},
          {"largest", f.largest},
          {"mean", f.mean},
          {"largest_opening", f.largest_opening},
          {"largest_sliding", f.largest_sliding}};
}

}  // namespace

std::string assessment_text(const Assessment& a, const std::vector<FloorAcceleration>& points, const cases::GroundMotion& base) {
  std::string out = printed("cracks and \"now\": at %.3f s\n", a.time);
  out += printed("weight                   %.1f kN\n", 1e-3 * a.weight);
  out += printed("base shear               %.1f kN at most, at %.2f s: %.3f of the weight\n", 1e-3 * a.base_shear.value, a.base_shear.time,
                 a.base_shear_over_weight);
  put_walls(out, a);
  put_crack_list(out, a);
  put_storeys(out, a);
  put_cuts(out, a);
  if (points.empty()) return out;
  const bool low_passed = points.front().low_passed;  // all have the same rows
  out += printed("\n%-24s %13s %13s %13s %13s\n", "acceleration [m/s2]", "x", "y", "z", "horizontal");
  out += printed("%-24s %13.2f %13.2f %13.2f %13s\n", "base, within the run", peak(base.axis[0]), peak(base.axis[1]), peak(base.axis[2]), "");
  for (const FloorAcceleration& p : points)
    out += printed("%-24s %13.2f %13.2f %13.2f %13.2f\n", p.name.c_str(), p.peak[0], p.peak[1], p.peak[2], p.peak_horizontal);
  return out + (low_passed ? printed("points: below %.0f Hz, as in summary; spectra (--spectra) are not filtered\n", kInstrumentCorner)
                           : "points: not filtered, since rows of /history are too far apart for that\n");
}

std::string assessment_json(const Assessment& a, const std::vector<FloorAcceleration>& points, const cases::GroundMotion& base,
                            const std::optional<Capacity>& capacity) {
  Json out{
      {"time", a.time}, {"weight", a.weight}, {"base_shear", json_of(a.base_shear)}, {"base_shear_over_weight", a.base_shear_over_weight}};
  for (const char* list : {"walls", "corners", "cracks", "storeys", "cuts", "points"}) out[list] = Json::array();
  for (const WallAssessment& w : a.walls)
    out["walls"].push_back({{"name", w.name},
                            {"thickness", w.thickness},
                            {"out_of_plane", json_of(w.out_of_plane)},
                            {"out_of_plane_now", w.out_of_plane_now},
                            {"cracks", json_of(w.cracks)},
                            {"parted_joints", w.parted},
                            {"timber_slip", json_of(w.seats)}});
  for (const auto& [c, f] : a.corners)
    out["corners"].push_back(
        {{"wall", nth(a.walls, c.wall).name}, {"name", c.name}, {"along", c.along}, {"z", c.z}, {"cracks", json_of(f)}});
  for (const Crack& c : a.cracks)
    out["cracks"].push_back({{"wall", nth(a.walls, c.wall).name},
                             {"length", c.length},
                             {"extent", c.extent()},
                             {"width", c.width},
                             {"peak", c.peak},
                             {"peak_time", c.peak_time},
                             {"at_end", c.at_end},
                             {"along", c.along},
                             {"z", c.z},
                             {"joints", c.joints.size()}});
  for (const StoreyDrift& s : a.storeys)
    out["storeys"].push_back({{"house", s.house},
                              {"low", s.low},
                              {"high", s.high},
                              {"x", json_of(s.peak[0])},
                              {"y", json_of(s.peak[1])},
                              {"x_now", s.now[0]},
                              {"y_now", s.now[1]}});
  for (const CutAssessment& c : a.cuts)
    out["cuts"].push_back({{"name", c.name},
                           {"normal", {c.normal.x, c.normal.y, c.normal.z}},
                           {"axial", json_of(c.axial)},
                           {"compression", json_of(c.compression)},
                           {"shear", json_of(c.shear)},
                           {"bending", json_of(c.bending)},
                           {"torsion", json_of(c.torsion)}});
  const auto peaks = [](const auto& axis) { return Json{peak(axis[0]), peak(axis[1]), peak(axis[2])}; };
  out["base_acceleration"] = peaks(base.axis);
  for (const FloorAcceleration& p : points)
    out["points"].push_back({{"name", p.name},
                             {"acceleration", p.peak},
                             {"horizontal", p.peak_horizontal},
                             {"low_pass", p.low_passed ? Json(kInstrumentCorner) : Json(nullptr)}});
  if (capacity) out["capacity"] = Json::parse(capacity_json(*capacity, false));
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace voussoir::io
