// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cases/house/floors/house_decks.h"
#include "cases/house/house_ties.h"
#include "cases/model.h"
#include "cases/walls/wall_plan.h"

/// Floors of beams between walls: as those of houses, in the bays of any plan. Internal to cases/.
namespace voussoir::cases {

/// Lays out the beams of all floors (WallsPlan::floors) and their pockets (Leg::pockets). In a bay, the walls that meet one of its two
/// walls part rooms; beams go through walls that stand between the two. \pre openings are planned \throw InputError, InputErrors
void plan_wall_floors(const std::vector<WallSpec>& walls, const std::vector<WallFloor>& floors, WallsPlan& plan);

/// Materials of the beams of floors with a load.
std::vector<NamedMaterial> loaded_floor_materials(const std::vector<WallFloor>& floors, std::span<const NamedMaterial> materials);

/// Appends the beams, floor by floor, element by element. The base is z = 0. \param members  timber members so far
void add_floor_beams(const WallsPlan& plan, const std::vector<WallFloor>& floors, std::span<const NamedMaterial> materials,
                     std::int32_t& members, std::vector<Block>& blocks);

/// What anchors the beams of all floors; PlannedTie::index is the floor. \param foot  m, height of the base
std::vector<PlannedTie> wall_beam_anchors(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallFloor>& floors,
                                          double foot);

/// The deck of a floor. \throw InputError if it spans no beams
PlannedDeck wall_floor_deck(const WallsPlan& plan, const std::vector<WallFloor>& floors, std::size_t index, double foot);

}  // namespace voussoir::cases
