// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/house/house_plan.h"
#include "cases/model.h"

/// What the rooms that build parts of a house add to. Internal to cases/.
namespace voussoir::cases {

/// One house in its own axes (outer corner at the origin, base at z = 0), as far as it is built.
struct HouseParts {
  std::vector<Block> blocks;
  std::int32_t masonry = 0, timber = 0, roof = 0;  // materials; roof: of beams or voussoirs, with their surcharge
  std::int32_t through = 0;                        // material of stones through both leaves of a wall
  std::vector<std::int32_t> floors;                // materials of their beams
  std::vector<std::int32_t> arches;                // materials of their voussoirs, by House::openings
  std::int32_t members = 0;                        // timber members so far
};

/// A box of the house, axes of the house.
struct HouseBox {
  Interval x, y, z;
};

/// The house's axes for a box in a wall's own coordinates.
HouseBox in_house(const HousePlan& plan, const WallPlan& wall, Interval along, Interval depth, Interval height) noexcept;

/// A point on or in a wall [m], axes of the house, from the wall's own coordinates.
Vec3 on_wall(const HousePlan& plan, Side side, double along, double depth, double height) noexcept;

/// The walls that a list names, or all that are built. \throw InputError at an entry of `key`.walls that names none
std::vector<Side> chosen_walls(const HousePlan& plan, const std::vector<std::string>& walls, const std::string& key);

/// From the axes of the house to those of the case, for copy (i, j).
Vec3 in_case(const House& house, const HousePlan& plan, int i, int j, Vec3 v) noexcept;

/// A quarter of the shortest edge of a whole unit, m.
double segment_size_of(Tick a, Tick b, Tick c) noexcept;

/// A block with shape and house fields set; `prototype` gives all else.
Block box_block(const HouseBox& box, const Block& prototype);

/// Adds the walls with their lintels, course by course.
void build_walls(const House& house, const HousePlan& plan, HouseParts& parts);

/// Adds the beams of floors, floor by floor, room by room.
void build_floors(const House& house, const HousePlan& plan, HouseParts& parts);

/// The height on which a flat roof lies: that of the walls, or of a ring beam upon them.
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

/// Takes the non-bearing walls on to the underside of the vault or the rafters, their bricks cut by it: prisms along x of three corners or
/// more.
/// \throw InputError with the key at fault.
void build_gables(const House& house, const HousePlan& plan, HouseParts& parts);

/// Adds columns at the inner faces of the walls, and ring beams there or upon the walls.
/// \throw InputError with the key at fault.
void build_reinforcement(const House& house, const HousePlan& plan, HouseParts& parts);

}  // namespace voussoir::cases
