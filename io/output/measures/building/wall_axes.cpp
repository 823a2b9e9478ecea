// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/building/wall_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/input/files/errors.h"

namespace voussoir::io {
namespace {

constexpr double kUpright = 0.1;     // |z| of the normal of an upright face, at most
constexpr double kSameAngle = 1e-6;  // rad
constexpr double kStraight = 0.5;    // of the upright faces: so many lie along a straight wall or across it
constexpr double kQuarter = 0.5 * std::numbers::pi;

/// The angle about which most of these angles lie, which repeat after a quarter turn, and how many do.
struct Common {
  double angle = 0.0;
  std::size_t count = 0;
};
Common most_common(std::vector<double> angles) {
  std::ranges::sort(angles);
  const std::size_t n = angles.size();
  Common best;
  std::size_t end = 0;  // of those that are near to the first, counted on over the end
  for (std::size_t first = 0; first < n; ++first) {
    end = std::max(end, first);
    const auto at = [&](std::size_t i) { return i < n ? angles[i] : angles[i - n] + kQuarter; };
    while (end < first + n && at(end) - angles[first] <= kSameAngle) ++end;
    if (end - first > best.count) best = {angles[first], end - first};
  }
  return best;
}

WallAxes axes_at(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

Box Box::empty() noexcept {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
}

void Box::include(const Box& other) noexcept {
  for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], other.low[k]), high[k] = std::max(high[k], other.high[k]);
}

void Box::include(Vec3 point) noexcept { include(Box{{point.x, point.y, point.z}, {point.x, point.y, point.z}}); }

ElementVertices::ElementVertices(const Hdf5File& run, std::size_t elements) {
  const auto first = run.read<std::int32_t>("/model/element/first_vertex");
  const auto vertex = run.read<double>("/model/vertex");
  if (first.size() != elements) throw FileError(run.path(), "/model/element does not fit together");
  first_.assign(elements + 1, 0);
  std::size_t e = 0;
  for (std::size_t v = 0; v < vertex.size() / 3; ++v) {
    while (e + 1 < elements && static_cast<std::int64_t>(v) >= first[e + 1]) first_[++e] = v;
    vertex_.push_back({vertex[3 * v], vertex[3 * v + 1], vertex[3 * v + 2]});
  }
  while (e < elements) first_[++e] = vertex_.size();
}

Box ElementVertices::box(std::size_t element, const WallAxes& axes) const {
  Box box = Box::empty();
  for (std::size_t v = first_[element]; v < first_[element + 1]; ++v) box.include(axes.of(vertex_[v]));
  return box;
}

std::optional<WallAxes> ElementVertices::axes_along(std::span<const std::size_t> wall, const Faces& faces) const {
  std::vector<char> is_of(first_.size(), 0);
  for (const std::size_t e : wall) is_of[e] = 1;
  std::vector<double> angles;
  for (std::size_t f = 0; f < faces.element.size(); ++f) {
    const Vec3 n{faces.normal[3 * f], faces.normal[3 * f + 1], faces.normal[3 * f + 2]};
    if (is_of.at(static_cast<std::size_t>(faces.element[f])) == 0 || std::abs(n.z) > kUpright) continue;
    angles.push_back(std::fmod(std::atan2(n.y, n.x) + 2.0 * std::numbers::pi, kQuarter));
  }
  const Common common = most_common(angles);
  if (common.count == 0 || static_cast<double>(common.count) < kStraight * static_cast<double>(angles.size())) return {};
  const WallAxes axes = axes_at(common.angle);
  Box box = Box::empty();
  for (const std::size_t e : wall) box.include(this->box(e, axes));
  return box.size(0) >= box.size(1) ? axes : axes_at(common.angle - kQuarter);
}

}  // namespace voussoir::io
