// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"
#include "cases/house/house_ties.h"

/// Floors of beams in pockets, their anchors and decks. Internal to cases/.
namespace voussoir::cases {

/// "house.floor[1].bearing"
std::string floor_key(std::size_t floor, const char* field = "");

/// The walls in which beams end.
struct BeamEnds {
  Side low, high;
};
BeamEnds ends_of(const Floor& floor) noexcept;

/// Lays out the beams of all floors and cuts their pockets into the walls. In each room beams lie `spacing` apart, as many as fit, with
/// half of the remaining length at either end. \pre openings are planned
/// \throw InputError with the key at fault: a storey that does not exist or has a floor already, a pocket deeper than its wall, a beam over
/// an opening, or one too long for elements of its length.
void plan_floors(const House& house, HousePlan& plan);

/// Anchors of beam ends in walls, in all copies; PlannedTie::index is the floor. \param foot  m, height of the walls' foot
std::vector<PlannedTie> beam_anchors(const House& house, double foot);

}  // namespace voussoir::cases
