// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec3.h"

/// A house as plain data: [house] of the case file, with ties. SI units.
namespace voussoir::cases {

struct Lintel {
  double length = 0.0, height = 0.1, element = 0.2;  // m
};
/// An arch of voussoirs over an opening, on its lintel if there is one, with a level extrados: the voussoirs reach up to the courses above.
struct Arch {
  double rise = 0.0;                    // m, of its soffit; 0: flat arch
  double thickness = 0.0;               // m, at the crown
  double springer = 0.1;                // m, length beyond the opening at either side
  std::optional<int> voussoirs;         // none: an odd number, each about a brick's width at the soffit
  std::optional<std::string> material;  // none: of the bricks
};
struct Opening {
  std::string wall;                                          // front | rear | left | right, or the name of an inner wall
  double from = 0.0, width = 0.0, sill = 0.0, height = 0.0;  // m
  std::optional<Lintel> lintel;
  std::optional<Arch> arch;
  int storey = 1;  // `sill` is above the foot of this storey
};
/// A storey above the first. Its walls have the outer faces of the walls below.
struct Storey {
  double height = 2.4;                                  // m
  std::optional<double> bearing_wall, nonbearing_wall;  // m; none: as the storey below
};
/// A wall between two outer walls, toothed into them and into the inner walls that it crosses.
enum class PlanAxis { x, y };
struct InnerWall {
  std::string name = "inner";
  PlanAxis along = PlanAxis::y;
  double at = 0.0;           // m, position of the face nearer to the origin, from the outer corner of the house
  double thickness = 0.2;    // m
  std::vector<int> storeys;  // empty: all
};
/// A pier or buttress of bricks on the outer face of a wall, toothed into the wall.
struct Pier {
  std::string wall;                             // front | rear | left | right
  double from = 0.0, width = 0.3, depth = 0.3;  // m: from, width along the wall from the outer corner; depth out of the wall
  std::optional<double> height;                 // m, above the foot of the walls; none: that of the first storey
};
struct HouseWood {
  std::string material = "wood", within_member = "wood", between_members = "normal";
  std::optional<std::string> timber_on_timber;  // between timber members only; none: between_members
};
/// A rod, cable, strap or bar between two points of the model (cases/ties.h).
struct Tie {
  std::string name;
  Vec3 from, to;                                 // m
  double area = 0.0;                             // m2, of the section
  double young = 2.1e11;                         // Pa
  std::optional<double> yield{};                 // Pa; none: elastic
  double hardening = 0.0;                        // Pa, slope of stress over strain beyond yield
  std::optional<double> elongation{};            // strain at which it breaks; none: never
  double pretension = 0.0;                       // N, force at the initial positions of the ends
  bool compression = false;                      // true: bears compression (a bar); false: goes slack
  std::optional<std::array<double, 2>> plate{};  // m, width and height of the anchor plates; none: each end holds one element
};
/// In-plane behaviour of boards or a slab on beams: a shear panel between neighbouring beams, and bars across the beams.
struct Deck {
  double shear_stiffness = 0.0;          // N/m, shear flow over shear angle (G t)
  std::optional<double> shear_strength;  // N/m, shear flow at yield; none: elastic
  double stiffness = 0.0;                // N/m, force over strain of a strip one metre wide, across the beams
  std::optional<double> strength;        // N/m, strength of the strip; none: elastic
};
/// gables: the non-bearing walls are built up as under a vault, without the vault. pitched: pairs of rafters that meet in the ridge, and
/// gables.
enum class RoofKind { none, flat, vault, gables, pitched };
struct Roof {
  RoofKind kind = RoofKind::none;
  std::array<double, 2> beam{0.2, 0.2};              // width along x, height, m (flat; pitched: of rafters)
  double element = 0.2;                              // m (flat, pitched)
  std::string between_beams = "normal";              // law between beams (flat) or in the ridge (pitched)
  std::optional<std::string> edge_beams;             // law between the first or last beam and its neighbour; none: between_beams (flat)
  std::optional<double> bearing;                     // m, length of a beam on a bearing wall; none: at most a brick's length (flat)
  double radius = 1.5, thickness = 0.2, ring = 0.2;  // m (vault; radius also gables)
  int voussoirs = 25;                                // of a ring (vault, gables)
  double surcharge = 0.0;                            // kg per m2 of the roof's upper surface (flat, vault, pitched)
  double pitch = 30.0;                               // degrees (pitched)
  double spacing = 0.8;                              // m, of the axes of rafters (pitched)
  std::optional<Tie> tie;                            // between the feet of a pair of rafters; none: the rafters thrust (pitched)
  std::optional<Deck> deck;                          // boards on the rafters (pitched)
};
/// Rods of a house, by wall and height (cases/house/house_ties.h).
enum class HouseTieKind { along, across, corner };
struct HouseTie {
  HouseTieKind kind = HouseTieKind::along;
  std::vector<std::string> walls;  // empty: all walls that are built
  std::vector<double> heights;     // m, above the foot of the walls
  std::vector<double> at;          // m, across: along the wall from the outer corner
  std::optional<double> depth;     // m, along: from the outer face of the wall; none: in the middle of the wall
  double reach = 0.0;              // m, corner: distance of the rod's ends from the outer corner, along both walls
  Tie bar;                         // properties of the rods; its ends are not used
};
/// Bars through the wall between nodes of a mesh on both faces.
struct MeshConnectors {
  int every = 2;                            // spacing in nodes, along and up
  double area = 0.0, young = 2.1e11;        // m2, Pa
  std::optional<double> yield, elongation;  // Pa, strain; none: elastic, never breaks
};
/// A grid of straps on the faces of a house's walls: a net, a mesh, or, over some courses only, a bandage.
enum class MeshFaces { both, outside, inside };
struct HouseMesh {
  std::string name;
  std::vector<std::string> walls;           // empty: all walls that are built
  double from = 0.0;                        // m, above the foot of the walls
  std::optional<double> to;                 // m; none: the top of the walls
  std::array<double, 2> spacing{0.2, 0.2};  // m, of the nodes along and up
  MeshFaces faces = MeshFaces::both;
  double stiffness = 0.0;            // N per m of width, force over strain
  std::optional<double> strength;    // N per m of width, at yield; none: elastic
  std::optional<double> elongation;  // strain at which it breaks; none: never
  std::optional<MeshConnectors> connectors;
};

/// Rods or straps that tie the ends of beams to the walls under them.
struct BeamAnchor {
  Tie bar;             // properties of the rods; ends and name are not used
  int every = 1;       // every n-th beam
  double reach = 0.3;  // m, from the wall into the room, where the rod holds the beam
};
/// friction: a beam lies in its pocket. nailed: a strap ties the beam to the bricks under its end. anchor: a rod to the outer face of the
/// wall.
enum class Anchorage { friction, nailed, anchor };
/// Beams in pockets of the walls, flush with the top of a storey, with or without a deck.
struct Floor {
  int storey = 1;
  PlanAxis along = PlanAxis::y;          // direction of the beams
  std::array<double, 2> beam{0.1, 0.2};  // width, height, m
  double spacing = 0.6;                  // m, between beam axes
  double bearing = 0.1;                  // m, depth of pockets in outer walls; pockets go through inner walls
  double element = 0.4;                  // m
  double load = 0.0;                     // kg/m2, mass of boards and imposed load
  std::string joint = "dry";             // law between beams and walls
  Anchorage anchorage = Anchorage::friction;
  std::optional<BeamAnchor> anchor;
  std::optional<Deck> deck;
};

/// inside: at the inner faces of the walls, flush with their top. middle: on the walls, over their middle; the roof lies on the ring beam.
enum class RingPlace { inside, middle };
struct Reinforcement {
  std::array<double, 2> column{0.1, 0.1}, ring_beam{0.1, 0.1};  // m
  std::vector<double> bearing, nonbearing;                      // column axes, m
  double element = 0.2;                                         // length of an element of a member, m
  RingPlace ring_beam_place = RingPlace::inside;
};
/// header: walls one brick length thick have headers only. flemish: walls of one or more brick lengths have a header beside each stretcher.
/// Other walls under header and flemish are in English bond. rubble: convex stones about the size of a brick (Rubble).
enum class Bond { english, running, header, flemish, rubble };
/// Stones of random size, in courses of random height, with inclined joints (walls/rubble.cpp).
struct Rubble {
  int seed = 1;
  double irregularity = 0.5;  // 0: rectangular stones of one size; 1: most irregular
  double through = 0.2;       // share of the stones that go through the wall
};
/// Stones through both leaves of a wall, a brick's width along it and a course high.
struct ThroughStones {
  double spacing = 1.0;                 // m, along the wall; stones of the next row lie midway
  int every = 4;                        // courses between rows
  std::optional<std::string> material;  // none: that of the bricks
};
/// Outer walls of two leaves, each in the house's bond, with a collar joint between the leaves.
struct Leaves {
  std::vector<std::string> walls;    // empty: all outer walls that are built
  std::optional<double> outer;       // m, thickness of the outer leaf; none: half of the wall
  std::optional<std::string> joint;  // law of the collar joint; none: law of the bricks
  std::optional<ThroughStones> through;
};
/// Ground higher than the foot of the house: a rectangle in axes of the house. Not a key; derived from Case::base (cases/solids/ground.h).
struct GroundStep {
  std::array<double, 2> x, y;  // m
  double level = 0.0;          // m
  bool only_walls = true;      // nothing but the house may lie on this ground
};
struct House {
  House();  // this and the next five are in compiled_once.cpp
  House(const House&);
  House(House&&) noexcept;
  House& operator=(const House&);
  House& operator=(House&&) noexcept;
  ~House();

  std::array<double, 2> inner_size{5.0, 3.0};  // m
  double height = 2.4;                         // m, of the first storey
  std::array<double, 3> brick{0.2, 0.1, 0.1};  // length, width, height, m
  double mortar = 0.0;                         // m, of bed and head joints; 0: included in the size of the brick
  Bond bond = Bond::english;
  std::optional<Rubble> rubble;  // none: default values
  std::string material = "adobe", joint = "normal";
  std::optional<Leaves> leaves;
  bool halves = false;                      // whole bricks are two cells each, cut at mid-length
  std::optional<std::array<int, 3>> cells;  // of whole bricks; materials.<name>.inside is the law between them
  HouseWood wood;
  std::array<double, 2> origin{0.0, 0.0};  // m
  double turn = 0.0;                       // degrees about z: 0, 90, 180, 270
  std::array<int, 2> copies{1, 1};
  std::array<double, 2> spacing{8.0, 6.0};                           // m
  double bearing_wall = 0.2, nonbearing_wall = 0.2;                  // m
  std::vector<std::string> walls{"front", "right", "rear", "left"};  // walls that are built
  Roof roof;
  std::vector<Storey> storeys;         // key: storey; storeys above the first
  std::vector<InnerWall> inner_walls;  // key: inner_wall
  std::vector<Pier> piers;             // key: pier
  std::vector<Floor> floors;           // key: floor
  std::vector<Opening> openings;       // key: opening
  std::optional<Reinforcement> reinforcement;
  std::vector<HouseTie> ties;      // key: tie
  std::vector<HouseMesh> meshes;   // key: mesh
  std::vector<GroundStep> ground;  // from Base::parts
};

}  // namespace voussoir::cases
