// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_vault_room.h"

#include <algorithm>
#include <cmath>

#include "cases/input_error.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_bays.h"
#include "cases/walls/spans/wall_vault_profile.h"

namespace voussoir::cases {
namespace {

/// Where two lines cross. \pre they are not parallel
Vec3 crossing(Vec3 p, Vec3 along_p, Vec3 q, Vec3 along_q) { return p + cross(q - p, along_q).z / cross(along_p, along_q).z * along_p; }

/// Four sides in turn. \throw InputError
std::vector<std::size_t> four_sides(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index) {
  if (vault.walls.size() != 4)
    throw InputError(vault_key(index, "walls"),
                     "names " + std::to_string(vault.walls.size()) + " sides; a cross or pavilion vault has four, in turn round its room");
  std::vector<std::size_t> found(4);
  Faults faults;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string key = indexed_key(vault_key(index, "walls"), i, "");
    faults.attempt([&] {
      found[i] = find_side(walls, plan, vault.walls[i], key);
      const Leg& leg = plan.legs[found[i]];
      if (leg.facets.size() > 1) throw InputError(key, quoted(vault.walls[i]) + " bends; the sides of this room are straight");
      if (std::find(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(i), found[i]) !=
          found.begin() + static_cast<std::ptrdiff_t>(i))
        throw InputError(key, quoted(vault.walls[i]) + " is named twice; the four sides of a room are different");
      const Tick top = eaves(walls[leg.wall]), first = eaves(walls[plan.legs[found[0]].wall]);
      if (top != first)
        throw InputError(key, "the " + leg.tag + " ends at " + metres_text(top) + " m above the base, the " + plan.legs[found[0]].tag +
                                  " at " + metres_text(first) + " m; the feet of a vault rest at one height");
    });
  }
  faults.raise();
  return found;
}

/// The corners of the inner faces of four sides in turn. \throw InputError
std::vector<Vec3> corners_of(const WallsPlan& plan, const std::vector<std::size_t>& legs, std::size_t index) {
  Vec3 middle;
  for (const std::size_t leg : legs) middle = middle + 0.25 * plan.legs[leg].at(0.5 * plan.legs[leg].length(), 0.0);
  const auto face = [&](std::size_t leg) {
    const Leg& l = plan.legs[leg];
    return l.at(0.0, dot(middle - l.at(0.0, 0.0), l.facets[0].across) > 0.0 ? l.half : -l.half);
  };
  std::vector<Vec3> corners(4);
  for (std::size_t i = 0; i < 4; ++i) {
    const Leg &a = plan.legs[legs[(i + 3) % 4]], &b = plan.legs[legs[i]];
    if (std::abs(cross(a.facets[0].along, b.facets[0].along).z) < kLeastSine)
      throw InputError(vault_key(index, "walls"), "do not go round a room: the " + a.tag + " and the " + b.tag +
                                                      " are at less than 30 degrees; name its four sides in turn");
    corners[i] = crossing(face(legs[(i + 3) % 4]), a.facets[0].along, face(legs[i]), b.facets[0].along);
  }
  return corners;
}

/// The inner corners of a closed wall without corners, counter-clockwise.
std::vector<Vec3> corners_of(const Leg& ring) {
  double area = 0.0;
  for (std::size_t i = 0; i < ring.facets.size(); ++i) {
    const Facet& f = ring.facets[i];
    area += cross(f.from - ring.facets[0].from, f.along).z * f.length;
  }
  std::vector<Vec3> corners;
  for (const Facet& f : ring.facets) corners.push_back(ring.at(f.start, area > 0.0 ? ring.half : -ring.half));
  if (area < 0.0) std::ranges::reverse(corners);
  return corners;
}

Vec3 centroid_of(const std::vector<Vec3>& corners) {
  Vec3 sum;
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i] - corners[0], b = corners[(i + 1) % corners.size()] - corners[0];
    const double twice = cross(a, b).z;
    sum = sum + twice / 3.0 * (a + b), area += twice;
  }
  return corners[0] + (1.0 / area) * sum;
}

bool is_convex(const std::vector<Vec3>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 here = corners[(i + 1) % n] - corners[i], next = corners[(i + 2) % n] - corners[(i + 1) % n];
    if (!(cross(here, next).z > kSquare * norm(here) * norm(next))) return false;
  }
  return true;
}

}  // namespace

double VaultRoom::span() const noexcept { return 2.0 * std::ranges::min_element(sides, {}, &RoomSide::distance)->distance; }

VaultRoom find_room(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index) {
  const bool dome = vault.kind == VaultKind::dome;
  std::vector<std::size_t> legs;
  std::vector<Vec3> corners;
  if (dome) {
    if (vault.walls.size() != 1)
      throw InputError(vault_key(index, "walls"),
                       "names " + std::to_string(vault.walls.size()) + " sides; a dome stands on one closed wall without corners");
    const std::string key = indexed_key(vault_key(index, "walls"), 0, "");
    legs = {find_side(walls, plan, vault.walls[0], key)};
    if (!plan.legs[legs[0]].ring)
      throw InputError(key, quoted(vault.walls[0]) +
                                " is not closed, or has corners; a dome stands on a closed wall that bends by less than "
                                "30 degrees at each of its points");
    corners = corners_of(plan.legs[legs[0]]);
    legs.resize(corners.size(), legs[0]);
  } else {
    legs = four_sides(walls, plan, vault, index), corners = corners_of(plan, legs, index);
    if (cross(corners[2] - corners[0], corners[3] - corners[1]).z < 0.0) {
      std::ranges::reverse(corners), std::ranges::reverse(legs);
      std::ranges::rotate(legs, legs.begin() + 1);  // side i begins at corner i
    }
  }
  if (!is_convex(corners)) throw InputError(vault_key(index, "walls"), "bound no convex room; name the sides of one, in turn round it");
  VaultRoom room;
  room.centre = dome ? centroid_of(corners) : crossing(corners[0], corners[2] - corners[0], corners[1], corners[3] - corners[1]);
  room.seat = metres(eaves(walls[plan.legs[legs[0]].wall]));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 from = corners[i], to = corners[(i + 1) % corners.size()];
    room.sides.push_back({legs[i], from, to, dot(room.centre - from, left_of(normalised(to - from)))});
    const Vec3 before = corners[(i + corners.size() - 1) % corners.size()];
    if (vault.kind == VaultKind::cross && std::abs(dot(normalised(to - from), normalised(from - before))) > kSquare)
      throw InputError(vault_key(index, "walls"),
                       "meet at an angle: the room of a cross vault is a rectangle; a pavilion vault spans "
                       "any convex quadrilateral");
  }
  return room;
}

void check_feet(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index, const VaultRoom& room,
                double foot, double spare) {
  const double least = 0.5 * room.span();
  for (std::size_t i = 0; i < room.sides.size(); ++i) {
    const RoomSide& side = room.sides[i];
    const Leg &leg = plan.legs[side.leg], &before = plan.legs[room.sides[(i + room.sides.size() - 1) % room.sides.size()].leg];
    const double wide = foot * side.distance / least, thick = walls[leg.wall].thickness;
    if (wide > thick - spare + 1e-9)
      throw InputError(vault_key(index, "thickness"), text(vault.thickness) + " m makes feet of " + text(std::round(wide * 1e4) * 1e-4) +
                                                          " m on the " + leg.tag + ", " + text(thick) + " m; allowed: feet of up to " +
                                                          text(std::round((thick - spare) * 1e4) * 1e-4) + " m");
    const Vec3 back = room.centre + (1.0 + foot / least) * (side.from - room.centre);
    if (!lies_in(leg, side.from) || !lies_in(before, side.from) || !(lies_in(leg, back) || lies_in(before, back)))
      throw InputError(vault_key(index, "walls"), "leave a corner of the room open: the " + before.tag + " and the " + leg.tag +
                                                      " do not meet there; the walls go round the whole room");
  }
}

}  // namespace voussoir::cases
