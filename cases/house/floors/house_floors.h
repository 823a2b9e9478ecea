// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"
#include "cases/house/house_ties.h"

/// Floors of beams in pockets, their anchors and decks. Internal to cases/.
namespace voussoir::cases {

/// The ranges of beams across a room, `spacing` from axis to axis: as many as fit, half of the remaining length at either end.
std::vector<Interval> beams_in(Interval room, Tick width, Tick spacing);

/// The end of a beam in its wall, in the middle of its width and height. Lengths along the beam.
struct BeamEnd {
  Vec3 at;                // m
  Vec3 inwards;           // unit vector along the beam
  double bearing = 0.0;   // m, to the wall's inner face
  double behind = 0.0;    // m, to the wall's outer face
  double underside = 0.0; // m, height of the beam's underside
  double course = 0.0;    // m, height of a brick
};

/// The tie of a floor that holds a beam's end: from the beam through its end to the wall's outer face, or, nailed, to the middle of the
/// bricks under it. \pre the floor has an anchor
Tie beam_anchor(const Floor& floor, const BeamEnd& end);

/// Density that the load of a floor adds to its beams [kg/m3]: each bears a strip as wide as their spacing. \param key  of the load
/// \throw InputError for a load out of range
double floor_load_density(const Floor& floor, const std::string& key);

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
