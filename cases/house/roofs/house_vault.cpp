// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/roofs/house_vault.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/house/house_parts.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

/// Corners on a circle about the axis of the vault. The springings are exactly at the height of the walls.
geometry::Polygon arc(const HousePlan& plan, double radius, int voussoirs) {
  const double axis = 0.5 * metres(plan.outer[1]), springing = metres(plan.height);
  geometry::Polygon corners(static_cast<std::size_t>(voussoirs) + 1);
  for (int k = 0; 2 * k <= voussoirs; ++k) {
    const double angle = std::numbers::pi * k / voussoirs;
    const double across = 2 * k == voussoirs ? 0.0 : radius * std::cos(angle), up = radius * std::sin(angle);
    nth(corners, k) = {axis - across, springing + up};
    nth(corners, voussoirs - k) = {axis + across, springing + up};
  }
  return corners;
}

void check_voussoirs(const Roof& roof) {
  if (roof.voussoirs < 3 || roof.voussoirs > 1000)
    throw InputError("house.roof.voussoirs", std::to_string(roof.voussoirs) + " voussoirs in a ring; allowed: 3 to 1000");
}

/// Checks that the whole thickness of the vault's feet is on the bearing walls.
void check_seat(const Roof& roof, const HousePlan& plan) {
  if (!plan.wall(Side::front).built || !plan.wall(Side::rear).built)
    throw InputError("house.roof.kind", "a vault stands on the front and the rear wall; house.walls leaves one of them out");
  const Tick wall = plan.wall(Side::front).thickness;
  const Tick radius = positive_length(roof.radius, "house.roof.radius");
  const Tick thickness = positive_length(roof.thickness, "house.roof.thickness");
  if (thickness > wall) {
    throw InputError("house.roof.thickness", text(roof.thickness) + " m is more than the bearing walls that the vault stands on; at most " +
                                                 metres_text(wall) + " m");
  }
  const Tick least = (plan.outer[1] - 2 * wall + 1) / 2, most = plan.outer[1] / 2 - thickness;
  if (radius < least || radius > most) {
    throw InputError("house.roof.radius", text(roof.radius) + " m puts the feet of the vault off the bearing walls; allowed: " +
                                              metres_text(least) + " to " + metres_text(most) + " m");
  }
  element_length(roof.ring, plan.outer[0], "house.roof.ring");
}

void check_gables(const Roof& roof, const HousePlan& plan) {
  const Tick radius = positive_length(roof.radius, "house.roof.radius");
  const Tick least = plan.brick_length, most = plan.outer[1] / 2;
  if (radius < least || radius > most) {
    throw InputError("house.roof.radius", text(roof.radius) + " m does not fit the non-bearing walls, " + metres_text(plan.outer[1]) +
                                              " m long; allowed: " + metres_text(least) + " to " + metres_text(most) + " m");
  }
  if (!plan.wall(Side::left).built && !plan.wall(Side::right).built)
    throw InputError("house.roof.kind", "gables stand on the left and the right wall; house.walls leaves out both");
}

/// The prism of voussoir k between two planes of constant x; corners in order round the voussoir.
geometry::Polyhedron voussoir_shape(const VaultProfile& profile, std::size_t k, Interval x) {
  const auto corner = [](geometry::Point2 p) { return std::array{p.s, p.t}; };
  const std::array corners{corner(profile.inner[k]), corner(profile.inner[k + 1]), corner(profile.outer[k + 1]), corner(profile.outer[k])};
  return geometry::make_prism(corners, metres(x.low), metres(x.high));
}

}  // namespace

double height_of(const geometry::Polygon& under) noexcept {
  double top = under.front().t;
  for (const geometry::Point2 p : under) top = std::max(top, p.t);
  return top - under.front().t;
}

VaultProfile vault_profile(const House& house, const HousePlan& plan) {
  check_voussoirs(house.roof);
  house.roof.kind == RoofKind::vault ? check_seat(house.roof, plan) : check_gables(house.roof, plan);
  return {arc(plan, house.roof.radius, house.roof.voussoirs), arc(plan, house.roof.radius + house.roof.thickness, house.roof.voussoirs)};
}

double surcharge_density(const House& house) noexcept {
  const Roof& roof = house.roof;
  if (roof.kind == RoofKind::flat) return roof.surcharge / roof.beam[1];
  // Chord of the outer face over the section of a voussoir.
  const double half = 0.5 * std::numbers::pi / roof.voussoirs, outer = roof.radius + roof.thickness;
  const double section = std::sin(half) * std::cos(half) * (outer * outer - roof.radius * roof.radius);
  return roof.surcharge * 2.0 * outer * std::sin(half) / section;
}

void build_vault(const House& house, const HousePlan& plan, HouseParts& parts) {
  const VaultProfile profile = vault_profile(house, plan);
  const Tick ring = ticks(house.roof.ring);
  Block prototype;
  prototype.kind = PartKind::voussoir;
  prototype.material = parts.roof;
  // The nominal length of a voussoir is that along its mean line.
  const double mean = std::numbers::pi * (house.roof.radius + 0.5 * house.roof.thickness) / house.roof.voussoirs;
  prototype.segment_size = 0.25 * std::min({mean, house.roof.thickness, metres(std::min(ring, plan.outer[0]))});
  int number = 0;
  for (const Interval x : cut_member({0, plan.outer[0]}, ring)) {
    prototype.tag = "vault ring " + std::to_string(number++);
    prototype.whole = x.length() == ring;
    for (std::size_t k = 0; k + 1 < profile.inner.size(); ++k) {
      parts.blocks.push_back(prototype);
      parts.blocks.back().shape = voussoir_shape(profile, k, x);
    }
  }
}

}  // namespace voussoir::cases
