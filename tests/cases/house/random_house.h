// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "tests/cases/paper_house.h"

/// Houses drawn from the ranges of the keys, for tests of what has to hold of any house.
namespace voussoir::testing {

using namespace voussoir::cases;  // NOLINT(google-global-names-in-headers): the names of a house's parts

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool one_in(int n) { return whole(1, n) == 1; }
  /// A multiple of `step` above `low`.
  double pick(double low, double high, double step) { return low + step * whole(0, static_cast<int>(std::lround((high - low) / step))); }
  /// Beyond `corner` by a multiple of `step` of at most `play`, where there is some; one in six times anywhere.
  double place(double corner, double play, double step) {
    const double most = one_in(6) ? 1.4 : std::max(0.0, play);
    return corner + step * whole(0, static_cast<int>(most / step + 1e-9));
  }

 private:
  std::mt19937 random_;
};

inline void add_openings(Dice& dice, House& h) {
  for (int i = dice.whole(0, 2); i > 0; --i) {
    const char* walls[] = {"front", "rear", "left", "right"};
    const double step = dice.one_in(3) ? 0.01 : 0.05;
    const double level = dice.one_in(3) ? 0.01 : 0.1;
    const int wall = dice.whole(0, 3);
    const double corner = wall < 2 ? h.nonbearing_wall : h.bearing_wall, room = h.inner_size[wall < 2 ? 0 : 1];
    const double width = dice.pick(0.2, 0.8, step), from = dice.place(corner, room - width, step);
    Opening o = opening(walls[wall], from, width, dice.pick(0.0, 0.3, level), dice.pick(0.1, 0.4, level));
    if (dice.one_in(2)) o.lintel = Lintel{o.width + dice.pick(0.1, 0.4, step), dice.pick(0.08, 0.12, 0.02), dice.pick(0.1, 0.3, 0.05)};
    if (dice.one_in(3)) {
      const double rise = dice.one_in(2) ? 0.0 : dice.one_in(3) ? 0.5 * o.width : std::min(0.1, 0.4 * o.width);
      o.arch = Arch{rise, dice.one_in(6) ? 0.16 : 0.1, dice.one_in(4) ? 0.15 : h.brick[1] + h.mortar, {}, {}};
      h.height = std::max(h.height, 1.2);  // room for it
      if (dice.one_in(3)) o.arch->voussoirs = dice.whole(3, 9);
    }
    h.openings.push_back(o);
  }
}

/// Under a part of a wall, or all walls beyond a place.
inline void add_base_part(Dice& dice, Case& c) {
  const House& h = *c.house;
  BasePart part;
  part.level = dice.pick(0.1, 0.4, dice.one_in(3) ? 0.01 : 0.1);
  const char* walls[] = {"front", "rear", "left", "right"};
  part.wall = walls[dice.whole(0, 3)];
  const bool along_x = part.wall == "front" || part.wall == "rear";
  const double aside = along_x ? h.nonbearing_wall : h.bearing_wall, room = h.inner_size[along_x ? 0 : 1];
  const double step = dice.one_in(3) ? 0.01 : 0.1;
  if (dice.one_in(2)) part.from = dice.place(aside, 0.5 * room, step);
  if (dice.one_in(2)) part.to = aside + dice.pick(0.5 * room, room, step);
  if (dice.one_in(3)) part.motion.emplace().velocity = Vec3{0.0, 0.0, -1e-3};
  c.base->parts.push_back(part);
}

inline void add_pier(Dice& dice, House& h) {
  const char* walls[] = {"front", "rear", "left", "right"};
  Pier pier;
  pier.wall = walls[dice.whole(0, 3)];
  const bool along_x = pier.wall == "front" || pier.wall == "rear";
  const double aside = along_x ? h.nonbearing_wall : h.bearing_wall, half = 0.5 * (h.brick[0] + h.mortar);
  pier.width = (h.brick[1] + h.mortar) * dice.whole(1, 3);
  pier.from = dice.place(aside + half, h.inner_size[along_x ? 0 : 1] - 2 * half - pier.width, dice.one_in(3) ? 0.01 : 0.1);
  pier.depth = dice.pick(0.15, 0.4, 0.05);
  if (dice.one_in(2)) pier.height = dice.pick(0.2, 0.6, 0.1);
  h.piers.push_back(pier);
}

/// Thickness of the uppermost walls, on which the roof lies.
inline double top_bearing(const House& h) {
  return h.storeys.empty() ? h.bearing_wall : h.storeys.back().bearing_wall.value_or(h.bearing_wall);
}

inline void add_storey(Dice& dice, House& h) {
  const auto thinner = [&](double wall) { return wall - h.brick[1] * dice.whole(0, wall > 2.5 * h.brick[1] ? 1 : 0); };
  Storey upper{dice.pick(0.5, 0.9, dice.one_in(3) ? 0.01 : 0.1), {}, {}};
  if (h.mortar == 0.0 && dice.one_in(2)) upper.bearing_wall = thinner(h.bearing_wall);
  if (h.mortar == 0.0 && dice.one_in(2)) upper.nonbearing_wall = thinner(h.nonbearing_wall);
  h.storeys.push_back(upper);
  for (Opening& o : h.openings) o.storey = dice.whole(1, 2);
}

inline void add_inner_walls(Dice& dice, House& h) {
  const double step = dice.one_in(3) ? 0.01 : 0.1;
  for (int i = dice.whole(1, 2); i > 0; --i) {
    InnerWall wall;
    wall.name = "inner " + std::to_string(i);
    wall.along = dice.one_in(2) ? PlanAxis::x : PlanAxis::y;
    wall.thickness = (h.brick[1] + h.mortar) * dice.whole(1, 2);
    const double aside = wall.along == PlanAxis::x ? h.bearing_wall : h.nonbearing_wall, half = 0.5 * (h.brick[0] + h.mortar);
    wall.at = dice.place(aside + half, h.inner_size[wall.along == PlanAxis::x ? 1 : 0] - 2 * half - wall.thickness, step);
    if (dice.one_in(4)) wall.storeys = {1};
    h.inner_walls.push_back(wall);
    if (dice.one_in(3)) h.openings.push_back(opening(wall.name, dice.pick(0.3, 1.0, step), dice.pick(0.2, 0.5, step), 0.0, 0.2));
  }
}

inline void add_floor(Dice& dice, House& h) {
  Floor f;
  f.storey = dice.whole(1, h.storeys.empty() ? 1 : 2);
  f.along = dice.one_in(2) ? PlanAxis::x : PlanAxis::y;
  f.beam = {dice.pick(0.08, 0.16, 0.02), dice.pick(0.06, 0.16, 0.02)};
  f.spacing = dice.pick(0.25, 0.5, 0.05);
  f.bearing = h.brick[1] + h.mortar;
  f.element = dice.pick(0.15, 0.3, 0.05);
  if (dice.one_in(2)) f.load = dice.pick(20.0, 200.0, 20.0);
  if (dice.one_in(3)) f.deck = Deck{.shear_stiffness = 1e6, .shear_strength = 1e3, .stiffness = 1e7, .strength = 1e4};
  h.floors.push_back(f);
}

inline void add_roof(Dice& dice, House& h) {
  Roof& r = h.roof;
  r.kind =
      std::array{
          RoofKind::none, RoofKind::flat, RoofKind::vault, RoofKind::vault, RoofKind::gables, RoofKind::pitched}[static_cast<std::size_t>(
          dice.whole(0, 5))];
  r.pitch = dice.pick(10.0, 50.0, 0.5);
  r.spacing = dice.pick(0.3, 0.8, 0.1);
  if (r.kind == RoofKind::pitched && dice.one_in(2))
    r.deck = Deck{.shear_stiffness = 1e6, .shear_strength = {}, .stiffness = 1e7, .strength = {}};
  if (r.kind == RoofKind::pitched && dice.one_in(2)) r.tie.emplace().area = 1e-4;
  r.beam = {dice.pick(0.1, 0.3, 0.05), dice.pick(0.1, 0.2, 0.05)};
  r.element = dice.pick(0.15, 0.3, 0.05);
  const double wall = top_bearing(h), room = h.inner_size[1] + 2 * (h.bearing_wall - wall);
  if (r.kind == RoofKind::flat && dice.one_in(4)) r.bearing = dice.pick(0.05, dice.one_in(8) ? 0.5 : wall, 0.01);
  r.thickness = std::min(wall, dice.pick(0.1, 0.3, 0.05));
  const double play = wall - r.thickness;
  r.radius = 0.5 * room + 0.001 * dice.whole(0, static_cast<int>(1000 * play));
  r.voussoirs = std::max(3, static_cast<int>(std::numbers::pi * r.radius / dice.pick(0.15, 0.4, 0.01)));
  r.ring = dice.pick(0.1, 0.3, 0.03);
  if (dice.one_in(3) && r.kind != RoofKind::none && r.kind != RoofKind::gables) r.surcharge = dice.pick(10.0, 200.0, 10.0);
}

inline void add_leaves(Dice& dice, House& h) {
  Leaves leaves;
  leaves.joint = "weak";
  const double width = h.brick[1] + h.mortar;
  const bool anywhere = dice.one_in(20);
  if (h.bearing_wall > 1.5 * width || anywhere) leaves.walls = {"front", "rear"};
  if (h.nonbearing_wall > 1.5 * width || anywhere) leaves.walls.emplace_back("left");
  if (leaves.walls.empty()) return;
  if (dice.one_in(2)) leaves.outer = width * (dice.one_in(8) ? 2 : 1);
  if (dice.one_in(2)) leaves.through = ThroughStones{dice.pick(0.6, 1.2, 0.1), dice.whole(2, 5), {}};
  h.leaves = leaves;
}

inline void add_reinforcement(Dice& dice, House& h) {
  Reinforcement r;
  if (!h.storeys.empty() || !h.inner_walls.empty() || !h.floors.empty()) {
    if (h.roof.kind != RoofKind::none && h.roof.kind != RoofKind::flat && !dice.one_in(4)) return;
    r.ring_beam_place = RingPlace::middle;
    r.ring_beam = {dice.pick(0.05, 0.15, 0.05), dice.pick(0.05, 0.2, 0.05)};
    h.reinforcement = r;
    return;
  }
  r.column = {dice.pick(0.05, 0.15, 0.05), dice.pick(0.05, 0.15, 0.05)};
  r.ring_beam = {dice.pick(0.05, 0.15, 0.05), dice.pick(0.05, 0.2, 0.05)};
  for (int i = dice.whole(0, 3); i > 0; --i) r.bearing.push_back(h.nonbearing_wall + dice.pick(0.1, 1.5, 0.05));
  for (int i = dice.whole(0, 2); i > 0; --i) r.nonbearing.push_back(h.bearing_wall + dice.pick(0.1, 1.2, 0.05));
  r.element = dice.pick(0.15, 0.3, 0.05);
  h.reinforcement = r;
}

/// Any house; a third of them is refused.
inline Case random_case(Dice& dice) {
  Case c = testing::paper_flat20();
  House& h = *c.house;
  h.openings.clear();
  h.bond = std::array{Bond::english, Bond::running, Bond::header, Bond::flemish, Bond::rubble}[static_cast<std::size_t>(dice.whole(0, 4))];
  if (h.bond == Bond::rubble) h.rubble = Rubble{dice.whole(0, 1000), dice.pick(0.0, 1.0, 0.25), dice.pick(0.0, 1.0, 0.25)};
  const double step = dice.one_in(3) ? 0.013 : 0.1;
  h.inner_size = {dice.pick(0.6, 2.2, step), dice.pick(0.8, 2.4, step)};
  h.height = dice.pick(0.5, 1.2, 0.1);
  h.bearing_wall = dice.pick(0.1, 0.5, 0.1);
  h.nonbearing_wall = dice.pick(0.1, 0.4, 0.1);
  if (dice.one_in(4)) h.height = dice.pick(0.3, 1.2, 0.01);
  if (dice.one_in(6))
    h.brick = {0.25, 0.12, 0.065}, h.mortar = 0.01, h.bearing_wall = 0.26, h.nonbearing_wall = 0.13;
  else if (dice.one_in(5))
    h.brick = {0.24, 0.12, 0.08}, h.bearing_wall = 0.24, h.nonbearing_wall = 0.12, h.height = 0.64;
  add_openings(dice, h);
  if (dice.one_in(3)) add_storey(dice, h);
  if (dice.one_in(3)) add_inner_walls(dice, h);
  if (dice.one_in(3)) add_floor(dice, h);
  if (dice.one_in(4)) add_pier(dice, h);
  if (dice.one_in(3)) add_leaves(dice, h);
  add_roof(dice, h);
  if (dice.one_in(3)) add_reinforcement(dice, h);
  const bool four_walls = h.reinforcement || !h.floors.empty() || !h.piers.empty();
  if (dice.one_in(6) && (!four_walls || dice.one_in(4))) h.walls = {"front", "rear", "left"};
  if (dice.one_in(8)) add_base_part(dice, c);
  if (dice.one_in(4) && c.base->parts.empty()) h.copies = {2, 1};
  h.turn = 90.0 * dice.whole(0, 3);
  h.origin = {dice.pick(-3.0, 3.0, 0.1), dice.pick(-3.0, 3.0, 0.01)};
  c.base->z = dice.one_in(5) ? 1.3 : 0.0;
  return c;
}

}  // namespace voussoir::testing
