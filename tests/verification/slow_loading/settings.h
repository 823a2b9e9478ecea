// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/verification/slow_loading/assessment.h"

/// What the settings of a search for states of rest do to its curve.
namespace voussoir::testing {

struct RestSetting {
  std::string words;
  double tolerance = 1.0, path_step = 1.0;  // factors
};
inline const RestSetting kRestSettings[] = {
    {"ten times the tolerance", 10.0, 1.0}, {"a thousandth of the tolerance", 1e-3, 1.0}, {"half the step of the path", 1.0, 0.5}};

inline std::size_t peak_of(const io::CapacityCurve& r) {
  return static_cast<std::size_t>(std::ranges::max_element(r.factor) - r.factor.begin());
}

/// Load factor at a displacement behind the peak, on the straight line between two points of the curve; NaN: the curve is not there.
inline double factor_behind_peak(const io::CapacityCurve& r, double displacement) {
  for (std::size_t i = peak_of(r); i + 1 < r.factor.size(); ++i) {
    const double a = r.displacement[i], b = r.displacement[i + 1];
    if (a <= displacement && displacement < b) return std::lerp(r.factor[i], r.factor[i + 1], (displacement - a) / (b - a));
  }
  return std::numeric_limits<double>::quiet_NaN();
}

struct Change {
  double most = 0.0;  // of load factors, over the peak
  int points = 0;     // compared
};

/// What is borne at the points of a curve from its peak down to a share of it, on it and on another curve.
inline Change change_behind_peak(const io::CapacityCurve& r, const io::CapacityCurve& other, double down_to) {
  Change c;
  const std::size_t peak = peak_of(r);
  for (std::size_t i = peak; i < r.factor.size() && r.factor[i] >= down_to * r.factor[peak]; ++i) {
    const double there = factor_behind_peak(other, r.displacement[i]);
    if (std::isnan(there)) continue;
    c.most = std::max(c.most, std::abs(there - r.factor[i]) / r.factor[peak]), ++c.points;
  }
  return c;
}

}  // namespace voussoir::testing
