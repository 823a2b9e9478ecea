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
  std::optional<std::array<int, 3>> cells;  // of whole bricks; materials.<name>.inside is the law between them
  std::string material;
  WallMeeting meeting = WallMeeting::toothed;
  double load = 0.0;  // kg per m of its length, carried by the course that ends at `height`
  std::vector<std::array<double, 2>>
      tops;                     // m: places along the wall's line, and the height of its top there, straight from one to the next
  std::optional<double> gable;  // m, height of its top in the middle of a wall of one side; at its ends it is `height`
  std::vector<WallOpening> openings;
};

/// Beams between two sides of walls, in pockets or upon the walls. A side has the name of its wall, with a number if there are several.
struct WallFloor {
  std::string name;
  std::vector<std::string> walls;                  // the two sides
  std::vector<std::array<double, 2>> corners;      // m, four in turn: beams lie within this quadrilateral; none: in all that lies between
  std::optional<std::array<double, 2>> direction;  // of the beams in plan; none: square to the first side
  std::optional<double> level;                     // m, of the beams' upper faces above the base; none: the lower top of the two
  std::string material, within_member = "wood";    // within_member: law between elements of a beam
  Floor beams;                                     // its storey and `along` are not used
};

/// Pairs of rafters between two parallel sides of walls of the same height.
struct WallRoof {
  std::string name;
  std::vector<std::string> walls;              // the two sides
  std::vector<std::string> gables;             // sides that rise to the rafters' underside
  std::vector<std::array<double, 2>> corners;  // m, as of a floor
  std::string material, within_member = "wood", joint = "dry";
  Roof rafters;  // its kind and what belongs to other kinds are not used
};

/// barrel: rings side by side on two parallel sides. cross: two barrels that cut each other, over a rectangle; their webs meet over the
/// diagonals and bear on the corners and the walls, which rise to them. pavilion: level courses along four sides, mitred over the
/// diagonals. dome: the same along a closed round wall.
enum class VaultKind { barrel, cross, pavilion, dome };

/// A vault between sides of walls of the same height, feet cut level on the walls.
struct WallVault {
  std::string name;
  VaultKind kind = VaultKind::barrel;
  std::vector<std::string> walls;              // two sides; of a cross or pavilion vault four, in turn; of a dome one
  std::vector<std::string> gables;             // barrel: sides that rise to the vault's soffit
  std::vector<std::array<double, 2>> corners;  // m, barrel: as of a floor
  std::string material;
  std::optional<double> rise;    // m, of the soffit above its springing; none: half the span
  std::optional<double> oculus;  // m, pavilion, dome: width of an opening in the crown at the soffit; none: a keystone
  double thickness = 0.2;        // m
  double ring = 0.2;             // m, barrel: length of a ring along the axis; others: of a voussoir along its course
  int voussoirs = 25;            // from wall to wall
  double surcharge = 0.0;        // kg/m2 of the outer face
};

/// What spans between walls.
struct WallSpans {
  std::vector<WallFloor> floors;
  std::vector<WallRoof> roofs;
  std::vector<WallVault> vaults;
};

}  // namespace voussoir::cases
