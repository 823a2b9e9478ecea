// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/nth.h"
#include "io/output/measures/debris/bodies.h"

namespace voussoir::io {
namespace {

constexpr double kWhole = 0.7;     // of height or length: a body that extends so far counts as the whole
constexpr double kBuilding = 0.6;  // of all mass: the body is the building, less detached parts
constexpr double kSunk = 0.5;      // of its size: sinking by which it falls
constexpr double kStill = 5e-3;    // m: no element has moved farther

/// Position in a wall: "", "upper half", "lower left part".
std::string place_of(const Body& b, const Wall& w) {
  const std::size_t along = 1 - w.across;
  const double tall = std::min(1.0, b.box.size(2) / w.height()), wide = std::min(1.0, b.box.size(along) / w.length());
  std::string where;
  if (tall < kWhole) where = component(b.centre, 2) > w.box.centre(2) ? "upper" : "lower";
  if (wide < kWhole) {
    // Seen from outside, x runs to the right before a front wall (outward −y), y before a right wall (outward x).
    const double off = w.right() * (w.along(b.centre) - w.box.centre(along));
    const char* side = std::abs(off) < 0.15 * w.length() ? "middle" : off > 0 ? "right" : "left";
    where += (where.empty() ? "" : " ") + std::string(side);
  }
  if (where.empty()) return "";
  return where + (wide >= kWhole && tall > 0.3 ? " half" : " part");
}

const char* along_z(Vec3 u) { return u.z < 0 ? "sinks" : "rises"; }

std::string motion_of(const Body& b, const Wall* w) {
  const Vec3 u = b.displacement, r = b.rotation;
  const double size = std::max({b.box.size(0), b.box.size(1), b.box.size(2)});
  if (norm(u) + 0.5 * size * norm(r) < kStill) return "stays in place";
  if (u.z < -kSunk * b.box.size(2)) return "falls";
  const bool upright = std::abs(u.z) > std::hypot(u.x, u.y);
  if (w == nullptr) return norm(r) * size > norm(u) ? "turns" : upright ? along_z(u) : "slides";
  const std::size_t along = 1 - w->across;
  const double out = w->outward * w->through(u);
  const std::array<double, 4> reach{std::abs(w->along(r)) * b.box.size(2), std::abs(r.z) * b.box.size(along),
                                    std::abs(w->through(r)) * b.box.size(2), norm(u)};
  switch (std::ranges::max_element(reach) - reach.begin()) {
    case 0:
      return out >= 0 ? "turns out" : "turns in";
    case 1:
      return "turns about a vertical line";
    case 2:
      return "turns in its plane";
    default:
      break;
  }
  if (upright) return along_z(u);
  if (std::abs(out) >= std::abs(w->along(u))) return out >= 0 ? "moves out" : "moves in";
  return "slides along";
}

}  // namespace

std::string body_name(const Body& b, const Building& building) {
  const Wall* wall = b.wall < 0 ? nullptr : &nth(building.walls, b.wall);
  const auto gable = std::ranges::find(building.gables, b.wall, &Gable::wall);
  if (b.gable && gable != building.gables.end()) wall = &gable->part;
  double all = 0;
  for (const double m : building.mass) all += m;
  if (!building.walls.empty() && b.mass > kBuilding * all)
    return std::string("building, ") + (b.on_ground ? "stays in place" : motion_of(b, nullptr));
  std::string name = wall == nullptr ? (building.walls.empty() ? "body" : "roof") : wall->name;
  if (wall != nullptr) {
    const bool more = b.box.size(wall->across) > 2 * wall->thickness();  // the body extends round a corner
    if (more) name += " and others";
    const std::string place = more ? "" : place_of(b, *wall);
    if (!place.empty()) name += ", " + place;
  }
  return name + ", " + motion_of(b, wall);
}

}  // namespace voussoir::io
