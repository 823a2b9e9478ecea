// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/house/house_plan.h"
#include "cases/model.h"

/// The house under construction, to which the builders of its parts add. Internal to cases/.
namespace voussoir::cases {

/// One house in its own axes (outer corner at the origin, base at z = 0), as far as built.
struct HouseParts {
  std::vector<Block> blocks;
  std::int32_t masonry = 0, timber = 0, roof = 0;  // materials; roof: that of beams or voussoirs, including their surcharge
  std::int32_t through = 0;                        // material of through stones of a wall of two leaves
  std::vector<std::int32_t> floors;                // by floor: material of its beams
  std::vector<std::int32_t> arches;                // by House::openings: material of the voussoirs
  std::int32_t members = 0;                        // timber members so far
};

/// A box in axes of the house.
struct HouseBox {
  Interval x, y, z;
};

/// Transforms a box from a wall's own coordinates to axes of the house.
HouseBox in_house(const HousePlan& plan, const WallPlan& wall, Interval along, Interval depth, Interval height) noexcept;

/// Transforms a point [m] from a wall's own coordinates to axes of the house.
Vec3 on_wall(const HousePlan& plan, Side side, double along, double depth, double height) noexcept;

/// The walls named in a list, or all that are built if it is empty. \throw InputError at an entry of `key`.walls that names no wall
std::vector<Side> chosen_walls(const HousePlan& plan, const std::vector<std::string>& walls, const std::string& key);

/// Transforms a point from axes of the house to those of the case, for copy (i, j).
Vec3 in_case(const House& house, const HousePlan& plan, int i, int j, Vec3 v) noexcept;

/// Segment size [m]: a quarter of the shortest edge of a whole unit.
double segment_size_of(Tick a, Tick b, Tick c) noexcept;

/// A block with shape and house fields set; the other fields are copied from `prototype`.
Block box_block(const HouseBox& box, const Block& prototype);

/// Adds the walls and their lintels, course by course.
void build_walls(const House& house, const HousePlan& plan, HouseParts& parts);

/// Adds the beams of floors, floor by floor, room by room.
void build_floors(const House& house, const HousePlan& plan, HouseParts& parts);

/// Height of the seat of a flat roof: the top of the walls, or of a ring beam on them.
Tick roof_seat(const House& house, const HousePlan& plan);

/// Adds beams side by side along x over the whole house, each across it, resting on the inner brick length of the bearing walls.
/// \throw InputError with the key at fault.
void build_flat_roof(const House& house, const HousePlan& plan, HouseParts& parts);

/// Adds pairs of rafters over the whole house, on the bearing walls.
/// \throw InputError with the key at fault.
void build_pitched_roof(const House& house, const HousePlan& plan, HouseParts& parts);

/// Adds the rings of a barrel vault along x over the whole house.
/// \throw InputError with the key at fault.
void build_vault(const House& house, const HousePlan& plan, HouseParts& parts);

/// Extends the non-bearing walls to the underside of the vault or the rafters, with bricks cut to it: prisms along x of three or more
/// corners.
/// \throw InputError with the key at fault.
void build_gables(const House& house, const HousePlan& plan, HouseParts& parts);

/// Adds columns at the inner faces of the walls, and ring beams there or on the walls.
/// \throw InputError with the key at fault.
void build_reinforcement(const House& house, const HousePlan& plan, HouseParts& parts);

}  // namespace voussoir::cases
