// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/walls/wall_plan.h"

/// Storeys of walls: a wall upon another, and the parts of a wall between floors. Internal to cases/.
namespace voussoir::cases {

/// Sets Leg::storey, Leg::storeys and WallsPlan::storeys. A storey ends in a wall at the upper faces of beams that lie in it or in the
/// walls round their room, and where a wall that meets it stands upon another. Levels that would leave a part of less than half the
/// greatest distance between two of them part nothing. \pre floors are planned
void find_wall_storeys(WallsPlan& plan);

/// Tag of what a leg has in a range of heights above the base: "street wall"; "street gable" above the height of its wall; if any wall of
/// the case has a second storey, with its own: "street wall, storey 2".
std::string part_tag(const WallsPlan& plan, const Leg& leg, Interval height);

/// How far a face of a leg reaches beyond the walls on which the leg stands [m], in the middle of the places where it does; 0 where that is
/// less than half of its length. \param left  the face at d > 0
double overhang(const WallsPlan& plan, const Leg& leg, bool left);

}  // namespace voussoir::cases
