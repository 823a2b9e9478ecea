// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "io/output/measures/crack_extents.h"

/// Damage grades of the European Macroseismic Scale (EMS-98) for masonry buildings, from computed quantities. The scale is worded for
/// inspection of a building from outside; its interpretation here is explained in io/MEASURES.md.
namespace voussoir::io {

/// Lower bounds of the shares of walls that the scale calls many and most (as in the paper's introduction: a few up to 20 %, many 20 to 60
/// %, most above).
inline constexpr double kManyWalls = 0.2, kMostWalls = 0.6;
/// Extents (see CrackExtent) from which a wall is cracked, and from which its cracks are extensive: from end to end.
inline constexpr double kCracked = 0.1, kExtensive = 1.0;
/// Fallen share of the mass of a wall or of the roof that counts as failure of a part, not of single bricks.
inline constexpr double kPartOfMass = 0.05;
/// Fallen share of a wall's mass that counts as serious failure: "many" of its bricks in EMS-98.
inline constexpr double kSeriousLoss = 0.2;
/// Lean of a wall that counts as serious failure, in thicknesses: half of that at which a rigid wall loses its balance.
inline constexpr double kSeriousLean = 0.5;
/// Fallen share of all mass that counts as near total collapse: "most" of it.
inline constexpr double kNearTotalLoss = 0.6;

struct WallDamage {
  CrackExtent cracks;
  double fallen = 0;  // share of the wall's mass
  double lean = 0;    // out-of-plane displacement of its top in thicknesses; 0 for a wall that no longer stands
};

struct BuildingDamage {
  std::vector<WallDamage> walls;
  double fallen_roof = 0;  // share of the roof's mass; 0 without a roof
  double fallen = 0;       // share of all mass
  bool collapsed = false;  // see solver/run/collapse.h
};

/// Damage grade from 0 (no damage) to 5: the highest grade with a criterion that holds. \pre there is a wall
int damage_grade(const BuildingDamage& damage);

}  // namespace voussoir::io
