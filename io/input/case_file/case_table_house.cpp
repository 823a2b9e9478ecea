// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <initializer_list>

#include "io/input/case_file/case_tables.h"
#include "io/input/case_file/usual_ranges.h"

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

/// Reports keys of other kinds of roof than the given one as probable mistakes.
void check_roof_keys(const Roof& s, const RuleCheck& check) {
  using K = RoofKind;
  const Roof none;
  const auto belongs_to = [&](const char* key, bool set, std::initializer_list<K> kinds, const char* words) {
    if (!set || std::ranges::find(kinds, s.kind) != kinds.end() || !check.given_together(key, "kind")) return;
    check.doubt(key, std::string("has no effect with this kind of roof; it belongs to ") + words);
  };
  belongs_to("beam", s.beam != none.beam, {K::flat, K::pitched}, "flat and pitched ones");
  belongs_to("element", s.element != none.element, {K::flat, K::pitched}, "flat and pitched ones");
  belongs_to("between_beams", s.between_beams != none.between_beams, {K::flat, K::pitched}, "flat and pitched ones");
  belongs_to("edge_beams", s.edge_beams.has_value(), {K::flat}, "flat ones");
  belongs_to("radius", s.radius != none.radius, {K::vault, K::gables}, "vaults and gables");
  belongs_to("thickness", s.thickness != none.thickness, {K::vault}, "vaults");
  belongs_to("ring", s.ring != none.ring, {K::vault}, "vaults");
  belongs_to("voussoirs", s.voussoirs != none.voussoirs, {K::vault, K::gables}, "vaults and gables");
}

Table<Roof> roof_table() {
  using S = Roof;
  return {
      "beams side by side, a barrel vault along x, or pairs of rafters",
      {choice<S, RoofKind S::*, RoofKind>(
           "kind", &S::kind, "",
           {{"none", RoofKind::none},
            {"flat", RoofKind::flat},
            {"vault", RoofKind::vault},
            {"gables", RoofKind::gables},
            {"pitched", RoofKind::pitched}},
           "kind of roof; gables: the non-bearing walls go on as under a vault, but there is none; pitched: pairs of rafters on the "
           "bearing walls, and gables under them"),
       value<S>("beam", &S::beam, "m", above(0.0).usually(usual::kSection), "flat, pitched: width along x and height of a beam or rafter"),
       value<S>("element", &S::element, "m", above(0.0).usually(usual::kMember), "flat, pitched: length of an element of a beam or rafter"),
       value<S>("between_beams", &S::between_beams, "", filled(),
                "joint law; flat: between neighbouring beams, pitched: between the rafters of a pair, in the ridge"),
       value<S>("edge_beams", &S::edge_beams, "", filled(),
                "flat: joint law between the first or the last beam, over a side wall, and its neighbour; none: `between_beams`"),
       value<S>("bearing", &S::bearing, "m", above(0.0).usually(usual::kMember),
                "flat: length over which a beam rests on each bearing wall, from the wall's inner face, at most the wall's thickness; "
                "none: that thickness, at most a brick's length"),
       value<S>("radius", &S::radius, "m", above(0.0).usually(usual::kRadius), "vault, gables: inner radius"),
       value<S>("thickness", &S::thickness, "m", above(0.0).usually(usual::kSection), "vault: thickness"),
       value<S>("ring", &S::ring, "m", above(0.0).usually(usual::kMember), "vault: length of a ring along x"),
       value<S>("voussoirs", &S::voussoirs, "", within(3.0, 1000.0), "vault, gables: number in a ring"),
       value<S>("surcharge", &S::surcharge, "kg/m2", at_least(0.0).usually(usual::kAreaLoad),
                "flat, vault, pitched: mass on the upper surface, added to the roof's elements"),
       value<S>("pitch", &S::pitch, "degrees", within(5.0, 60.0), "pitched: of the rafters"),
       value<S>("spacing", &S::spacing, "m", above(0.0).usually(usual::kHouse),
                "pitched: of the axes of rafters, at most; the first and the last are flush with the ends of the house"),
       table<S>("tie", &S::tie, roof_tie_table()), table<S>("deck", &S::deck, deck_table())},
      [](const S& s, const RuleCheck& check) {
        check_roof_keys(s, check);
        if (s.bearing && s.kind != RoofKind::flat) check.fault("bearing", "needs kind = \"flat\"");
        if (s.kind == RoofKind::pitched) return;
        const auto only_pitched = [&](const char* key, bool given) {
          if (given) check.fault(key, "needs kind = \"pitched\"");
        };
        only_pitched("pitch", s.pitch != S{}.pitch), only_pitched("spacing", s.spacing != S{}.spacing);
        only_pitched("tie", s.tie.has_value()), only_pitched("deck", s.deck.has_value());
      }};
}

Table<ThroughStones> through_table() {
  using S = ThroughStones;
  return {
      "stones through both leaves, a brick's width along the wall and a course high; none where an opening, a corner or a beam is in "
      "the way",
      {value<S>("spacing", &S::spacing, "m", above(0.0).usually(usual::kHouse),
                "along the wall, at least two bricks; those of the next row lie between them"),
       value<S>("every", &S::every, "", within(2.0, 1000.0), "course with such stones"),
       value<S>("material", &S::material, "", filled(), "none: that of the bricks")},
      nullptr};
}

Table<Leaves> leaves_table() {
  using S = Leaves;
  return {"outer walls of two leaves, each in the house's bond; storeys whose walls are too thin for two leaves have one",
          {value<S>("walls", &S::walls, "", filled(), "front, right, rear, left; none: all that are built"),
           value<S>("outer", &S::outer, "m", above(0.0).usually(usual::kThickness), "thickness of the outer leaf; none: half the wall"),
           value<S>("joint", &S::joint, "", filled(),
                    "law of the collar joint between the leaves (dry: friction alone); none: that of the bricks"),
           table<S>("through", &S::through, through_table())},
          nullptr};
}

Table<Lintel> lintel_table() {
  using S = Lintel;
  return {"timber over an opening, centred on it",
          {required(value<S>("length", &S::length, "m", above(0.0).usually(usual::kMember), "along the wall")),
           value<S>("height", &S::height, "m", above(0.0).usually(usual::kOpening), "height"),
           value<S>("element", &S::element, "m", above(0.0).usually(usual::kMember), "length of an element of it")},
          nullptr};
}

Table<Arch> arch_table() {
  using S = Arch;
  return {
      "an arch of voussoirs over an opening, upon its lintel if it has one; its wedges reach up to the course above, and a springer of one "
      "piece stands at either end",
      {value<S>("rise", &S::rise, "m", at_least(0.0).usually(usual::kMember),
                "of its soffit above the top of the opening or of the lintel, at most half the width; 0: a flat arch"),
       required(value<S>("thickness", &S::thickness, "m", above(0.0).usually(usual::kSection),
                         "at the crown, half a course or more; the top ends a course")),
       value<S>("springer", &S::springer, "m", above(0.0).usually(usual::kMember),
                "that it reaches beyond the opening at either side, half a brick or more"),
       value<S>("voussoirs", &S::voussoirs, "", within(3.0, 101.0), "number; none: odd, each about a brick's width at the soffit"),
       value<S>("material", &S::material, "", filled(), "none: that of the bricks")},
      nullptr};
}

Table<Rubble> rubble_table() {
  using S = Rubble;
  return {
      "convex stones about the size of a brick for bond = \"rubble\", in courses of random height, their joints askew; level beds and "
      "upright "
      "ends at corners, openings, floors and ends of storeys",
      {value<S>("seed", &S::seed, "", any(), "another seed, other stones"),
       value<S>("irregularity", &S::irregularity, "", within(0.0, 1.0), "0: rectangular stones of one size; 1: the most"),
       value<S>("through", &S::through, "", within(0.0, 1.0),
                "share of the stones that go through the wall; walls of two leaves have those of house.leaves.through alone")},
      nullptr};
}

Table<Opening> opening_table() {
  using S = Opening;
  return {"a door or a window",
          {required(value<S>("wall", &S::wall, "", filled(), "the wall it is in: front, rear, left, right, or the name of an inner wall")),
           value<S>("storey", &S::storey, "", within(1.0, 100.0), "the storey it is in"),
           required(value<S>("from", &S::from, "m", at_least(0.0).usually(usual::kHouse),
                             "start along the wall, x or y from the outer corner of the house")),
           required(value<S>("width", &S::width, "m", above(0.0).usually(usual::kOpening), "clear width")),
           value<S>("sill", &S::sill, "m", at_least(0.0).usually(usual::kLevel),
                    "height of its lower edge above the foot of its storey; in the first storey above base.z"),
           required(value<S>("height", &S::height, "m", above(0.0).usually(usual::kOpening), "clear height")),
           table<S>("lintel", &S::lintel, lintel_table()), table<S>("arch", &S::arch, arch_table())},
          nullptr};
}

Table<Storey> storey_table() {
  using S = Storey;
  return {"a storey upon those before it; a low one on top is a parapet",
          {value<S>("height", &S::height, "m", above(0.0).usually(usual::kHeight), "of its walls"),
           value<S>("bearing_wall", &S::bearing_wall, "m", above(0.0).usually(usual::kThickness),
                    "thickness; none: as below, and at most that; outer faces are flush"),
           value<S>("nonbearing_wall", &S::nonbearing_wall, "m", above(0.0).usually(usual::kThickness), "likewise")},
          nullptr};
}

Table<InnerWall> inner_wall_table() {
  using S = InnerWall;
  return {"a wall from an outer wall to that opposite, toothed into all walls that it meets or crosses",
          {value<S>("name", &S::name, "", filled(), "a name of its own, for openings, messages and results"),
           choice<S, PlanAxis S::*, PlanAxis>("along", &S::along, "", {{"x", PlanAxis::x}, {"y", PlanAxis::y}}, "where it runs"),
           required(value<S>("at", &S::at, "m", above(0.0).usually(usual::kHouse),
                             "its face nearer to the origin, y or x from the outer corner of the house")),
           value<S>("thickness", &S::thickness, "m", above(0.0).usually(usual::kSection), "thickness"),
           value<S>("storeys", &S::storeys, "", within(1.0, 100.0), "that it goes through; none: all")},
          nullptr};
}

Table<Pier> pier_table() {
  using S = Pier;
  return {"a pier or buttress on the outer face of a wall, toothed into it",
          {required(value<S>("wall", &S::wall, "", filled(), "front, rear, left or right")),
           required(value<S>("from", &S::from, "m", above(0.0).usually(usual::kHouse),
                             "start along the wall, x or y from the outer corner of the house")),
           value<S>("width", &S::width, "m", above(0.0).usually(usual::kOpening), "along the wall"),
           value<S>("depth", &S::depth, "m", above(0.0).usually(usual::kOpening), "out of the wall, half a brick or more"),
           value<S>("height", &S::height, "m", above(0.0).usually(usual::kOpening),
                    "of its top above the foot of the walls; none: that of the first storey")},
          nullptr};
}

Table<Reinforcement> reinforcement_table() {
  using S = Reinforcement;
  return {
      "timber columns at the inner faces of the walls, and ring beams there or upon the walls",
      {value<S>("column", &S::column, "m", above(0.0).usually(usual::kSection), "section of the columns, along x and y"),
       value<S>("bearing", &S::bearing, "m", at_least(0.0).usually(usual::kHouse), "x of the column axes at both bearing walls"),
       value<S>("nonbearing", &S::nonbearing, "m", at_least(0.0).usually(usual::kHouse), "y of the column axes at both non-bearing walls"),
       value<S>("ring_beam", &S::ring_beam, "m", above(0.0).usually(usual::kSection), "section of the ring beams, width and height"),
       choice<S, RingPlace S::*, RingPlace>(
           "ring_beam_place", &S::ring_beam_place, "", {{"inside", RingPlace::inside}, {"middle", RingPlace::middle}},
           "inside: at the inner faces of the walls, flush with their top; middle: upon the walls, over their middle, under a flat roof "
           "or none (at most as wide as the thinnest wall)"),
       value<S>("element", &S::element, "m", above(0.0).usually(usual::kMember), "length of an element of a member")},
      nullptr};
}

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
       table<S>("lintel", &S::lintel, wall_lintel_table()), table<S>("arch", &S::arch, arch_table())},
      nullptr};
}

}  // namespace

Table<House> house_table() {
  using S = House;
  return {
      "a house of four walls: bearing walls along x (front at low y, rear at high y), non-bearing walls along y (left at low x, right at "
      "high x), before turn",
      {value<S>("inner_size", &S::inner_size, "m", above(0.0).usually(usual::kHouse), "inside the walls, along x and y"),
       value<S>("height", &S::height, "m", above(0.0).usually(usual::kHeight), "of the walls; of the first storey if there are more"),
       value<S>("brick", &S::brick, "m", above(0.0).usually(usual::kBrick),
                "length, width, height; with mortar, or without it if `mortar` is given"),
       value<S>("mortar", &S::mortar, "m", at_least(0.0).usually(usual::kMortar),
                "thickness of beds and upright joints, as in the law of `joint`; 0: `brick` has it in it"),
       choice<S, Bond S::*, Bond>(
           "bond", &S::bond, "",
           {{"english", Bond::english},
            {"running", Bond::running},
            {"header", Bond::header},
            {"flemish", Bond::flemish},
            {"rubble", Bond::rubble}},
           "bond of the bricks; header: walls as thick as a brick is long are all headers; flemish: walls as thick as one or more bricks "
           "are long have headers and stretchers in turn; others, and gables, as in English bond; rubble: convex stones (gables: bricks in "
           "running bond)"),
       table<S>("rubble", &S::rubble, rubble_table()),
       table<S>("leaves", &S::leaves, leaves_table()),
       value<S>("material", &S::material, "", filled(), "of the bricks"),
       value<S>("joint", &S::joint, "", filled(), "joint law between bricks, and of bricks with the base"),
       value<S>("halves", &S::halves, "", any(),
                "whole bricks can crack: each is two elements, cut at mid-length, with the law materials.<name>.inside between them; "
                "as cells = [2, 1, 1] does, but cut bricks are not divided"),
       value<S>("cells", &S::cells, "", within(1.0, kMostCells),
                "bricks can crack: number of cells along the length, thickness and height of a whole one, with the law "
                "materials.<name>.inside between them; shorter bricks get cells of about the same size, bricks cut along a slope are not "
                "divided"),
       table<S>("wood", &S::wood, wood_table()),
       value<S>("origin", &S::origin, "m", any().possibly(0.0, usual::kFarthest), "x and y of the outer corner"),
       choice<S, double S::*, double>("turn", &S::turn, "degrees", {{"0", 0.0}, {"90", 90.0}, {"180", 180.0}, {"270", 270.0}}, "about z"),
       value<S>("copies", &S::copies, "", within(1.0, 1000.0), "number of houses along x and y"),
       value<S>("spacing", &S::spacing, "m", above(0.0).usually(usual::kHouse), "from house to house along x and y"),
       value<S>("bearing_wall", &S::bearing_wall, "m", above(0.0).usually(usual::kThickness), "thickness"),
       value<S>("nonbearing_wall", &S::nonbearing_wall, "m", above(0.0).usually(usual::kThickness), "thickness"),
       value<S>("walls", &S::walls, "", filled(), "walls that are built: front, right, rear, left"),
       table<S>("storey", &S::storeys, storey_table()),
       table<S>("inner_wall", &S::inner_walls, inner_wall_table()),
       table<S>("pier", &S::piers, pier_table()),
       table<S>("floor", &S::floors, house_floor_table()),
       table<S>("roof", &S::roof, roof_table()),
       table<S>("opening", &S::openings, opening_table()),
       table<S>("reinforcement", &S::reinforcement, reinforcement_table()),
       table<S>("tie", &S::ties, house_tie_table()),
       table<S>("mesh", &S::meshes, house_mesh_table())},
      [](const S& s, const RuleCheck& check) {
        if (s.rubble && s.bond != Bond::rubble) check.fault("rubble", "needs bond = \"rubble\"");
        if (s.halves && s.bond == Bond::rubble) check.fault("halves", "does not go with bond = \"rubble\"");
        if (s.cells && s.bond == Bond::rubble) check.fault("cells", "does not go with bond = \"rubble\", whose stones stay whole");
        if (s.cells && s.halves) check.fault("cells", "does not go with halves = true, which is cells = [2, 1, 1] of whole bricks");
      }};
}

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
       choice<S, WallLine S::*, WallLine>(
           "line", &S::line, "", {{"left", WallLine::left}, {"middle", WallLine::middle}, {"right", WallLine::right}},
           "what the points are of: the middle of the wall (always if it bends), or its left or right face, seen along it"),
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
       value<S>("cells", &S::cells, "", within(1.0, kMostCells),
                "bricks can crack: number of cells along the length, thickness and height of a whole one, with the law "
                "materials.<name>.inside between them; shorter bricks get cells of about the same size, bricks cut along a slope are not "
                "divided"),
       required(value<S>("material", &S::material, "", filled(), "of the bricks; [joints] has the laws of their joints")),
       choice<S, WallMeeting S::*, WallMeeting>(
           "meeting", &S::meeting, "", {{"toothed", WallMeeting::toothed}, {"butt", WallMeeting::butt}},
           "where it meets walls before it in the case. toothed: either runs through in every second course; butt: the other does in all, "
           "as at an extension. Corners of one wall are toothed"),
       value<S>("load", &S::load, "kg/m", at_least(0.0),
                "mass per length on its top (floor, roof), added to the bricks of the course that ends at `height`"),
       value<S>("tops", &S::tops, "m", at_least(0.0).usually(usual::kHouse),
                "[place along the wall's line from its first point, height of its top there], in turn; straight from one to the next, "
                "`height` before the first and behind the last. At `height` or above it; a place given twice is a step. For gables and "
                "parapets: bricks are cut to it"),
       value<S>("gable", &S::gable, "m", above(0.0).usually(usual::kHeight),
                "of a wall with one side: height of its top in the middle, from where it falls to `height` at both ends"),
       table<S>("opening", &S::openings, wall_opening_table())},
      [](const S& s, const RuleCheck& check) {
        if (s.gable && !s.tops.empty()) check.fault("gable", "does not go with `tops`, which say the same");
      }};
}

}  // namespace voussoir::io
