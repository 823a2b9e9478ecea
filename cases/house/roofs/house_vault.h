// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"
#include "geometry/polygon.h"

/// The barrel vault along x and the gables under it. Internal to cases/.
namespace voussoir::cases {

/// Corners of the voussoirs of a ring in the plane (y, z) of the house [m], from the front springing over the crown to the rear springing;
/// a ring has one voussoir less than corners. The two halves are mirror images bit by bit.
struct VaultProfile {
  geometry::Polygon inner, outer;
};

/// Rise [m] of the profile that gables end under, above its springing.
double height_of(const geometry::Polygon& under) noexcept;

/// The profile of house.roof, with its axis over the middle of the house at the height of the walls.
/// \throw InputError with the key at fault and the nearest value that fits: a vault must stand on the bearing walls with its whole
/// thickness, gables on the non-bearing walls.
VaultProfile vault_profile(const House& house, const HousePlan& plan);

/// Density [kg/m3] that a roof's surcharge adds to its beams or voussoirs.
double surcharge_density(const House& house) noexcept;

}  // namespace voussoir::cases
