// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/equivalent_system.h"

#include <algorithm>
#include <cmath>

#include "io/output/measures/building/building.h"
#include "io/output/replay/frame_reader.h"

namespace voussoir::io {
namespace {

constexpr double kShapeShare = 0.15;  // of the largest base shear: as of the first stiffness
constexpr double kShown = 2.0;        // times the largest displacement: how far the spectrum is shown
constexpr double kMostItalian = 4.0;  // of q*, for the collapse limit state: Circolare 7/2019, C8.7.1.3.1

/// The control displacement at a time, linear between the rows.
double control_at(const CapacityCurve& r, double time) {
  const auto after = static_cast<std::size_t>(std::ranges::lower_bound(r.time, time) - r.time.begin());
  if (after >= r.time.size()) return r.displacement.back();
  if (after == 0 || r.time[after] == time) return r.displacement[after];
  const double part = (time - r.time[after - 1]) / (r.time[after] - r.time[after - 1]);
  return r.displacement[after - 1] + part * (r.displacement[after] - r.displacement[after - 1]);
}

EquivalentSystem system_of(const Hdf5File& run, const std::array<double, 2>& direction, const Capacity& c) {
  const FrameReader frames(run);
  if (frames.frames() == 0) return {};
  const CapacityCurve& r = c.curve;
  const auto row = std::ranges::find_if(r.base_shear, [&](double v) { return v >= kShapeShare * c.peak_shear; }) - r.base_shear.begin();
  const auto& times = frames.times();
  const auto next = std::ranges::lower_bound(times, r.time[static_cast<std::size_t>(row)]) - times.begin();
  const std::uint64_t frame = std::min(static_cast<std::uint64_t>(next), frames.frames() - 1);
  const std::vector<double> at_first = frames.displacement(0), then = frames.displacement(frame);
  const double length = std::hypot(direction[0], direction[1]);
  const std::vector<double> mass = building_of(run).mass;
  std::vector<double> along(mass.size());
  for (std::size_t i = 0; i < mass.size(); ++i)
    along[i] = ((then[3 * i] - at_first[3 * i]) * direction[0] + (then[3 * i + 1] - at_first[3 * i + 1]) * direction[1]) / length;
  return equivalent_system(mass, along, control_at(r, times[frame]));
}

}  // namespace

void look_at_demand(const EquivalentSystem& system, const DemandSpectrum& demand, Capacity& c) {
  Performance p;
  p.spectrum = demand.name, p.damping = demand.damping, p.corner = demand.corner;
  p.system = system;
  p.near_collapse = c.near_collapse;
  p.end = *std::ranges::max_element(c.curve.displacement);
  p.points.push_back(n2_point("n2_ec8", "N2, EC 8", c.ec8, system, demand, Bilinear::kNone));
  p.points.push_back(n2_point("n2_ntc", "N2, NTC 2018", c.ntc, system, demand, kMostItalian));
  p.points.push_back(capacity_spectrum_point(c.curve, c.first_stiffness, system, demand));
  for (PerformancePoint& point : p.points) {
    compare_with_capacity(point, c.near_collapse, c.peak_displacement, p.end);
    doubt_shape(point, system);
  }
  double until = p.end / system.participation;
  for (const PerformancePoint& point : p.points) until = std::max(until, std::isnan(point.target_star) ? 0.0 : point.target_star);
  p.curve = spectrum_curve(demand, kShown * until);
  c.performance = std::move(p);
}

void look_at_demand(const Hdf5File& run, const std::array<double, 2>& direction, const DemandSpectrum& demand, Capacity& c) {
  if (std::isnan(c.first_stiffness)) return;
  look_at_demand(system_of(run, direction, c), demand, c);
}

}  // namespace voussoir::io
