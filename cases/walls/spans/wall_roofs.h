// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cases/house/floors/house_decks.h"
#include "cases/house/house_ties.h"
#include "cases/model.h"
#include "cases/walls/wall_plan.h"

/// Pitched roofs between walls: rafters as those of houses. Internal to cases/.
namespace voussoir::cases {

/// Finds the bays of all roofs (WallsPlan::roofs) and raises their gables (Leg::hills). \pre walls have met \throw InputError, InputErrors
void plan_wall_roofs(const std::vector<WallSpec>& walls, const std::vector<WallRoof>& roofs, WallsPlan& plan);

/// Materials of rafters under a surcharge.
std::vector<NamedMaterial> loaded_roof_materials(const std::vector<WallSpec>& walls, const WallsPlan& plan,
                                                 const std::vector<WallRoof>& roofs, std::span<const NamedMaterial> materials);

/// Appends the rafters, roof by roof. The base is z = 0. \param members  timber members so far
void add_rafters(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallRoof>& roofs,
                 std::span<const NamedMaterial> materials, std::int32_t& members, std::vector<Block>& blocks);

/// The ties between the feet of rafters of all roofs; PlannedTie::index is the roof. \param foot  m, height of the base
std::vector<PlannedTie> wall_roof_ties(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallRoof>& roofs,
                                       double foot);

/// The boards of a roof. \throw InputError if they span no rafters
PlannedDeck wall_roof_deck(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallRoof>& roofs, std::size_t index,
                           double foot);

}  // namespace voussoir::cases
