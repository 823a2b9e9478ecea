// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/house/house_courses.h"
#include "cases/walls/wall_plan.h"

/// Gables and parapets: walls whose tops rise. Internal to cases/.
namespace voussoir::cases {

/// Sets Leg::hills of the walls' own tops (WallSpec::tops, WallSpec::gable). \pre walls have met \throw InputError, InputErrors
void add_own_tops(const std::vector<WallSpec>& walls, WallsPlan& plan);

/// Raises a leg. \param top  s, and height above the base [m], ascending in s; a hill for each part of it that is convex upwards
/// \throw InputError at `key` where the leg has risen already, or bends
void raise(const WallSpec& wall, const geometry::Polygon& top, const std::string& key, Leg& leg);

/// Adds the heights of level tops to those at which courses end. \param wall  index of it
void add_top_levels(const WallSpec& wall, const WallsPlan& plan, std::size_t index, std::vector<Level>& levels);

/// The highest crown of a group of walls, above the base; 0: none rises.
Tick crown_of(const WallsPlan& plan, std::size_t group);

/// Sets Hill::last: a top course of less than half a brick is one with that below. \throw InputErrors for hills that are less than a brick
void finish_hills(const std::vector<WallSpec>& walls, WallsPlan& plan);

}  // namespace voussoir::cases
