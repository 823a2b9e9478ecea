// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/support_history.h"

#include <algorithm>
#include <cstddef>

#include "geometry/turn.h"

namespace voussoir::cases {

namespace {

/// \param values  of a history, by sample
Vec3 interpolated(const SupportHistory& h, const std::vector<Vec3>& values, double t) {
  if (h.time.empty() || t < h.time.front()) return {};
  const auto later = std::lower_bound(h.time.begin() + 1, h.time.end() - 1, t);
  const auto i = static_cast<std::size_t>(later - h.time.begin());
  if (t >= h.time.back() && !h.open_ended) return values.back();
  const double f = (t - h.time[i - 1]) / (h.time[i] - h.time[i - 1]);
  return values[i - 1] + f * (values[i] - values[i - 1]);
}

}  // namespace

Vec3 value_at(const SupportHistory& h, double t) { return interpolated(h, h.displacement, t); }

SupportPose pose_at(const SupportHistory& h, Vec3 centroid, double t) {
  const Vec3 u = value_at(h, t);
  if (h.rotation.empty()) return {u, {}};
  const Quaternion q = geometry::quaternion_of(interpolated(h, h.rotation, t));
  return {u + rotation_minus_identity(q) * (centroid - h.about.value_or(centroid)), q};
}

}  // namespace voussoir::cases
