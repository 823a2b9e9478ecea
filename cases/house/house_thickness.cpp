// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_thickness.h"

#include <algorithm>
#include <cmath>

#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

/// Two thirds of a brick's width.
Tick least_thickness(const HousePlan& plan) noexcept { return (2 * plan.brick_width + 2) / 3; }

}  // namespace

Tick whole_number(Tick length, Tick unit) noexcept {
  const Tick nearest = std::max<Tick>(1, (2 * length + unit) / (2 * unit));
  return 3 * length > 4 * unit * nearest ? nearest + 1 : nearest;
}

Tick widths_through(const HousePlan& plan, Tick thickness) noexcept { return whole_number(thickness, plan.brick_width); }

Tick depth_of_widths(const HousePlan& plan, Tick thickness, Tick k) noexcept { return k * thickness / widths_through(plan, thickness); }

Tick wall_thickness(double value, const HousePlan& plan, const std::string& key) {
  const Tick thickness = positive_length(value, key), least = least_thickness(plan);
  if (thickness < least)
    throw InputError(key, text(value) + " m is less than two thirds of a brick's width; at least " +
                              text(std::ceil(1e3 * metres(least) - 1e-6) * 1e-3) + " m");
  return thickness;
}

Tick wall_thickness(double value, const HousePlan& plan, const std::string& key, Faults& faults) {
  Tick thickness = std::max(positive_length(value, key), least_thickness(plan));
  faults.attempt([&] { thickness = wall_thickness(value, plan, key); });
  return thickness;
}

std::vector<AdaptedWall> adapted_walls(const House& house) {
  std::vector<AdaptedWall> all;
  if (house.bond == Bond::rubble) return all;
  const HousePlan plan = plan_house(house);
  const auto add = [&](const std::string& name, Tick thickness) {
    const Tick count = widths_through(plan, thickness);
    if (thickness == count * plan.brick_width) return;
    all.push_back(
        {name, metres(thickness), static_cast<int>(count), metres(thickness) / static_cast<double>(count), metres(plan.brick_width)});
  };
  for (const WallPlan& wall : plan.walls) {
    if (!wall.built) continue;
    const std::string name = wall_tag(house, wall);
    if (wall.leaf == 0) {
      add(name, wall.thickness);
    } else {
      add(name + ", outer leaf", wall.leaf);
      add(name + ", inner leaf", wall.thickness - wall.leaf);
    }
  }
  return all;
}

}  // namespace voussoir::cases
