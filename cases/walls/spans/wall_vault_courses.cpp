// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_vault_courses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/walls/spans/wall_bays.h"

namespace voussoir::cases {
namespace {

/// An end of a voussoir: x = at + slope * |y|.
struct CourseEnd {
  double at = 0.0, slope = 0.0;
  [[nodiscard]] double operator()(double y) const noexcept { return at + slope * std::abs(y); }
};

/// A course over one side of a room, in axes of its own: x along it, y across, from the centre of the room.
struct Course {
  Vec3 centre, x, y;          // unit vectors, right-handed with z
  geometry::Polygon section;  // (y, height) [m]; its outer face between corners 2 and 3
  CourseEnd low, high;
  std::string part;
};

/// \param unit  m, distance of head joints \param first  x of one of them
void lay(const Course& c, double unit, double first, std::vector<VaultStone>& stones) {
  std::vector<std::array<double, 2>> corners;
  double from = c.low(c.section[0].s), to = c.high(c.section[0].s);
  for (const geometry::Point2 p : c.section) {
    corners.push_back({p.s, p.t});
    from = std::max(from, c.low(p.s)), to = std::min(to, c.high(p.s));
  }
  const double least = unit / 3.0 - kPlanTolerance;
  std::vector<CourseEnd> ends{c.low};
  for (double k = std::ceil((from + least - first) / unit); first + k * unit < to - least; k += 1.0)
    ends.push_back({first + k * unit, 0.0});
  ends.push_back(c.high);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const CourseEnd &low = ends[i], &high = ends[i + 1];
    VaultStone stone{geometry::make_prism(corners, 0.0, 1.0), c.part, low.slope == 0.0 && high.slope == 0.0, 0.0};
    for (Vec3& v : stone.shape.vertices) v = c.centre + (v.x == 0.0 ? low(v.y) : high(v.y)) * c.x + v.y * c.y + Vec3{0.0, 0.0, v.z};
    const geometry::Point2 a = c.section[2], b = c.section[3];
    stone.outer = 0.5 * (high(a.s) - low(a.s) + high(b.s) - low(b.s)) * std::hypot(b.s - a.s, b.t - a.t);
    stones.push_back(std::move(stone));
  }
}

/// The section of a course stretched across it. \param stretch  of the distance from the middle; below 0: the other half
geometry::Polygon stretched(const VaultProfile& profile, int k, double stretch) {
  geometry::Polygon section = profile.section(k);
  for (geometry::Point2& p : section) p.s = stretch * (profile.half() - p.s);
  return section;
}

/// The courses of a cross vault that run towards a side, up to the outer face of its wall.
void lay_web(const WallsPlan& plan, const VaultRoom& room, std::size_t i, const VaultProfile& profile, const WallVault& vault,
             std::vector<VaultStone>& stones) {
  const RoomSide& side = room.sides[i];
  const double across = room.sides[(i + 1) % 4].distance, end = side.distance + 2.0 * plan.legs[side.leg].half;
  const Vec3 along = normalised(side.to - side.from);  // counter-clockwise, so that left of the way outwards
  Course c{room.centre,
           {along.y, -along.x, 0.0},
           along,
           {},
           {0.0, side.distance / across},
           {end, 0.0},
           "web at " + side_name(plan.legs[side.leg])};
  for (int k = 0; k <= profile.courses(); ++k) {
    const double first = end - ((profile.courses() - k) % 2 == 0 ? 0.0 : 0.5 * vault.ring);
    for (const double half : {-1.0, 1.0}) {
      if (k == profile.courses() && half > 0.0) continue;  // the crown lies on both
      c.section = stretched(profile, k, half * across / profile.half());
      lay(c, vault.ring, first, stones);
    }
  }
}

/// The courses of a pavilion vault or a dome along a side.
void lay_along(const RoomSide& side, Vec3 centre, const VaultProfile& profile, const WallVault& vault, std::vector<VaultStone>& stones) {
  const Vec3 back = normalised(side.from - side.to), outwards = left_of(back);
  const auto slope = [&](Vec3 corner) { return dot(corner - centre, back) / side.distance; };
  Course c{centre, back, outwards, {}, {0.0, slope(side.to)}, {0.0, slope(side.from)}, ""};
  const double middle = 0.5 * dot(side.from + side.to - 2.0 * centre, back);
  for (int k = 0; k < profile.courses(); ++k) {
    c.section = stretched(profile, k, side.distance / profile.half());
    c.part = "course " + std::to_string(k + 1);
    lay(c, vault.ring, middle + (k % 2 == 0 ? 0.5 * vault.ring : 0.0), stones);
  }
}

/// The stone in the crown: the room made small, between the joints of the last courses.
VaultStone keystone(const VaultRoom& room, const VaultProfile& profile) {
  const geometry::Polygon section = profile.section(profile.courses());
  const geometry::Point2 inner = section[0], outer = section[3];
  std::vector<std::array<double, 2>> corners;
  for (const RoomSide& s : room.sides) corners.push_back({s.from.x - room.centre.x, s.from.y - room.centre.y});
  VaultStone stone{geometry::make_prism(corners, 0.0, 1.0), "keystone", true, 0.0};
  const auto share = [&](geometry::Point2 p) { return (profile.half() - p.s) / profile.half(); };
  for (Vec3& v : stone.shape.vertices) {
    const geometry::Point2 p = v.x == 0.0 ? inner : outer;
    v = room.centre + Vec3{share(p) * v.y, share(p) * v.z, p.t};
  }
  for (const RoomSide& s : room.sides) stone.outer += 0.5 * s.distance * norm(s.to - s.from) * share(outer) * share(outer);
  return stone;
}

}  // namespace

std::vector<VaultStone> vault_stones(const WallsPlan& plan, const VaultRoom& room, const VaultProfile& profile, const WallVault& vault) {
  std::vector<VaultStone> stones;
  for (std::size_t i = 0; i < room.sides.size(); ++i) {
    if (vault.kind == VaultKind::cross)
      lay_web(plan, room, i, profile, vault, stones);
    else
      lay_along(room.sides[i], room.centre, profile, vault, stones);
  }
  if (!vault.oculus) stones.push_back(keystone(room, profile));
  return stones;
}

}  // namespace voussoir::cases
