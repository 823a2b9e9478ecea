// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/house/house_parts.h"
#include "cases/house/house_plan.h"
#include "geometry/polygon.h"

/// Arches over openings. Internal to cases/.
///
/// An arch fills a rectangle of the wall, its frame, from the springing to the course above it, so that joints with the wall are plane. Its
/// soffit is a polygon on a circle, or level; its joints run radially from the corners of the soffit to the edge of the frame. The
/// remainder at either end is a springer with the skewback.
namespace voussoir::cases {

/// Checks the sizes of an arch. \param span  clear, along the wall \param key  of its table, "house.opening[0].arch"
/// \throw InputError with the key at fault: sizes that make no arch
void check_arch(const Arch& arch, const HousePlan& plan, Interval span, const std::string& key);

/// Springers and voussoirs from the low end to the high end: sections along the wall and height [m], corners counter-clockwise.
/// \param plan  for the size of the bricks \param frame  heights, from the springing to its top
std::vector<geometry::Polygon> arch_sections(const Arch& arch, const HousePlan& plan, Interval span, Interval frame,
                                             const std::string& key);

/// Height range of a frame, from the springing to its top.
Interval arch_frame(const Arch& arch, Tick springing) noexcept;

/// Number of rows of an arch or a lintel through a wall.
Tick rows_through(const HousePlan& plan, Tick thickness) noexcept;

/// The frame over an opening, on its lintel if there is one.
/// \throw InputError with the key at fault: sizes that make no arch, a frame higher than the wall. The position of the frame is not
/// checked.
Hole arch_hole(const House& house, const Hole& opening, const HousePlan& plan, const WallPlan& wall);

/// Height range of the frame above the foot of the house, from the springing to its top.
Interval arch_height(const Opening& opening, Tick head) noexcept;

/// Adds springers and voussoirs, from end to end, row by row through the wall.
void add_arch(const House& house, const HousePlan& plan, const WallPlan& wall, const Hole& hole, HouseParts& parts);

}  // namespace voussoir::cases
