// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/damage/worst_moment.h"

#include <cmath>
#include <vector>

#include "geometry/message.h"
#include "io/output/replay/frame_reader.h"

namespace voussoir::io {
namespace {

using geometry::printed;

std::optional<WorstMoment> of_analysis(const Capacity& c) {
  if (std::isfinite(c.peak_time) && c.peak_shear > 0) return {{c.peak_time, "largest base shear", printed("%.1f kN", 1e-3 * c.peak_shear)}};
  if (std::isfinite(c.multiplier_time) && c.multiplier_at_rest > 0)
    return {{c.multiplier_time, "largest load factor", printed("%.3f", c.multiplier_at_rest)}};
  return {};
}

std::optional<WorstMoment> of_drift(const Measures& m) {
  const std::size_t walls = m.walls.size();
  double most = 0;
  std::optional<WorstMoment> found;
  for (std::size_t i = 0; i < m.series.drift.size(); ++i) {
    for (const bool out : {true, false}) {
      const double drift = std::abs((out ? m.series.drift : m.series.in_plane_drift)[i]);
      if (!(drift > most && drift < kWildDrift)) continue;  // also of NaN
      most = drift;
      const std::string where = std::string(out ? " out of plane, " : " in plane, ") + m.walls[i % walls].name;
      found = {m.series.time[i / walls], "largest drift", printed("%.2g %%", 100 * drift) + where};
    }
  }
  return found;
}

std::optional<WorstMoment> of_displacement(const FrameReader& frames) {
  double most = 0;
  std::optional<WorstMoment> found;
  for (std::uint64_t f = 0; f < frames.frames(); ++f) {
    const std::vector<double> u = frames.displacement(f);
    for (std::size_t e = 0; e + 2 < u.size(); e += 3) {
      const double way = std::hypot(u[e], u[e + 1], u[e + 2]);
      if (way <= most) continue;
      most = way;
      found = {frames.times()[f], "largest displacement", printed("%.3g m", way)};
    }
  }
  return found;
}

}  // namespace

std::optional<WorstMoment> worst_moment(const Measures& m, const Capacity* capacity, const FrameReader& frames) {
  if (frames.frames() == 0) return {};
  if (capacity != nullptr)
    if (const auto found = of_analysis(*capacity)) return found;
  if (m.collapse_time >= 0) return {{m.collapse_time, "collapse", "more than half of the roof has fallen"}};
  if (const auto found = of_drift(m)) return found;
  return of_displacement(frames);
}

}  // namespace voussoir::io
