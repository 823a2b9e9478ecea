// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/damage_grade.h"

#include <algorithm>

namespace voussoir::io {
namespace {

bool is_seriously_damaged(const WallDamage& w) { return w.fallen >= kSeriousLoss || w.lean >= kSeriousLean; }

template <class Test>
double share_of_walls(const BuildingDamage& d, const Test& test) {
  return static_cast<double>(std::ranges::count_if(d.walls, test)) / static_cast<double>(d.walls.size());
}

}  // namespace

int damage_grade(const BuildingDamage& d) {
  const auto any = [&](const auto& test) { return std::ranges::any_of(d.walls, test); };
  if (d.collapsed || d.fallen >= kNearTotalLoss) return 5;
  if (any(is_seriously_damaged) || d.fallen_roof >= kPartOfMass) return 4;
  if (share_of_walls(d, [](const WallDamage& w) { return w.cracks.large >= kExtensive; }) >= kMostWalls) return 3;
  if (any([](const WallDamage& w) { return w.fallen >= kPartOfMass; })) return 3;
  if (share_of_walls(d, [](const WallDamage& w) { return w.cracks.fine >= kCracked; }) >= kManyWalls) return 2;
  if (d.fallen > 0 || any([](const WallDamage& w) { return w.cracks.any >= kCracked; })) return 1;
  return 0;
}

}  // namespace voussoir::io
