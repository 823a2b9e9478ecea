// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/walls/prism.h"

#include <algorithm>
#include <array>
#include <utility>

#include "cases/house/house_parts.h"

namespace voussoir::cases {
namespace {

/// Exchanges x and y. As this is a reflection, loops are reversed and the two ends exchanged, so the result is a prism in vertex order.
geometry::Polyhedron with_x_for_y(geometry::Polyhedron p) {
  const std::size_t half = p.vertices.size() / 2;
  std::rotate(p.vertices.begin(), p.vertices.begin() + static_cast<std::ptrdiff_t>(half), p.vertices.end());
  for (Vec3& v : p.vertices) std::swap(v.x, v.y);
  for (auto& loop : p.faces) {
    for (std::int32_t& v : loop) v = static_cast<std::int32_t>((static_cast<std::size_t>(v) + half) % (2 * half));
    std::ranges::reverse(loop);
  }
  return p;
}

}  // namespace

geometry::Polyhedron wall_prism(const HousePlan& plan, const WallPlan& wall, const geometry::Polygon& section, Interval depth) {
  std::vector<std::array<double, 2>> corners;
  for (const geometry::Point2 p : section) corners.push_back({p.s, p.t});
  const HouseBox box = in_house(plan, wall, {}, depth, {});
  const Interval through = wall.along_x ? box.y : box.x;
  geometry::Polyhedron shape = geometry::make_prism(corners, metres(through.low), metres(through.high));
  return wall.along_x ? with_x_for_y(std::move(shape)) : shape;
}

}  // namespace voussoir::cases
