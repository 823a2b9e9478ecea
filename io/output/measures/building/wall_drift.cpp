// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/building/wall_drift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace voussoir::io {
namespace {

constexpr double kGone = 1.0;  // m, in plan

/// Horizontal displacements of those of a wall's elements that have not fallen.
struct Displacements {
  std::vector<std::array<double, 2>> of;  // x, y, m
  std::size_t fallen = 0;

  /// The median of each component; of an even number of values the middle one nearer to zero.
  [[nodiscard]] std::array<double, 2> median() const {
    std::array<double, 2> middle{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::vector<double> sorted;
      for (const auto& d : of) sorted.push_back(d[axis]);
      std::ranges::sort(sorted);
      const double low = sorted[(sorted.size() - 1) / 2], high = sorted[sorted.size() / 2];
      middle[axis] = std::abs(low) <= std::abs(high) ? low : high;
    }
    return middle;
  }
};

/// Displacements in one direction of the elements still part of the wall.
struct Sum {
  double metres = 0;
  std::size_t standing = 0, gone = 0;

  [[nodiscard]] double mean() const noexcept { return standing > 0 ? metres / static_cast<double>(standing) : 0.0; }
};

/// Along the axes of the wall.
Displacements displacements_of(const Wall& wall, const std::vector<std::size_t>& elements, const std::vector<Pose>& start,
                               const std::vector<Pose>& poses, const std::vector<std::uint8_t>& fallen) {
  Displacements found;
  for (const std::size_t e : elements) {
    const Vec3 d = wall.axes.of(poses[e].centre - start[e].centre);
    fallen[e] != 0 ? static_cast<void>(++found.fallen) : found.of.push_back({d.x, d.y});
  }
  return found;
}

/// Sum over elements still part of the wall: an element that flew off without sinking is excluded like a fallen one.
Sum sum_of(const Wall& wall, const Displacements& d, DriftDirection direction) {
  const bool out = direction == DriftDirection::out_of_plane;
  const std::size_t axis = out ? wall.across : 1 - wall.across;
  const double sign = out ? wall.outward : 1.0;
  Sum sum;
  sum.gone = d.fallen;
  if (d.of.empty()) return sum;
  const std::array<double, 2> middle = d.median();
  for (const auto& own : d.of) {
    const bool alone = std::hypot(own[0] - middle[0], own[1] - middle[1]) > kGone, far = std::hypot(own[0], own[1]) > wall.height();
    if (alone || far) {
      ++sum.gone;
    } else {
      ++sum.standing;
      sum.metres += sign * own[axis];
    }
  }
  return sum;
}

}  // namespace

std::optional<double> wall_drift(const Wall& wall, const std::vector<Pose>& start, const std::vector<Pose>& poses,
                                 const std::vector<std::uint8_t>& fallen, DriftDirection direction) {
  std::size_t standing = 0, gone = 0;
  double most = 0;
  const double foot = sum_of(wall, displacements_of(wall, wall.foot, start, poses, fallen), direction).mean();
  for (const std::vector<std::size_t>& piece : wall.top) {
    const Sum sum = sum_of(wall, displacements_of(wall, piece, start, poses, fallen), direction);
    standing += sum.standing, gone += sum.gone;
    if (sum.standing > 0 && std::abs(sum.mean() - foot) > std::abs(most)) most = sum.mean() - foot;
  }
  if (gone >= standing) return {};
  return most / wall.height();
}

std::optional<double> storey_drift(const Wall& wall, const std::vector<Pose>& start, const std::vector<Pose>& poses,
                                   const std::vector<std::uint8_t>& fallen) {
  constexpr DriftDirection kAlong = DriftDirection::in_plane;
  std::set<std::size_t> counted;  // an element between two pieces is in both
  std::size_t standing = 0, gone = 0;
  double sum = 0;
  for (std::vector<std::size_t> piece : wall.top) {
    std::erase_if(piece, [&](std::size_t e) { return !counted.insert(e).second; });
    const Sum of_piece = sum_of(wall, displacements_of(wall, piece, start, poses, fallen), kAlong);
    standing += of_piece.standing, gone += of_piece.gone, sum += of_piece.metres;
  }
  if (gone >= standing) return {};
  const double foot = sum_of(wall, displacements_of(wall, wall.foot, start, poses, fallen), kAlong).mean();
  const double sign = wall.inner ? 1.0 : wall.right();  // an inner wall has no outside
  return sign * (sum / static_cast<double>(standing) - foot) / wall.height();
}

}  // namespace voussoir::io
