// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/house/house_plan.h"
#include "cases/house/house_ties.h"
#include "geometry/polygon.h"

/// Pairs of rafters that meet in a ridge along x over the middle of the house. Internal to cases/.
namespace voussoir::cases {

/// The front rafter of a pair in the plane (y, z) of the house [m]; the rear one is its mirror image. Its foot has a level seat on the
/// bearing wall, from the inner face outwards, for half of its depth at most; feet and ridge are cut plumb.
struct RafterProfile {
  geometry::Polygon section;             // counter-clockwise
  std::vector<double> cuts;              // y of the planes between its elements, from foot to ridge, both ends included
  double foot = 0.0, inner = 0.0;        // y of the seat's ends
  double ridge = 0.0, seat = 0.0;        // y of the ridge, z of the seat
  double slope = 0.0, depth = 0.0;       // tangent of the pitch; plumb depth of a rafter
  double upper = 0.0;                    // m, length of its upper face
  std::vector<std::array<double, 2>> x;  // from and to of each rafter, along the house

  [[nodiscard]] double underside(double y) const noexcept { return seat + (y - inner) * slope; }
};

/// \throw InputError with the key at fault
RafterProfile rafter_profile(const House& house, const HousePlan& plan);

/// What the gables end under: their corners from the front over the ridge to the rear.
geometry::Polygon pitched_gable(const RafterProfile& profile, const HousePlan& plan);

/// kg/m3, that a roof's surcharge adds to the density of its rafters.
double rafter_surcharge(const House& house, const HousePlan& plan);

/// The ties from foot to foot of all pairs, in all copies; none without house.roof.tie.
std::vector<PlannedTie> roof_ties(const House& house, double foot);

}  // namespace voussoir::cases
