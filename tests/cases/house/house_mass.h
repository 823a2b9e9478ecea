// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cases/case.h"

/// What a house weighs, from the lengths of its case alone.
namespace voussoir::testing {

using namespace voussoir::cases;

inline double half_polygon(int n, double r) { return 0.5 * n * std::sin(std::numbers::pi / n) * r * r; }

/// Area of the frame of an arch less that under its soffit, a polygon of n sides on a circle.
inline double arch_area(const Opening& o, double brick_width) {
  const Arch& a = *o.arch;
  double under = 0.0, length = o.width;
  const double half = 0.5 * o.width, angle = a.rise > 0.0 ? 2.0 * std::atan2(a.rise, half) : 0.0;
  if (a.rise > 0.0) length = 2.0 * angle * half / std::sin(angle);
  const int n = a.voussoirs.value_or(std::clamp(2 * static_cast<int>(length / brick_width / 2.0) + 1, 3, 101));
  if (a.rise > 0.0) {
    const double radius = half / std::sin(angle);
    under = 0.5 * radius * radius * (n * std::sin(2.0 * angle / n) - std::sin(2.0 * angle));
  }
  return (o.width + 2 * a.springer) * (a.rise + a.thickness) - under;
}
/// Of its frame, whatever fills it.
inline double frame_area(const Opening& o) { return (o.width + 2 * o.arch->springer) * (o.arch->rise + o.arch->thickness); }

/// Volumes of a house, m3, and the mass of what lies on it, kg.
struct Volumes {
  double masonry = 0.0, timber = 0.0, load = 0.0;
};

/// Clear lengths along x and y in a storey, and thicknesses of its bearing and other walls.
struct StoreySizes {
  double height, bearing, nonbearing;
  std::array<double, 2> clear;
};
inline std::vector<StoreySizes> storeys_of(const House& h) {
  const double x = h.inner_size[0] + 2 * h.nonbearing_wall, y = h.inner_size[1] + 2 * h.bearing_wall;
  std::vector<StoreySizes> all{{h.height, h.bearing_wall, h.nonbearing_wall, {h.inner_size[0], h.inner_size[1]}}};
  for (const Storey& s : h.storeys) {
    const double b = s.bearing_wall.value_or(all.back().bearing), n = s.nonbearing_wall.value_or(all.back().nonbearing);
    all.push_back({s.height, b, n, {x - 2 * n, y - 2 * b}});
  }
  return all;
}

inline bool is_in(const InnerWall& wall, int storey) {
  return wall.storeys.empty() || std::ranges::find(wall.storeys, storey) != wall.storeys.end();
}

/// What parts of the base under outer walls take of them: m3.
inline double under_parts(const House& h, const Base& base) {
  double volume = 0.0;
  for (const BasePart& part : base.parts) {
    const bool along_x = part.wall == "front" || part.wall == "rear";
    const double length = h.inner_size[along_x ? 0 : 1] + 2 * (along_x ? h.nonbearing_wall : h.bearing_wall);
    volume += part.level * (along_x ? h.bearing_wall : h.nonbearing_wall) * (part.to.value_or(length) - part.from.value_or(0.0));
  }
  return volume;
}

inline Volumes walls_of(const House& h) {
  Volumes v;
  int number = 0;
  for (const StoreySizes& s : storeys_of(h)) {
    ++number;
    const double length = s.clear[0] + 2 * s.nonbearing;
    double plan = 2 * length * s.bearing + 2 * s.clear[1] * s.nonbearing;
    double thick[2] = {0.0, 0.0};
    for (const InnerWall& wall : h.inner_walls) {
      if (!is_in(wall, number)) continue;
      const std::size_t axis = wall.along == PlanAxis::x ? 0 : 1;
      thick[axis] += wall.thickness, plan += wall.thickness * s.clear[axis];
    }
    v.masonry += (plan - thick[0] * thick[1]) * s.height;  // what crosses counts once
  }
  for (const Opening& o : h.openings) {
    const StoreySizes s = storeys_of(h)[static_cast<std::size_t>(o.storey - 1)];
    double thickness = o.wall == "front" || o.wall == "rear" ? s.bearing : s.nonbearing;
    for (const InnerWall& wall : h.inner_walls) thickness = wall.name == o.wall ? wall.thickness : thickness;
    const double lintel = o.lintel ? o.lintel->length * o.lintel->height * thickness : 0.0;
    v.masonry -= o.width * o.height * thickness + lintel;
    if (o.arch) v.masonry -= (frame_area(o) - arch_area(o, h.brick[1] + h.mortar)) * thickness;
    v.timber += lintel;
  }
  const double height = h.height + (h.storeys.empty() ? 0.0 : h.storeys[0].height);
  for (const Pier& pier : h.piers) v.masonry += pier.width * pier.depth * std::min(height, pier.height.value_or(h.height));
  return v;
}

/// As many beams as fit into each room, with half a brick at least between beam and wall.
inline int beams_of(const House& h, const Floor& f) {
  const StoreySizes s = storeys_of(h)[static_cast<std::size_t>(f.storey - 1)];
  const std::size_t across = f.along == PlanAxis::x ? 1 : 0;
  std::vector<std::array<double, 2>> walls;
  for (const InnerWall& wall : h.inner_walls)
    if (is_in(wall, f.storey) && wall.along == f.along) walls.push_back({wall.at, wall.at + wall.thickness});
  std::ranges::sort(walls);
  double from = across == 0 ? s.nonbearing : s.bearing;
  walls.push_back({from + s.clear[across], 0.0});
  int count = 0;
  for (const auto& [low, high] : walls) {
    const double room = low - from - (h.brick[0] + h.mortar) - f.beam[0] + 1e-8;
    count += room < 0.0 ? 0 : static_cast<int>(room / f.spacing) + 1;
    from = high;
  }
  return count;
}

inline Volumes floor_of(const House& h, const Floor& f) {
  const StoreySizes s = storeys_of(h)[static_cast<std::size_t>(f.storey - 1)];
  const double length = s.clear[f.along == PlanAxis::x ? 0 : 1] + 2 * f.bearing, count = beams_of(h, f);
  double in_walls = 2 * f.bearing;
  for (const InnerWall& wall : h.inner_walls)
    if (is_in(wall, f.storey) && wall.along != f.along) in_walls += wall.thickness;
  const double section = f.beam[0] * f.beam[1];
  return {-count * section * in_walls, count * section * length, count * f.load * f.spacing * length};
}

inline Volumes roof_of(const House& h) {
  const StoreySizes top = storeys_of(h).back();
  const double length = top.clear[0] + 2 * top.nonbearing, depth = top.clear[1] + 2 * top.bearing;
  const Roof& r = h.roof;
  Volumes v;
  if (r.kind == RoofKind::flat) {
    const double across = depth - 2 * (top.bearing - r.bearing.value_or(std::min(top.bearing, h.brick[0] + h.mortar)));
    v.timber = length * across * r.beam[1];
    v.load = r.surcharge * length * across;
  }
  if (r.kind == RoofKind::vault || r.kind == RoofKind::gables) v.masonry = 2 * top.nonbearing * half_polygon(r.voussoirs, r.radius);
  if (r.kind == RoofKind::vault) {
    const double outer = r.radius + r.thickness;
    v.masonry += length * (half_polygon(r.voussoirs, outer) - half_polygon(r.voussoirs, r.radius));
    v.load = r.surcharge * length * r.voussoirs * 2 * outer * std::sin(0.5 * std::numbers::pi / r.voussoirs);
  }
  if (r.kind == RoofKind::pitched) {
    const double pitch = r.pitch * std::numbers::pi / 180.0, slope = std::tan(pitch), plumb = r.beam[1] / std::cos(pitch);
    const double seat = std::min({top.bearing, h.brick[0] + h.mortar, 0.5 * plumb / slope}), run = 0.5 * top.clear[1];
    const double clear = length - r.beam[0], most = std::floor(clear / r.beam[0] + 1e-9);  // side by side
    const double rafters = std::min(most, std::ceil(clear / r.spacing - 1e-9)) + 1;
    // From foot to ridge a parallelogram of plumb depth, less what lies below the level of the seat.
    v.timber = 2 * rafters * r.beam[0] * ((run + seat) * plumb - 0.5 * seat * seat * slope);
    v.load = 2 * r.surcharge * length * (run + seat) / std::cos(pitch);
    v.masonry = 2 * top.nonbearing * run * run * slope;  // two triangles
  }
  return v;
}

inline double reinforcement_of(const House& h) {
  if (!h.reinforcement) return 0.0;
  const Reinforcement& f = *h.reinforcement;
  const StoreySizes top = storeys_of(h).back();
  const double section = f.ring_beam[0] * f.ring_beam[1], x = h.inner_size[0], y = h.inner_size[1];
  if (f.ring_beam_place == RingPlace::middle)
    return 2.0 * section * (top.clear[0] + top.nonbearing + f.ring_beam[0] + top.clear[1] + top.bearing - f.ring_beam[0]);
  const double columns = static_cast<double>(f.bearing.size() + f.nonbearing.size());
  return 2.0 * columns * f.column[0] * f.column[1] * (h.height - f.ring_beam[1]) + 2.0 * (x + y - 2 * f.ring_beam[0]) * section;
}

/// Mass of a house of four walls from its plan alone, kg.
inline double expected_mass(const House& h, const Case& c) {
  Volumes sum{0.0, reinforcement_of(h), 0.0};
  std::vector<Volumes> parts{walls_of(h), roof_of(h)};
  for (const Floor& f : h.floors) parts.push_back(floor_of(h, f));
  for (const Volumes& v : parts) sum.masonry += v.masonry, sum.timber += v.timber, sum.load += v.load;
  if (c.base) sum.masonry -= under_parts(h, *c.base);
  return h.copies[0] * h.copies[1] *
         (c.materials.at("adobe").density * sum.masonry + c.materials.at("wood").density * sum.timber + sum.load);
}

}  // namespace voussoir::testing
