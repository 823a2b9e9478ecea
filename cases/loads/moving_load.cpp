// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/moving_load.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cases/names.h"

namespace voussoir::cases {

namespace {

constexpr double kOfElement = 0.25;       // of the size of the smallest element: how far a load goes from one station to the next
constexpr double kMostStations = 1000.0;  // beside the rows of its file

/// Between two points of a path so many stations that none is farther from the next than `spacing`; the path itself is given by its rows.
SupportHistory with_stations(const SupportHistory& path, double spacing) {
  SupportHistory all;
  for (std::size_t k = 0; k < path.time.size(); ++k) {
    const Vec3 from = path.displacement[k > 0 ? k - 1 : 0], way = path.displacement[k] - from;
    const double count = k > 0 ? std::max(1.0, std::ceil(norm(way) / spacing)) : 1.0, t0 = path.time[k > 0 ? k - 1 : 0];
    for (double s = 1.0; s <= count; s += 1.0) {
      all.time.push_back(s < count ? t0 + (s / count) * (path.time[k] - t0) : path.time[k]);
      all.displacement.push_back(s < count ? from + (s / count) * way : path.displacement[k]);
    }
  }
  return all;
}

/// m, between stations: a part of the smallest element, but no more stations than kMostStations.
double station_spacing(const Model& model, const SupportHistory& path) {
  double least = std::numeric_limits<double>::infinity(), length = 0.0;
  for (const geometry::Element& e : model.assembly.elements) least = std::min(least, std::cbrt(e.mass.volume));
  for (std::size_t k = 1; k < path.displacement.size(); ++k) length += norm(path.displacement[k] - path.displacement[k - 1]);
  return std::max(kOfElement * least, length / kMostStations);
}

}  // namespace

std::vector<MovingShare> moving_shares(const Model& model, const Load& load, std::size_t index, const SupportHistory& path) {
  const SupportHistory at = with_stations(path, station_spacing(model, path));
  std::vector<MovingShare> shares;
  for (std::size_t k = 0; k < at.time.size(); ++k) {
    MovingShare m{share_met(model, load, at.displacement[k] - model.origin, indexed_key("load", index, "path")), {}};
    const auto row = [&](std::size_t i, Vec3 force) { m.force.time.push_back(at.time[i]), m.force.displacement.push_back(force); };
    if (k > 0) row(k - 1, {});
    row(k, load.force);
    if (k + 1 < at.time.size()) row(k + 1, {});
    shares.push_back(std::move(m));
  }
  return shares;
}

}  // namespace voussoir::cases
