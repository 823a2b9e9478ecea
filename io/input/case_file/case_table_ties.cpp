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
       value<S>("walls", &S::walls, "", filled(),
                "walls by name: front, right, rear, left, for along inner walls, too; none: all outer ones that are built"),
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

Table<HouseTie> wall_tie_table() {
  using S = HouseTie;
  const auto name = [](auto& s) -> auto& { return s.bar.name; };
  Table<S> table{
      "steel rods in walls of [[wall]], at given heights: along a side, from end to end, or across a room, from one wall to another",
      {required(value<S>("name", name, "", filled(), "begins the names of its ties")),
       required(choice<S, HouseTieKind S::*, HouseTieKind>(
           "kind", &S::kind, "", {{"along", HouseTieKind::along}, {"across", HouseTieKind::across}},
           "along: a rod through the length of each side, anchored on the outer faces of the walls in which that ends; across: from the "
           "outer face of the first side to that of the second, square to the first")),
       required(value<S>("walls", &S::walls, "", filled(), "straight sides, named as those of floors; across: two that face each other")),
       required(value<S>("heights", &S::heights, "m", at_least(0.0).usually(usual::kLevel), "above base.z, a rod at each")),
       value<S>("at", &S::at, "m", at_least(0.0).usually(usual::kHouse),
                "across: where along the line of the first wall from its first point, a rod at each"),
       value<S>("depth", &S::depth, "m", at_least(0.0).usually(usual::kThickness),
                "along: from the left face of the side, seen along it; none: half its thickness")},
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

namespace {

/// Appends the keys of beams, which `floor` finds in S, and of what holds them.
template <class S, class Get>
void add_beam_keys(std::vector<Key<S>>& keys, Get floor, const std::string& bearing) {
  const auto member = [floor](auto Floor::*m) {
    return [ floor, m ](auto& s) -> auto& { return floor(s).*m; };
  };
  keys.push_back(value<S>("beam", member(&Floor::beam), "m", above(0.0).usually(usual::kSection), "width and height of a beam"));
  keys.push_back(value<S>("spacing", member(&Floor::spacing), "m", above(0.0).usually(usual::kBeamSpacing),
                          "from axis to axis; in each room as many as fit, the rest at both ends"));
  keys.push_back(value<S>("bearing", member(&Floor::bearing), "m", above(0.0).usually(usual::kThickness), bearing));
  keys.push_back(value<S>("element", member(&Floor::element), "m", above(0.0).usually(usual::kMember), "length of an element of a beam"));
  keys.push_back(value<S>("load", member(&Floor::load), "kg/m2", at_least(0.0).usually(usual::kAreaLoad),
                          "mass of boards and all on them; each beam has load x spacing x its length"));
  keys.push_back(value<S>("joint", member(&Floor::joint), "", filled(), "joint law of beams with walls, or \"dry\": friction alone"));
  keys.push_back(choice<S>(
      "anchorage", member(&Floor::anchorage), "",
      std::vector<std::pair<std::string, Anchorage>>{
          {"friction", Anchorage::friction}, {"nailed", Anchorage::nailed}, {"anchor", Anchorage::anchor}},
      "friction: beams lie in their pockets; nailed: straps hold them to the bricks under their ends; anchor: rods to the outer face"));
  keys.push_back(table<S>("anchor", member(&Floor::anchor), beam_anchor_table()));
  keys.push_back(table<S>("deck", member(&Floor::deck), deck_table()));
}

void check_beams(const Floor& s, const RuleCheck& check) {
  if (s.anchorage != Anchorage::friction && !s.anchor) check.fault("anchor", "is missing; this anchorage needs its section");
  if (s.anchorage == Anchorage::friction && s.anchor) check.fault("anchor", "needs anchorage = \"nailed\" or \"anchor\"");
  if (s.anchorage == Anchorage::nailed && s.anchor && s.anchor->bar.plate)
    check.fault("anchor.plate", "does not go with anchorage = \"nailed\", but with \"anchor\"");
  if (s.spacing <= s.beam[0]) check.fault("spacing", "is not more than the width of a beam");
}

/// Appends the keys that say between which walls something spans.
template <class S>
void add_span_keys(std::vector<Key<S>>& keys, const std::string& what) {
  keys.push_back(required(value<S>("name", &S::name, "", filled(), "a name of its own, for messages and results")));
  keys.push_back(required(value<S>("walls", &S::walls, "", filled(),
                                   "the two sides on which " + what +
                                       " rest: a wall of one side by its name (\"inner\"), of several with the number of the side "
                                       "(\"outer 2\": from its second corner on; bends are no corners)")));
  keys.push_back(value<S>("corners", &S::corners, "m", any().usually(usual::kGround),
                          "four [x, y] in turn: " + what + " lie within this quadrilateral; none: wherever both sides face each other"));
  keys.push_back(required(value<S>("material", &S::material, "", filled(), "of the " + what)));
  if constexpr (requires(S s) { s.within_member; })
    keys.push_back(value<S>("within_member", &S::within_member, "", filled(), "joint law between elements of one of the " + what));
}

}  // namespace

Table<Floor> house_floor_table() {
  using S = Floor;
  Table<S> table{"beams in pockets of the walls, flush with the top of a storey, with or without a deck",
                 {value<S>("storey", &S::storey, "", within(1.0, 100.0), "the storey under it"),
                  choice<S, PlanAxis S::*, PlanAxis>("along", &S::along, "", {{"x", PlanAxis::x}, {"y", PlanAxis::y}},
                                                     "where its beams run: from wall to wall, through inner walls")},
                 check_beams};
  add_beam_keys(
      table.keys, [](auto& s) -> auto& { return s; },
      "depth of the pockets in the outer walls; half a brick's width or more of a brick stays behind");
  return table;
}

Table<WallFloor> wall_floor_table() {
  using S = WallFloor;
  Table<S> table{"beams between two walls of [[wall]], in pockets or upon them, with or without a deck: a floor, or a flat roof",
                 {},
                 [](const S& s, const RuleCheck& check) {
                   check_beams(s.beams, check);
                   if (!s.corners.empty() && s.corners.size() != 4) check.fault("corners", "are not four");
                 }};
  add_span_keys(table.keys, "beams");
  table.keys.push_back(value<S>("direction", &S::direction, "", any(),
                                "[x, y] of the beams in plan; none: square to the first of the two walls. At least 30 degrees off both"));
  table.keys.push_back(value<S>(
      "level", &S::level, "m", at_least(0.0).usually(usual::kHeight),
      "of the beams' upper faces above base.z; none: the lower top of the two walls. Beams end in pockets in a wall, or lie at its foot "
      "or on its top. On a top beside a thinner wall above, they lie on the ledge, and in pockets of the thinner wall if bearing is "
      "longer than the ledge"));
  add_beam_keys(
      table.keys, [](auto& s) -> auto& { return s.beams; },
      "depth of the pockets, or of the seats upon the walls, square to the wall; beams go through walls between the two");
  return table;
}

Table<WallRoof> wall_roof_table() {
  using S = WallRoof;
  Table<S> table{"pairs of rafters between two parallel walls of [[wall]] of the same height, with gables under them",
                 {},
                 [](const S& s, const RuleCheck& check) {
                   if (!s.corners.empty() && s.corners.size() != 4) check.fault("corners", "are not four");
                 }};
  const auto member = [](auto Roof::*m) {
    return [m](auto& s) -> auto& { return s.rafters.*m; };
  };
  add_span_keys(table.keys, "rafters");
  auto& keys = table.keys;
  keys.push_back(value<S>("gables", &S::gables, "", filled(), "sides, named as those in `walls`, that rise to the rafters' underside"));
  keys.push_back(value<S>("pitch", member(&Roof::pitch), "degrees", within(5.0, 60.0), "of the rafters"));
  keys.push_back(
      value<S>("beam", member(&Roof::beam), "m", above(0.0).usually(usual::kSection), "width along the ridge and depth of a rafter"));
  keys.push_back(value<S>("spacing", member(&Roof::spacing), "m", above(0.0).usually(usual::kHouse),
                          "of the axes of rafters, at most; the first and the last are flush with the ends of the walls"));
  keys.push_back(value<S>("bearing", member(&Roof::bearing), "m", above(0.0).usually(usual::kMember),
                          "length of a rafter's seat on a wall, from the wall's inner face; none: the thickness of the wall, at most a "
                          "brick's length; in any case at most as cuts half of the rafter's depth"));
  keys.push_back(value<S>("element", member(&Roof::element), "m", above(0.0).usually(usual::kMember), "length of an element of a rafter"));
  keys.push_back(value<S>("joint", &S::joint, "", filled(), "joint law of rafters with walls, or \"dry\": friction alone"));
  keys.push_back(value<S>("between_beams", member(&Roof::between_beams), "", filled(),
                          "joint law between the rafters of a pair, in the ridge; \"dry\": friction alone"));
  keys.push_back(value<S>("surcharge", member(&Roof::surcharge), "kg/m2", at_least(0.0).usually(usual::kAreaLoad),
                          "mass on the upper surface, as of tiles, added to the rafters"));
  keys.push_back(io::table<S>("tie", member(&Roof::tie), roof_tie_table()));
  keys.push_back(io::table<S>("deck", member(&Roof::deck), deck_table()));
  return table;
}

Table<WallVault> wall_vault_table() {
  using S = WallVault;
  Table<S> table{"a vault on walls of [[wall]] of the same height, of voussoirs; joints have the laws of [joints]",
                 {},
                 [](const S& s, const RuleCheck& check) {
                   if (!s.corners.empty() && s.corners.size() != 4) check.fault("corners", "are not four");
                 }};
  auto& keys = table.keys;
  keys.push_back(required(value<S>("name", &S::name, "", filled(), "a name of its own, for messages and results")));
  keys.push_back(choice<S, VaultKind S::*, VaultKind>(
      "kind", &S::kind, "",
      {{"barrel", VaultKind::barrel}, {"cross", VaultKind::cross}, {"pavilion", VaultKind::pavilion}, {"dome", VaultKind::dome}},
      "barrel: rings on two parallel sides; cross: two barrels that cut each other over a "
      "rectangle, with the walls raised to them; pavilion: level courses along four sides, "
      "mitred over the diagonals; dome: the same along a round wall"));
  keys.push_back(required(value<S>("walls", &S::walls, "", filled(),
                                   "the sides on which voussoirs rest, named as those of floors: two of a barrel vault; of a cross or "
                                   "pavilion vault four, in turn round the room; of a dome one closed round wall")));
  keys.push_back(
      value<S>("corners", &S::corners, "m", any().usually(usual::kGround),
               "barrel: four [x, y] in turn, voussoirs lie within this quadrilateral; none: wherever both sides face each other"));
  keys.push_back(required(value<S>("material", &S::material, "", filled(), "of the voussoirs")));
  keys.push_back(value<S>("gables", &S::gables, "", filled(), "barrel: sides, named as those in `walls`, that rise to the vault's soffit"));
  keys.push_back(
      value<S>("rise", &S::rise, "m", above(0.0).usually(usual::kHouse),
               "of the soffit's crown above the tops of the walls, from a twentieth to a half of the span (over a room: the lesser "
               "one); none: half the span, a half circle"));
  keys.push_back(value<S>("oculus", &S::oculus, "m", above(0.0).usually(usual::kHouse),
                          "pavilion, dome: width of an opening in the crown at the soffit, from a twentieth to a half of the span; none: a "
                          "keystone"));
  keys.push_back(value<S>("thickness", &S::thickness, "m", above(0.0).usually(usual::kSection),
                          "of the vault; its feet stand on the walls, which are no thinner than the feet"));
  keys.push_back(value<S>("ring", &S::ring, "m", above(0.0).usually(usual::kMember),
                          "barrel: how wide a ring is along the axis of the vault; others: length of a voussoir along its course"));
  keys.push_back(
      value<S>("voussoirs", &S::voussoirs, "", within(3.0, 1000.0), "number in a ring, from wall to wall; odd unless kind = \"barrel\""));
  keys.push_back(value<S>("surcharge", &S::surcharge, "kg/m2", at_least(0.0).usually(usual::kAreaLoad),
                          "mass on each m2 of the curved outer face, as of a fill, added to the voussoirs"));
  return table;
}

}  // namespace voussoir::io
