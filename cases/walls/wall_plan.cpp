// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cases/house/house_wall.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_floors.h"
#include "cases/walls/spans/wall_roofs.h"
#include "cases/walls/spans/wall_vaults.h"
#include "cases/walls/wall_courses.h"
#include "cases/walls/wall_layout.h"
#include "cases/walls/wall_legs.h"
#include "cases/walls/wall_meetings.h"
#include "cases/walls/wall_storeys.h"
#include "cases/walls/wall_tops.h"

namespace voussoir::cases {
namespace {

constexpr double kMostBricks = 2e6;  // a limit against typing errors

Bond bond_of(WallBond bond) noexcept {
  switch (bond) {
    case WallBond::english:
      return Bond::english;
    case WallBond::header:
      return Bond::header;
    case WallBond::running:
    case WallBond::through:
      break;
  }
  return Bond::running;
}

HousePlan bricks_of(const WallSpec& wall, std::size_t index) {
  HousePlan bricks;
  const std::string key = wall_key(index, "brick");
  bricks.brick_length = positive_length(wall.brick[0], key);
  bricks.brick_width = positive_length(wall.brick[1], key);
  bricks.brick_height = positive_length(wall.brick[2], key);
  if (bricks.brick_width > bricks.brick_length)
    throw InputError(key, "is " + text(wall.brick[1]) + " m wide and " + text(wall.brick[0]) + " m long; its length is the longer side");
  bricks.bond = bond_of(wall.bond);
  return bricks;
}

/// Refuses walls of more bricks than can be meant. \throw InputError at the brick of the wall that has most
void check_number(const std::vector<WallSpec>& walls, const WallsPlan& plan) {
  std::vector<double> bricks(walls.size(), 0.0);
  for (const Leg& leg : plan.legs) {
    const WallSpec& w = walls[leg.wall];
    double high = std::max(w.height, w.gable.value_or(0.0));
    for (const auto& top : w.tops) high = std::max(high, top[1]);
    bricks[leg.wall] += leg.length() * w.thickness * high / (w.brick[0] * w.brick[1] * w.brick[2]);
  }
  if (std::accumulate(bricks.begin(), bricks.end(), 0.0) <= kMostBricks) return;
  const auto most = std::ranges::max_element(bricks);
  throw InputError(wall_key(static_cast<std::size_t>(most - bricks.begin()), "brick"),
                   "makes about " + text(std::round(*most)) + " bricks of the wall; all walls together may have " + text(kMostBricks));
}

void check_names(const std::vector<WallSpec>& walls, Faults& faults) {
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (walls[i].name.empty()) faults.add({wall_key(i, "name"), "is missing; every wall has a name of its own"});
    for (std::size_t k = 0; k < i; ++k) {
      if (walls[k].name == walls[i].name)
        faults.add({wall_key(i, "name"), quoted(walls[i].name) + " is already the name of " + indexed_key("wall", k, "")});
    }
  }
}

}  // namespace

std::string wall_key(std::size_t wall, const char* field) { return indexed_key("wall", wall, field); }

double least_piece(const WallSpec& wall) noexcept { return wall.brick[0] / 5.0; }

std::vector<Wythe> wythes_of(const WallSpec& wall, const HousePlan& bricks, int course) {
  const Tick thickness = ticks(wall.thickness);
  if (wall.bond != WallBond::through) return wythes(bricks, thickness, course);
  return {{{0, thickness}, bricks.brick_length, course % 2 == 0 ? 0 : bricks.brick_length / 2}};
}

WallsPlan plan_walls(const std::vector<WallSpec>& walls, const WallSpans& spans) {
  WallsPlan plan;
  std::vector<Corner> corners;
  Faults faults;
  check_names(walls, faults);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    plan.bricks.emplace_back();
    faults.attempt([&] {
      plan.bricks[i] = bricks_of(walls[i], i);
      add_legs(walls[i], i, plan, corners);
    });
  }
  faults.raise();
  check_number(walls, plan);
  find_meetings(walls, corners, plan);
  faults.attempt([&] { add_own_tops(walls, plan); });
  faults.attempt([&] { plan_wall_roofs(walls, spans.roofs, plan); });
  faults.attempt([&] { plan_wall_vaults(walls, spans.vaults, plan); });
  faults.attempt([&] { add_wall_openings(walls, plan); });
  faults.attempt([&] { plan_wall_floors(walls, spans.floors, plan); });
  faults.attempt([&] { plan_wall_courses(walls, spans.floors, plan); });
  faults.raise();
  finish_hills(walls, plan);
  check_layout(walls, plan);
  find_wall_storeys(plan);
  return plan;
}

}  // namespace voussoir::cases
