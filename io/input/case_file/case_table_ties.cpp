// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/case_file/case_tables.h"
#include "io/input/case_file/usual_ranges.h"

namespace voussoir::io {
namespace {

using namespace cases;

/// Appends the keys of a bar's section, which `bar` finds in S.
template <class S, class Bar>
void add_bar_keys(std::vector<Key<S>>& keys, Bar bar) {
  const auto member = [bar](auto Tie::*m) {
    return [ bar, m ](auto& s) -> auto& { return bar(s).*m; };
  };
  keys.push_back(required(value<S>("area", member(&Tie::area), "m2", above(0.0).usually(usual::kBarArea), "of its section")));
  keys.push_back(
      value<S>("young", member(&Tie::young), "Pa", above(0.0).usually(usual::kBarYoung), "modulus; the default is that of steel"));
  keys.push_back(
      value<S>("yield", member(&Tie::yield), "Pa", above(0.0).usually(usual::kYield), "stress at which it yields; none: elastic"));
  keys.push_back(value<S>("hardening", member(&Tie::hardening), "Pa", at_least(0.0).usually(usual::kHardening),
                          "slope of stress over strain beyond yield"));
  keys.push_back(value<S>("elongation", member(&Tie::elongation), "", above(0.0).usually(usual::kElongation),
                          "strain at which it breaks; none: never"));
  keys.push_back(value<S>("pretension", member(&Tie::pretension), "N", at_least(0.0).usually(usual::kPretension),
                          "force that it would have if its ends did not move; put on with gravity, or at once without settling"));
  keys.push_back(
      value<S>("compression", member(&Tie::compression), "", any(), "bears compression, too, without buckling; else it goes slack"));
  keys.push_back(value<S>("plate", member(&Tie::plate), "m", above(0.0).usually(usual::kSection),
                          "width and height of the anchor plates that spread its force over the faces they cover; none: each end holds one "
                          "element"));
}

void check_bar(const Tie& s, const RuleCheck& check) {
  if (s.hardening >= s.young) check.fault("hardening", "must be below young");
  if (s.hardening > 0.0 && !s.yield) check.fault("hardening", "needs yield");
  if (s.yield && s.pretension > *s.yield * s.area) check.fault("pretension", "is over the force at which the tie yields (yield x area)");
  if (s.elongation && s.pretension >= *s.elongation * s.young * s.area)
    check.fault("pretension", "is over the force at which the tie breaks (elongation x young x area)");
}

void check_house_tie(const HouseTie& s, const RuleCheck& check) {
  check_bar(s.bar, check);
  if (s.heights.empty()) check.fault("heights", "has no height");
  const auto only_with = [&](const char* key, bool given, HouseTieKind kind, const char* word) {
    if (s.kind != kind && given) check.fault(key, std::string("does not go with this kind, but with kind = \"") + word + "\"");
    if (s.kind == kind && !given) check.fault("", std::string("needs ") + key + " (kind = \"" + word + "\")");
  };
  only_with("at", !s.at.empty(), HouseTieKind::across, "across");
  only_with("reach", s.reach > 0.0, HouseTieKind::corner, "corner");
  if (s.kind != HouseTieKind::along && s.depth) check.fault("depth", "does not go with this kind, but with kind = \"along\"");
}

Table<MeshConnectors> connectors_table() {
  using S = MeshConnectors;
  return {"bars through the wall that join the two faces of a mesh at its nodes, in tension and compression",
          {value<S>("every", &S::every, "", within(1.0, 1000.0), "nodes, along and up, from one to the next"),
           required(value<S>("area", &S::area, "m2", above(0.0).usually(usual::kBarArea), "of the section")),
           value<S>("young", &S::young, "Pa", above(0.0).usually(usual::kBarYoung), "modulus; the default is that of steel"),
           value<S>("yield", &S::yield, "Pa", above(0.0).usually(usual::kYield), "stress at which they yield; none: elastic"),
           value<S>("elongation", &S::elongation, "", above(0.0).usually(usual::kElongation), "strain at which they break; none: never")},
          nullptr};
}

const char* const kWalls = "walls by name: front, right, rear, left; none: all that are built";

}  // namespace

Table<Tie> tie_table() {
  using S = Tie;
  Table<S> table{
      "a rod, cable, strap or bar between two points of the model",
      {required(value<S>("name", &S::name, "", filled(), "a name of its own, for results and messages")),
       required(value<S>("from", &S::from, "m", any(), "a point in or on an element, or on the base; with a plate, on an outer face")),
       required(value<S>("to", &S::to, "m", any(), "its other end, likewise"))},
      check_bar};
  add_bar_keys(
      table.keys, [](auto& s) -> auto& { return s; });
  return table;
}

Table<HouseTie> house_tie_table() {
  using S = HouseTie;
  const auto name = [](auto& s) -> auto& { return s.bar.name; };
  Table<S> table{
      "rods of the house by wall and height: through walls from end to end, across the house, or across its corners",
      {required(value<S>("name", name, "", filled(), "begins the names of its ties")),
       required(choice<S, HouseTieKind S::*, HouseTieKind>(
           "kind", &S::kind, "", {{"along", HouseTieKind::along}, {"across", HouseTieKind::across}, {"corner", HouseTieKind::corner}},
           "along: through a wall, plates on the walls that it meets; across: from a wall to that opposite; corner: from a wall to the "
           "next")),
       value<S>("walls", &S::walls, "", filled(), kWalls),
       required(value<S>("heights", &S::heights, "m", at_least(0.0).usually(usual::kLevel), "above the foot of the walls, a rod at each")),
       value<S>("at", &S::at, "m", at_least(0.0).usually(usual::kHouse),
                "across: where along the wall, x or y from the outer corner of the house, a rod at each"),
       value<S>("depth", &S::depth, "m", at_least(0.0).usually(usual::kThickness),
                "along: from the outer face of the wall; none: half its thickness"),
       value<S>("reach", &S::reach, "m", at_least(0.0).usually(usual::kHouse),
                "corner: from the outer corner to either end, along the walls")},
      check_house_tie};
  add_bar_keys(
      table.keys, [](auto& s) -> auto& { return s.bar; });
  return table;
}

Table<HouseMesh> house_mesh_table() {
  using S = HouseMesh;
  return {"a net, mesh or bandage on the faces of walls: straps between nodes, in tension alone",
          {required(value<S>("name", &S::name, "", filled(), "begins the names of its straps")),
           value<S>("walls", &S::walls, "", filled(), kWalls),
           value<S>("from", &S::from, "m", at_least(0.0).usually(usual::kLevel), "lower edge, above the foot of the walls"),
           value<S>("to", &S::to, "m", above(0.0).usually(usual::kLevel), "upper edge; none: the top of the walls"),
           value<S>("spacing", &S::spacing, "m", above(0.0).usually(usual::kOpening),
                    "of the nodes, along and up; every brick should have one"),
           choice<S, MeshFaces S::*, MeshFaces>("faces", &S::faces, "",
                                                {{"both", MeshFaces::both}, {"outside", MeshFaces::outside}, {"inside", MeshFaces::inside}},
                                                "of the walls that it covers"),
           required(value<S>("stiffness", &S::stiffness, "N/m", above(0.0).usually(usual::kStripStiffness),
                             "force over strain of a strip one metre wide")),
           value<S>("strength", &S::strength, "N/m", above(0.0).usually(usual::kStripStrength),
                    "force at which a strip one metre wide yields; none: elastic"),
           value<S>("elongation", &S::elongation, "", above(0.0).usually(usual::kElongation), "strain at which it breaks; none: never"),
           table<S>("connectors", &S::connectors, connectors_table())},
          [](const S& s, const RuleCheck& check) {
            if (s.to && *s.to <= s.from) check.fault("to", "must be above house.mesh.from");
            if (s.connectors && s.faces != MeshFaces::both) check.fault("connectors", "needs faces = \"both\"");
          }};
}

namespace {

Table<BeamAnchor> beam_anchor_table() {
  using S = BeamAnchor;
  Table<S> table{"what holds the ends of beams to the walls",
                 {value<S>("every", &S::every, "", within(1.0, 100.0), "beam that has one: 1 for all, 2 for every second"),
                  value<S>("reach", &S::reach, "m", above(0.0).usually(usual::kMember),
                           "from the face of the wall into the room, where it holds the beam")},
                 [](const S& s, const RuleCheck& check) { check_bar(s.bar, check); }};
  add_bar_keys(
      table.keys, [](auto& s) -> auto& { return s.bar; });
  return table;
}

}  // namespace

Table<Tie> roof_tie_table() {
  using S = Tie;
  Table<S> table{"a rod or beam from foot to foot of each pair of rafters, which takes their thrust; none: the walls do",
                 {},
                 [](const S& s, const RuleCheck& check) {
                   check_bar(s, check);
                   if (s.plate) check.fault("plate", "does not go with a tie from rafter to rafter");
                 }};
  add_bar_keys(
      table.keys, [](auto& s) -> auto& { return s; });
  return table;
}

Table<Deck> deck_table() {
  using S = Deck;
  return {
      "boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from the "
      "middle of the first element of the beams between the walls to that of the last",
      {required(value<S>("shear_stiffness", &S::shear_stiffness, "N/m", above(0.0).usually(usual::kStripStiffness),
                         "shear flow over shear angle, G t")),
       value<S>("shear_strength", &S::shear_strength, "N/m", above(0.0).usually(usual::kStripStrength),
                "shear flow at which it yields; none: elastic"),
       required(value<S>("stiffness", &S::stiffness, "N/m", above(0.0).usually(usual::kStripStiffness),
                         "force over strain of a strip one metre wide, across the beams")),
       value<S>("strength", &S::strength, "N/m", above(0.0).usually(usual::kStripStrength),
                "force at which such a strip yields; none: elastic")},
      nullptr};
}

Table<Floor> house_floor_table() {
  using S = Floor;
  return {
      "beams in pockets of the walls, flush with the top of a storey, with or without a deck",
      {value<S>("storey", &S::storey, "", within(1.0, 100.0), "the storey under it"),
       choice<S, PlanAxis S::*, PlanAxis>("along", &S::along, "", {{"x", PlanAxis::x}, {"y", PlanAxis::y}},
                                          "where its beams run: from wall to wall, through inner walls"),
       value<S>("beam", &S::beam, "m", above(0.0).usually(usual::kSection), "width and height of a beam"),
       value<S>("spacing", &S::spacing, "m", above(0.0).usually(usual::kBeamSpacing),
                "from axis to axis; in each room as many as fit, the rest at both ends"),
       value<S>("bearing", &S::bearing, "m", above(0.0).usually(usual::kThickness),
                "depth of the pockets in the outer walls; half a brick's width or more of a brick stays behind"),
       value<S>("element", &S::element, "m", above(0.0).usually(usual::kMember), "length of an element of a beam"),
       value<S>("load", &S::load, "kg/m2", at_least(0.0).usually(usual::kAreaLoad),
                "mass of boards and all on them; each beam has load x spacing x its length"),
       value<S>("joint", &S::joint, "", filled(), "joint law of beams with walls, or \"dry\": friction alone"),
       choice<S, Anchorage S::*, Anchorage>(
           "anchorage", &S::anchorage, "",
           {{"friction", Anchorage::friction}, {"nailed", Anchorage::nailed}, {"anchor", Anchorage::anchor}},
           "friction: beams lie in their pockets; nailed: straps hold them to the bricks under their ends; anchor: rods to the outer face"),
       table<S>("anchor", &S::anchor, beam_anchor_table()), table<S>("deck", &S::deck, deck_table())},
      [](const S& s, const RuleCheck& check) {
        if (s.anchorage != Anchorage::friction && !s.anchor) check.fault("anchor", "is missing; this anchorage needs its section");
        if (s.anchorage == Anchorage::friction && s.anchor) check.fault("anchor", "needs anchorage = \"nailed\" or \"anchor\"");
        if (s.anchorage == Anchorage::nailed && s.anchor && s.anchor->bar.plate)
          check.fault("anchor.plate", "does not go with anchorage = \"nailed\", but with \"anchor\"");
        if (s.spacing <= s.beam[0]) check.fault("spacing", "is not more than the width of a beam");
      }};
}

}  // namespace voussoir::io
