// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/report_members.h"

#include <algorithm>
#include <cmath>

#include "io/input/files/hdf5_file.h"
#include "io/output/report/damage/worst_moment.h"

namespace voussoir::io {

using namespace page;

namespace {

constexpr std::size_t kMostTies = 6;   // curves in one plot
constexpr std::size_t kMostLoads = 6;  // plots
constexpr double kSteady = 1e-6;       // of the largest force: a force that changes by less is a dead load

bool changes(const LoadCurve& c) {
  const auto [low, high] = std::ranges::minmax_element(c.force);
  return *high - *low > kSteady * std::max(std::abs(*high), std::abs(*low));
}

}  // namespace

/// Adds a plot of the ties with the largest forces.
void add_ties(const Hdf5File& file, std::vector<Plot>& plots) {
  if (!file.exists("/ties/force")) return;
  const std::vector<std::string> names = file.read_strings("/model/tie");
  const std::vector<double> time = file.read<double>("/history/time"), force = file.read<double>("/ties/force");
  if (time.empty() || force.size() != names.size() * time.size()) return;
  std::vector<double> most(names.size(), 0.0);
  for (std::size_t i = 0; i < force.size(); ++i) most[i % names.size()] = std::max(most[i % names.size()], std::abs(force[i]));
  std::vector<std::size_t> order(names.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return most[a] > most[b]; });
  order.resize(std::min(order.size(), kMostTies));
  std::ranges::sort(order);
  std::vector<Curve> curves;
  for (const std::size_t k : order) curves.push_back({names[k], thinned(force, k, names.size(), 1e-3)});
  plots.push_back(
      {order.size() < names.size() ? "Force of the ties that bear most" : "Force of ties", "kN", thinned(time), std::move(curves)});
}

/// Adds the plot of storey drifts, and of decks and meshes.
void add_members(const Hdf5File& file, const Measures& m, const std::vector<std::string>& walls, std::vector<Plot>& plots) {
  if (!walls.empty()) {
    plots.push_back({"Storey drift along the walls", "%", thinned(m.series.time), columns(m.series.storey_drift, walls, 100)});
    plots.back().clip = 100 * kWildDrift;
  }
  if (m.peak_seat_slip > 0)
    plots.push_back({"Slip of beams on walls, the largest", "mm", thinned(m.series.time), columns(m.series.seat_slip, {"slip"}, 1000)});
  if (!file.exists("/meshes/utilisation")) return;
  const std::vector<std::string> names = file.read_strings("/model/mesh");
  const auto time = file.read<double>("/history/time"), used = file.read<double>("/meshes/utilisation");
  if (!time.empty())
    plots.push_back({"Decks and meshes: force over strength of the bar that bears most", "%", thinned(time), columns(used, names, 100)});
}

void add_loads(const Hdf5File& file, std::vector<Plot>& plots) {
  std::vector<Curve> steady;
  Values time;
  std::size_t shown = 0;
  for (const LoadCurve& c : load_curves(file)) {
    if (shown + steady.size() >= kMostLoads) break;
    if (!changes(c)) {
      time = thinned(c.time), steady.push_back({c.name, thinned(c.displacement, 0, 1, 1000)});
      continue;
    }
    ++shown;
    const std::vector<std::size_t> rows = shown_rows(c.displacement);
    Plot p{"Force of " + c.name + " over displacement of its place", "kN", picked(c.time, rows), {{c.name, picked(c.force, rows, 1e-3)}}};
    p.x = Axis{"along the force, " + c.place, "mm", picked(c.displacement, rows, 1e3)};
    plots.push_back(std::move(p));
  }
  if (!steady.empty()) plots.push_back({"Displacement of loaded places, along the force", "mm", time, std::move(steady)});
}

}  // namespace voussoir::io
