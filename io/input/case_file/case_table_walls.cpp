// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_tables.h"
#include "io/input/case_file/usual_ranges.h"

namespace voussoir::io {
namespace {

using namespace cases;

Table<WallLintel> wall_lintel_table() {
  using S = WallLintel;
  return {
      "one piece over an opening, as thick as the wall",
      {value<S>("bearing", &S::bearing, "m", above(0.0).usually(usual::kMember), "on the wall at either side, a fifth of a brick or more"),
       value<S>("height", &S::height, "m", above(0.0).usually(usual::kOpening), "height"),
       value<S>("material", &S::material, "", filled(), "a name of materials; none: that of the wall")},
      nullptr};
}

Table<WallOpening> wall_opening_table() {
  using S = WallOpening;
  return {
      "a door or a window, in one side of the wall",
      {required(value<S>("from", &S::from, "m", at_least(0.0).usually(usual::kHouse), "start along the wall's line from its first point")),
       required(value<S>("width", &S::width, "m", above(0.0).usually(usual::kOpening), "clear width")),
       value<S>("sill", &S::sill, "m", at_least(0.0).usually(usual::kLevel), "height of its lower edge above the foot of the wall"),
       required(value<S>("height", &S::height, "m", above(0.0).usually(usual::kOpening), "clear height")),
       table<S>("lintel", &S::lintel, wall_lintel_table())},
      nullptr};
}

}  // namespace

Table<WallSpec> wall_table() {
  using S = WallSpec;
  return {
      "a wall along any line of straight sides, with true dimensions; it is toothed at its corners and into the walls that it meets",
      {required(value<S>("name", &S::name, "", filled(), "a name of its own, for messages and results")),
       required(value<S>("points", &S::points, "m", any().usually(usual::kGround),
                         "[x, y] of its ends, corners and bends in turn. An end in another wall, or on its face, is a T-junction, or a "
                         "corner if the other ends there too; a wall that reaches through another one crosses it. Angles of corners and "
                         "junctions: 30 to 150 degrees; where it turns by less than 30, it bends")),
       value<S>("closed", &S::closed, "", any(), "whether the last point is joined to the first"),
       choice<S, WallLine S::*, WallLine>("line", &S::line, "",
                                          {{"left", WallLine::left}, {"middle", WallLine::middle}, {"right", WallLine::right}},
                                          "what the points are of: the middle of the wall, or its left or right face, seen along it"),
       required(value<S>("thickness", &S::thickness, "m", above(0.0).usually(usual::kThickness), "thickness")),
       value<S>("base", &S::base, "m", at_least(0.0).usually(usual::kLevel),
                "height of its foot above base.z: that of a part of the base, or the top of the wall that it stands on"),
       required(value<S>("height", &S::height, "m", above(0.0).usually(usual::kHeight), "height")),
       value<S>(
           "brick", &S::brick, "m", above(0.0).usually(usual::kBrick),
           "length, width, height, with mortar: made longer or shorter, wider or narrower, higher or lower by a third at most, so that "
           "whole ones fill the wall; cut where that cannot be, to no less than a fifth"),
       choice<S, WallBond S::*, WallBond>(
           "bond", &S::bond, "",
           {{"english", WallBond::english}, {"running", WallBond::running}, {"header", WallBond::header}, {"through", WallBond::through}},
           "bond of the bricks, as house.bond; through: one block through the wall in running bond, the bond of walls that bend"),
       required(value<S>("material", &S::material, "", filled(), "of the bricks; [joints] has the laws of their joints")),
       choice<S, WallMeeting S::*, WallMeeting>(
           "meeting", &S::meeting, "", {{"toothed", WallMeeting::toothed}, {"butt", WallMeeting::butt}},
           "where it meets walls before it in the case. toothed: either runs through in every second course; butt: the other does in all, "
           "as at an extension. Corners of one wall are toothed"),
       value<S>("load", &S::load, "kg/m", at_least(0.0), "mass per length on its top (floor, roof), added to the bricks of its top course"),
       table<S>("opening", &S::openings, wall_opening_table())},
      nullptr};
}

}  // namespace voussoir::io
