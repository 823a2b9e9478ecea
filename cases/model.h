// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/case.h"
#include "geometry/assembly.h"

/// From the description to bricks: every block with its material, and the law of any two that touch.
namespace voussoir::cases {

/// What a block is in a house; decides which law its joints get.
enum class PartKind : std::uint8_t { block, brick, lintel, beam, voussoir, column, ring_beam, floor_beam, walling, arch_stone };
/// What people call it: "brick", "ring beam".
const char* name(PartKind kind) noexcept;

/// One element to be, in the order of its element number.
struct Block {
  std::string name;            // of a free [[block]]; empty in houses
  std::string tag;             // "front wall", "roof beam 12", "lintel 0", ...; for output
  std::int32_t material = 0;   // into Model::materials
  geometry::Polyhedron shape;  // global axes, m
  double segment_size = 0.0;   // m
  PartKind kind = PartKind::block;
  std::int32_t house = -1;   // copy number of the house, −1: a free block
  std::int32_t member = -1;  // timber member in its house (elements of one beam share it), −1: none
  std::int32_t floor = -1;   // into House::floors, of a floor beam
  std::int32_t built = -1;   // its place in the order in which the house was built, −1: a free block
  std::int32_t leaf = -1;    // of a wall of two leaves: 2 * wall, + 1 for the inner leaf; -1: of none, or through both
  bool whole = true;         // false: a cut brick
  bool fixed = false, free = false;
  Vec3 velocity, angular_velocity;   // initial, m/s and rad/s
  std::int32_t support_motion = -1;  // into Model::support_motions
  std::int32_t given = -1;           // of Case::blocks; -1: of a house or of a file
  std::int32_t unit = -1;            // the two halves of a unit share it (of one house, or of Case::blocks); -1: in one piece
  std::int32_t ground = -1;          // of Base::parts; -1: no ground
  std::int32_t set = -1;             // of Case::stones; -1: of no file
  std::int32_t stone = -1;           // number of the stone in the model, the same for all its pieces; -1: of no file
  std::string part_of;               // name of the stone, if this is a piece of it
  std::vector<std::string> groups;   // of the file
  std::vector<std::int32_t> beds;    // faces that stand on a bed of mortar (StonesSpec::gap)
};

/// Displacement of a fixed block, or force of a load [N], as a function of time: piecewise linear, held after its end, 0 before t[0].
/// With two samples and `open_ended`, the last slope goes on for ever (constant velocity).
struct SupportHistory {
  std::vector<double> time;        // s, ascending
  std::vector<Vec3> displacement;  // m
  bool open_ended = false;
  std::string file;  // not empty: still to be read from here (t, x, y, z); relative to Case::folder
  std::string key;   // of the file in the case file, for messages
};

/// Of a history at a time [s]. \pre its file has been read
Vec3 value_at(const SupportHistory& h, double t);

struct NamedMaterial {
  std::string name;
  Material value;
  std::int32_t made_from = -1;  // the material whose joint and contact rules it has; −1: its own
  bool is_ground = false;       // of the parts of the ground: it has the rules of the base
};
struct NamedLaw {
  std::string name;  // "dry" is always law 0: no bond
  JointLaw value;
  std::int32_t made_from = -1;  // the law that it is with the mortar of a gap between stones; -1: its own
  bool never_breaks = false;    // within a stone in pieces
};

/// A share of the force of a tie's end: it acts on this element (geometry::kBase: the base) at a point that moves with it.
struct TieHold {
  std::int32_t element = 0;
  double share = 1.0;
  Vec3 point;  // m, at the start
};

/// A tie with its ends found; lengths and forces of the whole bar.
struct TieBar {
  std::string name;
  std::array<std::vector<TieHold>, 2> ends;  // the shares of an end sum to 1
  double length = 0.0;                       // m, between the ends as they stand
  double stiffness = 0.0;                    // N/m, E A / length
  double yield = 0.0;                        // N; infinite: elastic
  double hardening = 0.0;                    // N/m, of the yield force over the plastic elongation
  double breaking = 0.0;                     // m, elongation; infinite: never
  double pretension = 0.0;                   // N
  bool compression = false;
  std::int32_t mesh = -1;  // of House::meshes, beyond them the decks of House::floors and the roof's; −1: a tie by itself
};

/// What strengthening takes of material: all of a [[tie]], a [[house.tie]] or a [[house.mesh]].
struct TieBill {
  std::string name;
  std::int64_t ties = 0, anchors = 0;  // anchors: plates, and ends of connectors
  double length = 0.0;                 // m of rod
  double area = 0.0;                   // m2 of mesh
};

struct Model {
  std::vector<Block> blocks;
  std::vector<NamedMaterial> materials;
  std::vector<NamedLaw> laws;                   // laws[0] is "dry"
  std::vector<SupportHistory> support_motions;  // of fixed blocks, then of loads
  std::vector<std::int32_t> load_history;       // by load of the case, into support_motions; −1: none
  std::vector<std::vector<Stone>> stones;       // by table, as the case had them
  geometry::Assembly assembly;                  // of the blocks, in order
  std::vector<std::int32_t> joint_law;          // by assembly joint, into laws
  std::vector<double> contact_friction;         // degrees, see cases/rules/contact_rules.h
  std::vector<TieBar> ties;                     // those by themselves before those of meshes
  std::vector<TieBill> tie_bill;
  std::vector<double> joint_strength;  // by assembly joint, factor on f_t, c and f_m of its law (Case::scatter)
};

/// Builds blocks (house first, numbered along its plan, then free blocks, then stones), assembles them and picks the law of every joint.
/// A house stands on the base, so its walls begin at Case::base's height (0 without one, on fixed blocks).
/// Motions of supports given as files stay empty, with the file's name: io reads them.
/// Stones of files must be there (StonesSpec::stones): io reads them.
/// The law: the first that applies of materials.<name>.inside (pieces of one stone, halves of one unit), the house's own keys,
/// stones.joint, joints.between, joints.default; between two beds of stones.gap it has mortar of that thickness.
/// \param threads  that work on it; the model is the same for any number
/// \throw InputError with the key at fault; faults of geometry are reported by the name or tag of the block.
Model build_model(const Case& c, int threads = 1);

/// The element whose centroid is nearest to `point` [m, global]; the lowest number among those equally near (to 1 nm).
/// \pre the model has an element
std::int32_t nearest_element(const Model& model, Vec3 point) noexcept;

/// What has this name, each as its elements: a block (both halves of one that is cut), a half of one, a stone (all its pieces), a piece of
/// one, or all stones of a group. Empty: nothing has it.
std::vector<std::vector<std::int32_t>> parts_named(const Model& model, const std::string& name);

/// How a message calls an element: `front wall (element 12)`, with the house if there are several; `block "slider" (element 3)`.
std::string describe(const Block& block, std::size_t element);

}  // namespace voussoir::cases
