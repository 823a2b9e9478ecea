// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "io/output/measures/crack_extents.h"

/// Damage grades of the European Macroseismic Scale (EMS-98) for masonry buildings, read from quantities. The scale is written for people
/// who look at a building from outside; what its words mean here, and why, stands in io/MEASURES.md.
namespace voussoir::io {

/// Shares of walls that the scale calls many and most (as the paper's introduction: a few up to 20 %, many 20 to 60 %, most above).
inline constexpr double kManyWalls = 0.2, kMostWalls = 0.6;
/// Extent (see CrackExtent) from which a wall counts as cracked, and from which its cracks are extensive: from end to end.
inline constexpr double kCracked = 0.1, kExtensive = 1.0;
/// Fallen share of the mass of a wall or of the roof that is the failure of a part, not of single bricks.
inline constexpr double kPartOfMass = 0.05;
/// Fallen share of a wall's mass that is a serious failure: EMS-98's "many" of its bricks.
inline constexpr double kSeriousLoss = 0.2;
/// Lean of a wall that is a serious failure, in thicknesses: half of that at which a rigid wall loses its balance.
inline constexpr double kSeriousLean = 0.5;
/// Fallen share of all mass that is near total collapse: "most" of it.
inline constexpr double kNearTotalLoss = 0.6;

struct WallDamage {
  CrackExtent cracks;
  double fallen = 0;  // share of the wall's mass
  double lean = 0;    // out-of-plane displacement of its top in thicknesses; 0 of a wall that does not stand
};

struct BuildingDamage {
  std::vector<WallDamage> walls;
  double fallen_roof = 0;  // share of the roof's mass; 0 without a roof
  double fallen = 0;       // share of all mass
  bool collapsed = false;  // solver/run/collapse.h
};

/// 0 (no damage) to 5: the highest grade of which something holds. \pre there is a wall
int damage_grade(const BuildingDamage& damage);

}  // namespace voussoir::io
