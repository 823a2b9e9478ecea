// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/measures/wall_drift.h"

#include <cmath>

namespace voussoir::io {
namespace {

/// Displacements of elements that have not fallen.
struct Sum {
  double metres = 0;
  std::size_t standing = 0, fallen = 0;

  [[nodiscard]] double mean() const noexcept { return standing > 0 ? metres / static_cast<double>(standing) : 0.0; }
};

double component(Vec3 v, std::size_t axis) { return axis == 0 ? v.x : v.y; }

}  // namespace

std::optional<double> wall_drift(const Wall& wall, const std::vector<Pose>& start, const std::vector<Pose>& poses,
                                 const std::vector<std::uint8_t>& fallen, DriftDirection direction) {
  const bool out = direction == DriftDirection::out_of_plane;
  const std::size_t axis = out ? wall.across : 1 - wall.across;
  const double sign = out ? wall.outward : 1.0;
  const auto sum_of = [&](const std::vector<std::size_t>& elements) {
    Sum sum;
    for (const std::size_t e : elements) {
      if (fallen[e] != 0) {
        ++sum.fallen;
      } else {
        ++sum.standing;
        sum.metres += sign * component(poses[e].centre - start[e].centre, axis);
      }
    }
    return sum;
  };
  std::size_t standing = 0, down = 0;
  double most = 0;
  const double foot = sum_of(wall.foot).mean();
  for (const std::vector<std::size_t>& piece : wall.top) {
    const Sum sum = sum_of(piece);
    standing += sum.standing, down += sum.fallen;
    if (sum.standing > 0 && std::abs(sum.mean() - foot) > std::abs(most)) most = sum.mean() - foot;
  }
  if (down >= standing) return {};
  return most / wall.height();
}

}  // namespace voussoir::io
