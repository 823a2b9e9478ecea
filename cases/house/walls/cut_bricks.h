// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygon.h"

/// Bricks of a course that are cut along its top, as of gables, in the plane of the wall. Internal to cases/.
namespace voussoir::cases {

/// A brick: its joints along the wall [m] and its section as cut, (along, height).
struct CutBrick {
  double low = 0.0, high = 0.0;  // m
  geometry::Polygon section;
  double area = 0.0;  // m2
};

/// The part of a polygon between two heights and two positions along the wall. Corners on these lines lie on them exactly, since the
/// round-off of a cut would make equal bricks unequal.
geometry::Polygon part_between(const geometry::Polygon& under, double low, double high, double from, double to);

/// Cuts a brick out of the section of its course.
void cut_brick(const geometry::Polygon& section, CutBrick& brick);

/// Joins bricks smaller than `least` [m2] to the smaller of their neighbours. \pre all have been cut
void join_small(const geometry::Polygon& section, double least, std::vector<CutBrick>& all);

}  // namespace voussoir::cases
