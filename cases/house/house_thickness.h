// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/house/house_plan.h"

/// Walls as thick as they are said to be: bricks are made wider or narrower, not walls. Internal to cases/, but for adapted_walls().
namespace voussoir::cases {

/// The whole number of units nearest to a length, but so that none is more than a third longer than a unit. Units are not shortened by more
/// than a third where the length is two thirds of one or more.
Tick whole_number(Tick length, Tick unit) noexcept;

/// Number of bricks side by side through a wall or a leaf: the nearest number of brick widths, but so that none is more than a third wider
/// than a brick.
Tick widths_through(const HousePlan& plan, Tick thickness) noexcept;

/// Depth of the first k of them. They are thickness / widths_through() wide each, so a wall is as thick as it is said to be.
Tick depth_of_widths(const HousePlan& plan, Tick thickness, Tick k) noexcept;

/// A thickness of two thirds of a brick's width or more. \throw InputError at `key` if it is less, or beyond 10 km
Tick wall_thickness(double value, const HousePlan& plan, const std::string& key);

/// The same, or the least thickness with the fault in `faults`. \throw InputError if it is not above zero, or beyond 10 km
Tick wall_thickness(double value, const HousePlan& plan, const std::string& key, Faults& faults);

/// Walls of a house, or leaves of them, whose bricks are wider or narrower than a brick.
struct AdaptedWall {
  std::string name;            // "front wall, storey 1", "front wall, outer leaf"
  double thickness = 0.0;      // m
  int bricks = 0;              // side by side through it
  double width = 0.0;          // m, of each, with mortar
  double nominal_width = 0.0;  // m, of a brick with mortar
};
/// In the order of the plan; none for rubble, whose stones have no size of their own. \throw InputError if the house has a fault
std::vector<AdaptedWall> adapted_walls(const House& house);

}  // namespace voussoir::cases
