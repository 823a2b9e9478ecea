// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/house/house_plan.h"
#include "cases/house/house_ties.h"
#include "geometry/polygon.h"

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

  [[nodiscard]] double underside(double y) const noexcept { return seat + (y - inner) * slope; }
};

/// Lays out the rafters. \throw InputError with the key at fault
RafterProfile rafter_profile(const House& house, const HousePlan& plan);

/// Section of the space under the rafters, to which gables are cut: corners from the front over the ridge to the rear [m].
geometry::Polygon pitched_gable(const RafterProfile& profile, const HousePlan& plan);

/// Density that a roof's surcharge adds to its rafters [kg/m3].
double rafter_surcharge(const House& house, const HousePlan& plan);

/// The ties between the feet of all pairs of rafters, in all copies; empty without house.roof.tie. \param foot  m, height of the walls'
/// foot
std::vector<PlannedTie> roof_ties(const House& house, double foot);

}  // namespace voussoir::cases
