// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cases/house/house_case.h"

/// Walls of any plan as plain data: [[wall]] of the case file. SI units.
namespace voussoir::cases {

/// A lintel of one piece, as thick as the wall.
struct WallLintel {
  double bearing = 0.2;                 // m, on the wall at either side
  double height = 0.1;                  // m
  std::optional<std::string> material;  // none: that of the wall
};
struct WallOpening {
  double from = 0.0;                             // m, along the wall's line from its first point
  double width = 0.0, sill = 0.0, height = 0.0;  // m; sill: above the foot of the wall
  std::optional<WallLintel> lintel;
  std::optional<Arch> arch;  // on the lintel if there is one, as in a house; its material: none: that of the wall
};
/// running, english, header: as in a house. through: one block through the wall, in running bond.
enum class WallBond { running, english, header, through };
/// Which line of the wall the points give, seen from the first point to the next.
enum class WallLine { left, middle, right };
/// What a wall does where it meets walls before it in the case: toothed, it runs through them in every second course, and they through it;
/// butt: they run through in all courses.
enum class WallMeeting { toothed, butt };

/// A wall along a polyline. Bends below 30 degrees are laid round; at greater ones, corners, its two sides are toothed.
struct WallSpec {
  std::string name;
  std::vector<std::array<double, 2>> points;  // m
  bool closed = false;                        // the last point is joined to the first
  WallLine line = WallLine::middle;
  double thickness = 0.0;                      // m
  double base = 0.0;                           // m, height of its foot above the base of the case
  double height = 0.0;                         // m
  std::array<double, 3> brick{0.2, 0.1, 0.1};  // m, length, width, height with mortar: adapted so that whole ones fill the wall
  WallBond bond = WallBond::english;
  std::string material;
  WallMeeting meeting = WallMeeting::toothed;
  double load = 0.0;  // kg per m of its length, carried by its top course
  std::vector<WallOpening> openings;
};

}  // namespace voussoir::cases
