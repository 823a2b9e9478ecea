// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/collapse_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "io/errors.h"
#include "io/frame_reader.h"
#include "io/hdf5_file.h"
#include "solver/collapse.h"

namespace voussoir::io {
namespace {

constexpr double kShare = 0.95;  // of the fallen mass

/// A rectangle along x and y, m.
struct Footprint {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;

  void include(double x, double y) {
    x0 = std::min(x0, x), x1 = std::max(x1, x);
    y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
  /// From the rectangle; 0 inside.
  [[nodiscard]] double distance(double x, double y) const {
    return std::hypot(std::max({x0 - x, 0.0, x - x1}), std::max({y0 - y, 0.0, y - y1}));
  }
};

Footprint footprint_of(const Hdf5File& run, std::size_t elements) {
  const auto house = run.read<std::int32_t>("/model/element/house"), first = run.read<std::int32_t>("/model/element/first_vertex");
  const auto fixed = run.read<std::uint8_t>("/model/element/fixed");
  const auto vertex = run.read<double>("/model/vertex");
  if (house.size() != elements || first.size() != elements || fixed.size() != elements)
    throw FileError(run.path(), "/model/element does not fit together");
  const bool any_house = std::ranges::any_of(house, [](std::int32_t h) { return h >= 0; });
  Footprint f;
  std::size_t e = 0;
  for (std::size_t v = 0; v < vertex.size() / 3; ++v) {
    while (e + 1 < elements && static_cast<std::int64_t>(v) >= first[e + 1]) ++e;
    if (any_house ? house[e] >= 0 : fixed[e] == 0) f.include(vertex[3 * v], vertex[3 * v + 1]);
  }
  return f;
}

std::optional<double> time_of_collapse(const Hdf5File& run, const FrameReader& frames, const std::vector<double>& mass, double base) {
  if (!run.exists("/model/element/kind")) return {};
  const auto kind = run.read<std::uint8_t>("/model/element/kind");
  if (kind.size() != frames.elements()) throw FileError(run.path(), "/model/element does not fit together");
  for (std::uint64_t f = 0; f < frames.frames(); ++f) {
    const std::vector<double> u = frames.displacement(f);
    solver::FallenMass fallen;
    for (std::size_t e = 0; e < kind.size(); ++e)
      fallen.add(static_cast<cases::PartKind>(kind[e]), mass[e], -u[3 * e + 2], frames.start()[3 * e + 2] - base);
    if (fallen.is_collapse()) return frames.times()[f];
  }
  return {};
}

void measure_reach(const Hdf5File& run, const FrameReader& frames, const std::vector<double>& mass, double base, CollapseFacts& facts) {
  const Footprint footprint = footprint_of(run, frames.elements());
  const std::vector<double> at = frames.row("position", frames.frames() - 1, 3);
  std::vector<std::pair<double, double>> fallen;  // distance and mass
  double all = 0.0, within = 0.0;
  for (std::size_t e = 0; e < frames.elements(); ++e) {
    const double height = frames.start()[3 * e + 2];
    if (!solver::FallenMass::has_fallen(height - at[3 * e + 2], height - base)) continue;
    fallen.emplace_back(footprint.distance(at[3 * e], at[3 * e + 1]), mass[e]);
    all += mass[e];
  }
  std::ranges::sort(fallen);
  for (const auto& [distance, m] : fallen) {
    if (within < kShare * all) facts.reach_95 = distance;
    within += m;
    facts.reach = distance;
  }
}

}  // namespace

CollapseFacts collapse_facts(const Hdf5File& run, const FrameReader& frames, double base) {
  CollapseFacts facts;
  if (frames.frames() == 0) return facts;
  const auto mass = run.read<double>("/model/element/mass");
  if (mass.size() != frames.elements()) throw FileError(run.path(), "/model/element does not fit together");
  facts.time = time_of_collapse(run, frames, mass, base);
  measure_reach(run, frames, mass, base, facts);
  return facts;
}

}  // namespace voussoir::io
