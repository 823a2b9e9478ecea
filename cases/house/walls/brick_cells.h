// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "cases/house/house_plan.h"
#include "cases/model.h"

/// How many cells the bricks of a wall have (cases/solids/cells.h cuts them). Internal to cases/.
namespace voussoir::cases {

/// Cells of a piece of a wall: of a whole unit those asked for. A cut one has as many as make cells nearest in size to a whole one's, at
/// least one along each edge, so a piece shorter than a brick has fewer along its length.
/// \param asked  along the length of a whole unit, through its thickness, over its height \param unit  of a whole one laid like the piece:
/// along the wall; the thickness of a stretcher; height [m]
/// \param piece  along the wall, across it, upright [m]
/// \return along the wall, across it, upright. A piece one and a half times as deep as a unit is thick is a header, which has its length
/// across the wall.
CellCounts cells_of_piece(const CellCounts& asked, const std::array<double, 3>& unit, const std::array<double, 3>& piece, bool whole);

/// The unit of cells_of_piece for a piece in a wall of a house: bricks as wide as fill the wall. \param depth  of the piece
std::array<double, 3> cell_unit(const HousePlan& plan, const WallPlan& wall, Interval depth);

/// Counts along the wall, across it, upright, as counts by the three edges at the first vertex of a box in VTK's order.
/// \param along  unit vector, horizontal
CellCounts by_edges(const geometry::Polyhedron& box, Vec3 along, const CellCounts& counts);

}  // namespace voussoir::cases
