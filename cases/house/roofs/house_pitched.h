// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cases/house/floors/house_decks.h"
#include "cases/house/house_plan.h"
#include "cases/house/house_ties.h"
#include "geometry/polygon.h"
#include "geometry/polyhedron.h"

/// Pairs of rafters that meet in a ridge along x over the middle of the house. Internal to cases/.
namespace voussoir::cases {

/// The front rafter of a pair in the plane (y, z) of the house [m]; the rear rafter is its mirror image. The foot has a level seat on the
/// bearing wall, from the inner face outwards, for at most half of the rafter's depth; feet and ridge are cut plumb.
struct RafterProfile {
  geometry::Polygon section;             // counter-clockwise
  std::vector<double> cuts;              // y of the planes between elements, from foot to ridge, both ends included
  double foot = 0.0, inner = 0.0;        // y of the seat's ends
  double ridge = 0.0, seat = 0.0;        // y of the ridge, z of the seat
  double slope = 0.0, depth = 0.0;       // tangent of the pitch; plumb depth of a rafter
  double upper = 0.0;                    // m, length of its upper face
  std::vector<std::array<double, 2>> x;  // from and to of each rafter, along the house

  [[nodiscard]] double across() const noexcept { return 2.0 * ridge; }
  [[nodiscard]] double underside(double y) const noexcept { return seat + (y - inner) * slope; }
};

/// What a pair of rafters rests on.
struct RafterSeat {
  double inner = 0.0, ridge = 0.0;  // m, y of the wall's inner face and of the ridge
  double height = 0.0;              // m, z of the seat
  double most = 0.0;                // m, greatest length of the seat
  double length = 0.0;              // m, of the roof along its ridge
};

/// Lays out the rafters of a roof from x = 0. \param key  of the roof \throw InputError with the key at fault
RafterProfile rafter_profile(const Roof& roof, const RafterSeat& seat, const std::string& key);
RafterProfile rafter_profile(const House& house, const HousePlan& plan);

/// An element of a rafter. Rafters are numbered pair by pair, the front one first.
struct RafterElement {
  int rafter = 0;
  geometry::Polyhedron shape;
  bool whole = false;
};
std::vector<RafterElement> rafter_elements(const RafterProfile& profile);

/// Ends of the ties between the feet of all pairs.
std::vector<std::array<Vec3, 2>> rafter_tie_ends(const RafterProfile& profile);

/// The boards on rafters. \throw InputError at `key` if a rafter has less than two elements
PlannedDeck rafter_deck(const RafterProfile& profile, const Deck& deck, const std::string& key);

/// Density that a surcharge adds to rafters [kg/m3]. \param length  m, of the roof along its ridge
double rafter_surcharge(const RafterProfile& profile, const Roof& roof, double length);

/// Section of the space under the rafters, to which gables are cut: corners from the front over the ridge to the rear [m].
geometry::Polygon pitched_gable(const RafterProfile& profile, const HousePlan& plan);

/// Density that a roof's surcharge adds to its rafters [kg/m3].
double rafter_surcharge(const House& house, const HousePlan& plan);

/// The ties between the feet of all pairs of rafters, in all copies; empty without house.roof.tie. \param foot  m, height of the walls'
/// foot
std::vector<PlannedTie> roof_ties(const House& house, double foot);

}  // namespace voussoir::cases
