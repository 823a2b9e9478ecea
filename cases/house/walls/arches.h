// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "cases/house/house_parts.h"
#include "cases/house/house_plan.h"

/// Arches over openings. Internal to cases/.
///
/// An arch fills a rectangle of the wall, its frame, from the springing to the course above it, so that joints with the wall are plane. Its
/// soffit is a polygon on a circle, or level; its joints run from the corners of the soffit straight away from the centre to the edge of
/// the frame. What is left at either end is a springer with the skewback.
namespace voussoir::cases {

/// The frame over an opening, upon its lintel if it has one. \param under  what it stands over; along: the opening
/// \throw InputError with the key at fault: sizes that make no arch, a frame higher than the wall. Where it lies is for the caller to
/// check.
Hole arch_hole(const House& house, const Hole& opening, const HousePlan& plan, const WallPlan& wall);

/// Level of its springing above the foot of the house, and of the frame's top.
Interval arch_height(const Opening& opening, Tick head) noexcept;

/// Adds springers and voussoirs, from end to end, row by row through the wall.
void add_arch(const House& house, const HousePlan& plan, const WallPlan& wall, const Hole& hole, HouseParts& parts);

}  // namespace voussoir::cases
