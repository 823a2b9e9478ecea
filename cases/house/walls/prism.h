// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/house/house_plan.h"
#include "geometry/polygon.h"
#include "geometry/polyhedron.h"

/// Pieces of walls other than boxes. Internal to cases/.
namespace voussoir::cases {

/// A prism through a wall in axes of the house. \param section  along the wall and height [m], counter-clockwise \param depth  range
/// through the wall
geometry::Polyhedron wall_prism(const HousePlan& plan, const WallPlan& wall, const geometry::Polygon& section, Interval depth);

}  // namespace voussoir::cases
