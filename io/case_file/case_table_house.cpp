// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/case_file/case_tables.h"

namespace voussoir::io {
namespace {

using namespace cases;

Table<HouseWood> wood_table() {
  using S = HouseWood;
  return {
      "timber of the house",
      {value<S>("material", &S::material, "", filled(), "of lintels, beams and columns"),
       value<S>("within_member", &S::within_member, "", filled(), "joint law between elements of one member"),
       value<S>("between_members", &S::between_members, "", filled(), "joint law between members, and of members with all else"),
       value<S>("timber_on_timber", &S::timber_on_timber, "", filled(),
                "joint law between members of timber (ring beam on column or ring beam, roof beam on ring beam; not between roof beams); "
                "none: between_members, the paper's mortar")},
      nullptr};
}

Table<Roof> roof_table() {
  using S = Roof;
  return {"beams side by side, or a barrel vault along x",
          {choice<S, RoofKind S::*, RoofKind>(
               "kind", &S::kind, "",
               {{"none", RoofKind::none}, {"flat", RoofKind::flat}, {"vault", RoofKind::vault}, {"gables", RoofKind::gables}},
               "kind of roof; gables: the non-bearing walls go on as under a vault, but there is none"),
           value<S>("beam", &S::beam, "m", above(0.0), "flat: width along x and height of a beam"),
           value<S>("element", &S::element, "m", above(0.0), "flat: length of an element of a beam"),
           value<S>("between_beams", &S::between_beams, "", filled(), "flat: joint law between neighbouring beams"),
           value<S>("radius", &S::radius, "m", above(0.0), "vault, gables: inner radius"),
           value<S>("thickness", &S::thickness, "m", above(0.0), "vault: thickness"),
           value<S>("ring", &S::ring, "m", above(0.0), "vault: length of a ring along x"),
           value<S>("voussoirs", &S::voussoirs, "", within(3.0, 1000.0), "vault, gables: number in a ring"),
           value<S>("surcharge", &S::surcharge, "kg/m2", at_least(0.0),
                    "flat, vault: mass on the upper surface, added to the roof's elements")},
          nullptr};
}

Table<Lintel> lintel_table() {
  using S = Lintel;
  return {"timber over an opening, centred on it",
          {required(value<S>("length", &S::length, "m", above(0.0), "along the wall")),
           value<S>("height", &S::height, "m", above(0.0), "height"),
           value<S>("element", &S::element, "m", above(0.0), "length of an element of it")},
          nullptr};
}

Table<Opening> opening_table() {
  using S = Opening;
  return {"a door or a window",
          {required(choice<S, std::string S::*, std::string>(
               "wall", &S::wall, "", {{"front", "front"}, {"rear", "rear"}, {"left", "left"}, {"right", "right"}}, "the wall it is in")),
           required(value<S>("from", &S::from, "m", at_least(0.0), "start along the wall, x or y from the outer corner of the house")),
           required(value<S>("width", &S::width, "m", above(0.0), "clear width")),
           value<S>("sill", &S::sill, "m", at_least(0.0), "height of its lower edge"),
           required(value<S>("height", &S::height, "m", above(0.0), "clear height")), table<S>("lintel", &S::lintel, lintel_table())},
          nullptr};
}

Table<Reinforcement> reinforcement_table() {
  using S = Reinforcement;
  return {
      "timber columns at the inner faces of the walls, and ring beams there or upon the walls",
      {value<S>("column", &S::column, "m", above(0.0), "section of the columns, along x and y"),
       value<S>("bearing", &S::bearing, "m", at_least(0.0), "x of the column axes at both bearing walls"),
       value<S>("nonbearing", &S::nonbearing, "m", at_least(0.0), "y of the column axes at both non-bearing walls"),
       value<S>("ring_beam", &S::ring_beam, "m", above(0.0), "section of the ring beams, width and height"),
       choice<S, RingPlace S::*, RingPlace>(
           "ring_beam_place", &S::ring_beam_place, "", {{"inside", RingPlace::inside}, {"middle", RingPlace::middle}},
           "inside: at the inner faces of the walls, flush with their top; middle: upon the walls, over their middle, under a flat roof "
           "or none (at most as wide as the thinnest wall)"),
       value<S>("element", &S::element, "m", above(0.0), "length of an element of a member")},
      nullptr};
}

}  // namespace

Table<House> house_table() {
  using S = House;
  return {
      "a house of four walls: bearing walls along x (front at low y, rear at high y), non-bearing walls along y (left at low x, right at "
      "high x), before turn",
      {value<S>("inner_size", &S::inner_size, "m", above(0.0), "inside the walls, along x and y"),
       value<S>("height", &S::height, "m", above(0.0), "of the walls"),
       value<S>("brick", &S::brick, "m", above(0.0), "length, width, height; with mortar, or without it if `mortar` is given"),
       value<S>("mortar", &S::mortar, "m", at_least(0.0),
                "thickness of beds and upright joints, as in the law of `joint`; 0: `brick` has it in it"),
       choice<S, Bond S::*, Bond>("bond", &S::bond, "", {{"english", Bond::english}, {"running", Bond::running}}, "bond of the bricks"),
       value<S>("material", &S::material, "", filled(), "of the bricks"),
       value<S>("joint", &S::joint, "", filled(), "joint law between bricks, and of bricks with the base"),
       value<S>("halves", &S::halves, "", any(),
                "whole bricks can crack: each is two elements, cut at mid-length, with the law materials.<name>.inside between them"),
       table<S>("wood", &S::wood, wood_table()), value<S>("origin", &S::origin, "m", any(), "x and y of the outer corner"),
       choice<S, double S::*, double>("turn", &S::turn, "degrees", {{"0", 0.0}, {"90", 90.0}, {"180", 180.0}, {"270", 270.0}}, "about z"),
       value<S>("copies", &S::copies, "", within(1.0, 1000.0), "number of houses along x and y"),
       value<S>("spacing", &S::spacing, "m", above(0.0), "from house to house along x and y"),
       value<S>("bearing_wall", &S::bearing_wall, "m", above(0.0), "thickness"),
       value<S>("nonbearing_wall", &S::nonbearing_wall, "m", above(0.0), "thickness"),
       value<S>("walls", &S::walls, "", filled(), "walls that are built: front, right, rear, left"),
       table<S>("roof", &S::roof, roof_table()), table<S>("opening", &S::openings, opening_table()),
       table<S>("reinforcement", &S::reinforcement, reinforcement_table()), table<S>("tie", &S::ties, house_tie_table()),
       table<S>("mesh", &S::meshes, house_mesh_table())},
      nullptr};
}

}  // namespace voussoir::io
