// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/debris/debris.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace voussoir::io {
namespace {

constexpr double kShare = 0.95;  // of the fallen mass
constexpr double kCell = 0.05;   // m: half the shortest edge of a brick
constexpr double kWide = 25.0;   // m: no unit of masonry is wider than twice this
constexpr double kFar = 1e15;    // cells, below which numbers are whole

/// Distance of a point from a rectangle in plan [m]; 0 inside.
double distance_from(const Box& box, Vec3 p) {
  return std::hypot(std::max({box.low[0] - p.x, 0.0, p.x - box.high[0]}), std::max({box.low[1] - p.y, 0.0, p.y - box.high[1]}));
}

void measure_reach(std::vector<std::pair<double, double>> distance_and_mass, Debris& debris) {
  std::ranges::sort(distance_and_mass);
  double all = 0.0, within = 0.0;
  for (const auto& [distance, mass] : distance_and_mass) all += mass;
  for (const auto& [distance, mass] : distance_and_mass) {
    if (within < kShare * all) debris.reach_95 = distance;
    within += mass;
    debris.reach = distance;
  }
}

using Cell = std::pair<std::int64_t, std::int64_t>;

/// Adds the cells covered by one element, within kWide of its centroid: a damaged file may have any shape at any place.
void cover(const ElementShapes& shapes, std::size_t element, const Pose& pose, std::vector<Cell>& cells) {
  const double r = std::min(shapes.radius(element), kWide);
  const auto number = [](double x) { return static_cast<std::int64_t>(std::clamp(std::floor(x / kCell), -kFar, kFar)); };
  const auto centre = [](std::int64_t i) { return (static_cast<double>(i) + 0.5) * kCell; };
  for (std::int64_t j = number(pose.centre.y - r); j <= number(pose.centre.y + r); ++j)
    for (std::int64_t i = number(pose.centre.x - r); i <= number(pose.centre.x + r); ++i)
      if (shapes.chord(element, pose, centre(i), centre(j))) cells.emplace_back(i, j);
}

}  // namespace

Debris debris_of(const Building& building, const ElementShapes& shapes, const std::vector<Pose>& poses,
                 const std::vector<std::uint8_t>& fallen) {
  std::vector<std::pair<double, double>> distance_and_mass;
  std::vector<Cell> cells;
  for (std::size_t e = 0; e < poses.size(); ++e) {
    if (fallen[e] == 0) continue;
    distance_and_mass.emplace_back(distance_from(building.footprint, poses[e].centre), building.mass[e]);
    cover(shapes, e, poses[e], cells);
  }
  Debris debris;
  measure_reach(std::move(distance_and_mass), debris);
  std::ranges::sort(cells);
  const auto twice = std::unique(cells.begin(), cells.end());
  debris.area = static_cast<double>(twice - cells.begin()) * kCell * kCell;
  return debris;
}

}  // namespace voussoir::io
